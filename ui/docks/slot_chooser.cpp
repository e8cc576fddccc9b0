#include "ui/docks/slot_chooser.h"

#include <QAction>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include "ui/browse/preset_list.h"
#include "ui/docks/slot_drag.h"
#include "ui/document/document.h"
#include "ui/rows/choice_editors.h"
#include "ui/theme/metrics.h"

namespace dermis {

SlotChooser::SlotChooser(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(metrics::kGap);
  auto* row = new QHBoxLayout();
  row->setSpacing(metrics::kGap);
  column->addLayout(row);
  m_drop = new SlotDropList(this);
  column->addWidget(m_drop);
  m_slot = new QuietComboBox(this);
  m_slot->setObjectName(QStringLiteral("material.slot"));
  m_slot->setAccessibleName(tr("Material slot"));
  m_slot->setToolTip(
      tr("The part of the model whose material is shown; a preset dragged here goes to it, or to another slot of "
         "the list that comes up"));
  m_slot->setAcceptDrops(true);
  m_slot->installEventFilter(this);
  m_together = new QToolButton(this);
  m_together->setObjectName(QStringLiteral("material.together"));
  m_together->setAccessibleName(tr("Edit several slots together"));
  m_together->setToolTip(tr("Edit several slots together: a change goes to all that are ticked, as one undo step"));
  m_together->setPopupMode(QToolButton::InstantPopup);
  m_together->setFocusPolicy(Qt::StrongFocus);
  m_together->setProperty("textButton", true);
  row->addWidget(m_slot, 1);
  row->addWidget(m_together);
  setFocusProxy(m_slot);

  m_menu = new QMenu(m_together);
  m_menu->setAccessibleName(tr("Slots edited together"));
  auto* holder = new QWidgetAction(m_menu);
  m_list = new QListWidget(m_menu);
  m_list->setObjectName(QStringLiteral("material.together.list"));
  m_list->setAccessibleName(tr("Slots edited together"));
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setMinimumWidth(200);
  holder->setDefaultWidget(m_list);
  m_menu->addAction(holder);
  m_menu->addSeparator();
  QAction* all = m_menu->addAction(tr("All slots"));
  QAction* one = m_menu->addAction(tr("Only the one shown"));
  all->setObjectName(QStringLiteral("material.together.all"));
  one->setObjectName(QStringLiteral("material.together.one"));
  m_together->setMenu(m_menu);

  connect(m_drop, &SlotDropList::dropped, this,
          [this](const QMimeData* data, const QString& slot) { take(data, {slot}); });
  connect(m_slot, &QComboBox::textActivated, &m_document, &Document::setCurrentSlot);
  connect(m_list, &QListWidget::itemChanged, this, &SlotChooser::takeChecked);
  connect(all, &QAction::triggered, this, [this] { m_document.setEditedSlots(m_document.slotNames()); });
  connect(one, &QAction::triggered, this, [this] { m_document.setEditedSlots({}); });
  refresh();
}

bool SlotChooser::takes(const QMimeData* data) {
  return !draggedPreset(data).isEmpty() || !draggedSlot(data).isEmpty();
}

void SlotChooser::take(const QMimeData* data, const QStringList& slots_) {
  if (const QString preset = draggedPreset(data); !preset.isEmpty())
    Q_EMIT presetDropped(preset, slots_);
  else
    m_document.dressAs(draggedSlot(data), slots_);
}

bool SlotChooser::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::DragLeave) m_drop->hideSoon();
  if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove || event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    if (takes(drop->mimeData())) {
      drop->acceptProposedAction();
      if (event->type() == QEvent::DragEnter && m_slot->count() > 1)
        m_drop->offer(m_document.slotNames(), m_document.currentSlot());
      if (event->type() == QEvent::Drop) {
        m_drop->hide();
        take(drop->mimeData(), m_document.editedSlots());
      }
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void SlotChooser::takeChecked() {
  QStringList chosen;
  for (int i = 0; i < m_list->count(); ++i)
    if (m_list->item(i)->checkState() == Qt::Checked) chosen << m_list->item(i)->text();
  m_document.setEditedSlots(chosen);
  refresh();
}

void SlotChooser::refresh() {
  const QSignalBlocker blockers[] = {QSignalBlocker(m_slot), QSignalBlocker(m_list)};
  const QStringList names = m_document.slotNames();
  QStringList shown;
  for (int i = 0; i < m_slot->count(); ++i) shown << m_slot->itemText(i);
  if (shown != names) {
    m_slot->clear();
    m_slot->addItems(names);
    m_list->clear();
    m_list->addItems(names);
    m_list->setFixedHeight(8 + 28 * static_cast<int>(std::clamp<qsizetype>(names.size(), 1, 12)));
  }
  m_slot->setCurrentIndex(static_cast<int>(names.indexOf(m_document.currentSlot())));
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem* item = m_list->item(i);
    const bool current = item->text() == m_document.currentSlot();
    item->setCheckState(m_document.editedSlots().contains(item->text()) ? Qt::Checked : Qt::Unchecked);
    // The slot that is shown is always edited.
    item->setFlags(current ? Qt::ItemIsSelectable : Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
  }
  const qsizetype count = m_document.editedSlots().size();
  m_together->setText(count > 1 ? tr("%n slot(s) together", nullptr, static_cast<int>(count)) : tr("Together…"));
  m_together->setVisible(names.size() > 1);
}

}  // namespace dermis
