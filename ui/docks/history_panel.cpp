#include "ui/docks/history_panel.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QUndoStack>
#include <QUndoView>
#include <QVBoxLayout>

#include "ui/docks/panel.h"
#include "ui/theme/metrics.h"
#include "ui/theme/strips.h"

namespace dermis {
namespace {

/// Row r is the state after r steps: later ones are undone and pale, the saved one says so.
class StateDelegate : public QStyledItemDelegate {
 public:
  StateDelegate(const QUndoStack& stack, QObject* parent) : QStyledItemDelegate(parent), m_stack(stack) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem styled = option;
    if (index.row() > m_stack.index()) {
      styled.palette.setColor(QPalette::Text, option.palette.color(QPalette::Disabled, QPalette::Text));
      styled.font.setItalic(true);
    }
    if (index.row() == m_stack.index()) styled.font.setWeight(QFont::DemiBold);
    const bool saved = index.row() == m_stack.cleanIndex();
    const QString word = HistoryPanel::tr("saved");
    const int room = saved ? QFontMetrics(option.font).horizontalAdvance(word) + 2 * metrics::kGap : 0;
    styled.rect.adjust(0, 0, -room, 0);
    QStyledItemDelegate::paint(painter, styled, index);
    if (!saved) return;
    painter->save();
    painter->setPen(option.palette.color(QPalette::PlaceholderText));
    painter->drawText(option.rect.adjusted(0, 0, -metrics::kGap, 0), Qt::AlignRight | Qt::AlignVCenter, word);
    painter->setPen(option.palette.color(QPalette::Mid));
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    painter->restore();
  }

 private:
  const QUndoStack& m_stack;
};

}  // namespace

HistoryPanel::HistoryPanel(QUndoStack& stack, QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_StyledBackground);  // the panel's grey, as for its neighbours
  QVBoxLayout* column = flushColumn(this);
  QFrame* strip = toolStrip(this);
  auto* head = new QHBoxLayout(strip);
  head->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kGap, metrics::kGap);
  auto* state = new QLabel(strip);
  state->setObjectName(QStringLiteral("history.state"));
  state->setProperty("quiet", true);
  auto* undo = iconButton("undo", tr("Undo"), strip);
  undo->setObjectName(QStringLiteral("history.undo"));
  auto* redo = iconButton("redo", tr("Redo"), strip);
  redo->setObjectName(QStringLiteral("history.redo"));
  head->addWidget(state, 1);
  head->addWidget(undo);
  head->addWidget(redo);
  column->addWidget(strip);
  auto* list = new QUndoView(&stack, this);
  list->setObjectName(QStringLiteral("history.list"));
  list->setAccessibleName(tr("History"));
  list->setToolTip(tr("Click a state to go back or forward to it"));
  list->setEmptyLabel(tr("As it was opened"));
  list->setItemDelegate(new StateDelegate(stack, list));
  column->addWidget(list, 1);
  connect(undo, &QToolButton::clicked, &stack, &QUndoStack::undo);
  connect(redo, &QToolButton::clicked, &stack, &QUndoStack::redo);
  const auto refresh = [&stack, state, undo, redo, list] {
    undo->setEnabled(stack.canUndo());
    redo->setEnabled(stack.canRedo());
    const int clean = stack.cleanIndex();
    const int steps = std::abs(stack.index() - clean);
    state->setText(clean < 0               ? tr("Not saved")
                   : steps == 0            ? tr("As saved")
                   : stack.index() > clean ? tr("%n step(s) after the saved state", nullptr, steps)
                                           : tr("%n step(s) before the saved state", nullptr, steps));
    list->viewport()->update();
  };
  connect(&stack, &QUndoStack::indexChanged, this, refresh);
  connect(&stack, &QUndoStack::cleanChanged, this, refresh);
  refresh();
}

}  // namespace dermis
