// One map of the material: thumbnail, what it is, how it is read; takes a dropped file.
#pragma once

#include <QFrame>
#include <memory>

#include "core/image/image.h"
#include "core/material/texture_slot.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace dermis {

class NumberField;

class TextureRow : public QFrame {
  Q_OBJECT
 public:
  explicit TextureRow(const TextureSlotRow& slot, QWidget* parent = nullptr);
  void showBinding(const TextureBinding& binding, const std::shared_ptr<const Image>& image);

 Q_SIGNALS:
  void fileChosen(const QString& path);
  void chooseRequested();
  void clearRequested();
  void reloadRequested();
  void bindingEdited(const dermis::TextureBinding& binding, quint64 gesture);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void buildHead();
  void buildDetails();
  void markDrop(bool active);

  const TextureSlotRow& m_slot;
  TextureBinding m_binding;
  std::shared_ptr<const Image> m_image;
  QLabel* m_thumbnail = nullptr;
  QLabel* m_file = nullptr;
  QLabel* m_size = nullptr;
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
