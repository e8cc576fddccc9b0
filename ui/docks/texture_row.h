// One map of the material: thumbnail, what it is, how it is read; takes dropped files.
#pragma once

#include <QFrame>
#include <functional>
#include <memory>

#include "core/image/image.h"
#include "core/material/texture_slot.h"
#include "ui/document/map_watcher.h"
#include "ui/rows/gesture.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace dermis {

class ElidedLabel;
class NumberField;

/// One field of a binding gets another value; the others stay as they are, on each slot that is edited.
using BindingChange = std::function<void(TextureBinding&)>;

class TextureRow : public QFrame {
  Q_OBJECT
 public:
  explicit TextureRow(const TextureSlotRow& slot, QWidget* parent = nullptr);
  void showBinding(const TextureBinding& binding, const std::shared_ptr<const Image>& image, MapWatcher::State state);

 Q_SIGNALS:
  /// One file, several, or a folder.
  void dropped(const QStringList& paths);
  void locateRequested();
  void chooseRequested();
  void clearRequested();
  void reloadRequested();
  void bindingEdited(const dermis::BindingChange& change, dermis::Gesture gesture);

 protected:
  bool event(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void buildHead();
  void buildDetails();
  void drawThumbnail();
  void markDrop(bool active);
  void reveal();

  const TextureSlotRow& m_slot;
  TextureBinding m_binding;
  std::shared_ptr<const Image> m_image;
  QLabel* m_thumbnail = nullptr;
  ElidedLabel* m_file = nullptr;
  QLabel* m_size = nullptr;
  QPushButton* m_locate = nullptr;
  QToolButton* m_clear = nullptr;
  QToolButton* m_reload = nullptr;
  QWidget* m_details = nullptr;
  QComboBox* m_channel = nullptr;
  QComboBox* m_space = nullptr;
  QCheckBox* m_invert = nullptr;
  QCheckBox* m_flip = nullptr;
  NumberField* m_scale = nullptr;
  NumberField* m_tiling = nullptr;
};

}  // namespace dermis
