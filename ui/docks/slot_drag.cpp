#include "ui/docks/slot_drag.h"

#include <QApplication>
#include <QDrag>
#include <QDropEvent>
#include <QMimeData>
#include <algorithm>

#include "ui/document/document.h"

namespace dermis {
namespace {
const QString kMime = QStringLiteral("application/x-dermis-slot");
}  // namespace

QString draggedSlot(const QMimeData* data) { return QString::fromUtf8(data->data(kMime)); }

SlotHandle::SlotHandle(Document& document, QWidget* parent) : QLabel(parent), m_document(document) {
  setCursor(Qt::OpenHandCursor);
}

void SlotHandle::mousePressEvent(QMouseEvent* event) { m_pressedAt = event->pos(); }

void SlotHandle::mouseMoveEvent(QMouseEvent* event) {
  const bool far = (event->pos() - m_pressedAt).manhattanLength() >= QApplication::startDragDistance();
  if (!(event->buttons() & Qt::LeftButton) || !far || m_document.currentLook() == nullptr) return;
  auto* data = new QMimeData();
  data->setData(kMime, m_document.currentSlot().toUtf8());
  auto* drag = new QDrag(this);
  drag->setMimeData(data);
  drag->exec(Qt::CopyAction);
}

SlotDropList::SlotDropList(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("material.drop"));
  setAccessibleName(tr("Drop on a slot"));
  setAcceptDrops(true);
  setDragDropMode(QAbstractItemView::DropOnly);
  m_gone.setSingleShot(true);
  m_gone.setInterval(400);
  connect(&m_gone, &QTimer::timeout, this, &QWidget::hide);
  hide();
}

void SlotDropList::offer(const QStringList& slots_, const QString& current) {
  m_gone.stop();
  clear();
  addItems(slots_);
  setCurrentRow(static_cast<int>(slots_.indexOf(current)));
  const int line = std::max(sizeHintForRow(0), 1);
  setFixedHeight(2 * frameWidth() + line * static_cast<int>(std::clamp<qsizetype>(slots_.size(), 1, 8)));
  show();
}

void SlotDropList::dragEnterEvent(QDragEnterEvent* event) {
  m_gone.stop();
  event->acceptProposedAction();
}

void SlotDropList::dragMoveEvent(QDragMoveEvent* event) {
  QListWidgetItem* item = itemAt(event->position().toPoint());
  event->setAccepted(item != nullptr);
  if (item != nullptr) setCurrentItem(item);
}

void SlotDropList::dragLeaveEvent(QDragLeaveEvent*) { hideSoon(); }

void SlotDropList::dropEvent(QDropEvent* event) {
  if (const QListWidgetItem* item = itemAt(event->position().toPoint())) {
    event->acceptProposedAction();
    Q_EMIT dropped(event->mimeData(), item->text());
  }
  hide();
}

}  // namespace dermis
