// A slot's material taken by hand to another slot: what it is dragged by, and a list to drop it on.
#pragma once

#include <QLabel>
#include <QListWidget>
#include <QTimer>

class QMimeData;

namespace dermis {

class Document;

/// The slot whose material is dragged; empty where it is something else.
[[nodiscard]] QString draggedSlot(const QMimeData* data);

/// The label that names what the current slot wears: dragging it takes the material along.
class SlotHandle : public QLabel {
  Q_OBJECT
 public:
  SlotHandle(Document& document, QWidget* parent);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  Document& m_document;
  QPoint m_pressedAt;
};

/// The slots, each a place to drop a preset or another slot's material on. It is there only while something is dragged.
class SlotDropList : public QListWidget {
  Q_OBJECT
 public:
  explicit SlotDropList(QWidget* parent);
  void offer(const QStringList& slots_, const QString& current);
  /// Unless the drag comes to it by then: it is on its way.
  void hideSoon() { m_gone.start(); }

 Q_SIGNALS:
  void dropped(const QMimeData* data, const QString& slot);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QTimer m_gone;
};

}  // namespace dermis
