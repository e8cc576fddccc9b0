// Asks for the size, samples and file of a picture to be saved.
#pragma once

#include <QDialog>

#include "ui/jobs/picture_job.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace dermis {

class ScreenshotDialog : public QDialog {
  Q_OBJECT
 public:
  /// `viewport`: the size offered as the window's own.
  ScreenshotDialog(const glm::ivec2& viewport, const QString& view, const ReferenceObjects& references,
                   QWidget* parent);
  /// Its path is empty where the picture goes to the clipboard.
  [[nodiscard]] PictureRequest request() const;
  /// Asks before a picture that is there is written over.
  void accept() override;

 private:
  void choosePreset(int index);
  void chooseFile();
  void refresh();
  void buildChoices(QFormLayout* form, const QString& view, const ReferenceObjects& references);

  glm::ivec2 m_viewport{0};
  bool m_toClipboard = false;
  QString m_agreed;  ///< a file that may be written over: its own dialog has asked
  QComboBox* m_kind = nullptr;
  QSpinBox* m_frames = nullptr;
  QComboBox* m_view = nullptr;
  QCheckBox* m_references = nullptr;
  ReferenceObjects m_shownReferences;
  QPushButton* m_copy = nullptr;
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
