// Asks for the size, samples and file of a picture to be saved.
#pragma once

#include <QDialog>

#include "ui/jobs/picture_job.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace dermis {

class ScreenshotDialog : public QDialog {
  Q_OBJECT
 public:
  /// `viewport`: the size offered as the window's own.
  ScreenshotDialog(const glm::ivec2& viewport, const QString& view, QWidget* parent);
  [[nodiscard]] PictureRequest request() const;

 private:
  void choosePreset(int index);
  void chooseFile();
  void refresh();

  glm::ivec2 m_viewport{0};
  QComboBox* m_preset = nullptr;
  QSpinBox* m_width = nullptr;
  QSpinBox* m_height = nullptr;
  QSpinBox* m_samples = nullptr;
  QCheckBox* m_transparent = nullptr;
  QCheckBox* m_layers = nullptr;
  QLineEdit* m_path = nullptr;
  QPushButton* m_save = nullptr;
};

}  // namespace dermis
