#include "ui/rows/property_row.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <algorithm>

#include "ui/theme/metrics.h"

namespace dermis {
namespace {

/// The value last copied from any row; pasting needs the same type.
std::optional<ParameterValue>& copiedValue() {
  static std::optional<ParameterValue> s_copied;
  return s_copied;
}

}  // namespace

PropertyRow::PropertyRow(const QString& group, const QString& label, const QString& id, ValueEditor* editor,
                         QWidget* parent)
    : QWidget(parent), m_path(group.isEmpty() ? label : group + QStringLiteral(" › ") + label), m_editor(editor) {
  setObjectName(id);
  setAccessibleName(m_path);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(0);
  grid->setVerticalSpacing(2);
  m_dot = new QLabel(this);
  m_dot->setFixedSize(metrics::kDotWidth, metrics::kControlHeight);
  m_dot->setProperty("dot", true);
  m_label = new QLabel(label, this);
  m_label->setFixedHeight(metrics::kControlHeight);
  m_label->setBuddy(editor);
  m_label->installEventFilter(this);
  grid->addWidget(m_dot, 0, 0, Qt::AlignTop);
  grid->addWidget(m_label, 0, 1, Qt::AlignTop);
  editor->setParent(this);
  if (editor->wide()) {
    grid->addWidget(editor, 1, 1, 1, 2);
  } else {
    m_label->setFixedWidth(metrics::kLabelWidth);
    grid->addWidget(editor, 0, 2);
  }
  grid->setColumnStretch(2, 1);
  editor->nameControls(m_path, id);
  connect(editor, &ValueEditor::edited, this, &PropertyRow::edited);
}

void PropertyRow::showValue(const ParameterValue& value) {
  m_value = value;
  m_editor->showValue(value);
  refreshDot();
}

void PropertyRow::setDefault(const ParameterValue& value) {
  m_default = value;
  m_editor->showDefault(value);
  refreshDot();
}

void PropertyRow::setHelp(const QString& sentence) {
  m_label->setToolTip(sentence);
  m_editor->setWhatsThis(sentence);
  setAccessibleDescription(sentence);
}

bool PropertyRow::isModified() const { return m_value && m_default && !(*m_value == *m_default); }

bool PropertyRow::matches(const QString& words) const {
  const QStringList parts = words.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  return std::all_of(parts.begin(), parts.end(), [this](const QString& part) {
    return m_path.contains(part, Qt::CaseInsensitive) || objectName().contains(part, Qt::CaseInsensitive);
  });
}

void PropertyRow::reset() {
  if (isModified()) Q_EMIT edited(*m_default, newGesture());
}

void PropertyRow::refreshDot() {
  const bool modified = isModified();
  m_dot->setText(modified ? QStringLiteral("•") : QString());
  m_dot->setToolTip(modified ? tr("Differs from the default") : QString());
}

bool PropertyRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_label && event->type() == QEvent::MouseButtonDblClick) {
    reset();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void PropertyRow::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  QAction* resetAction = menu.addAction(tr("Reset to default"));
  resetAction->setEnabled(isModified());
  menu.addSeparator();
  QAction* copyAction = menu.addAction(tr("Copy value"));
  QAction* pasteAction = menu.addAction(tr("Paste value"));
  const std::optional<ParameterValue>& copied = copiedValue();
  pasteAction->setEnabled(copied && m_value && copied->index() == m_value->index());
  const QAction* chosen = menu.exec(event->globalPos());
  if (chosen == resetAction) reset();
  if (chosen == copyAction) copiedValue() = m_value;
  if (chosen == pasteAction && copied) Q_EMIT edited(*copied, newGesture());
}

}  // namespace dermis
