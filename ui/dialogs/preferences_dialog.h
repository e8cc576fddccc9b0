// Edit › Preferences: one page, used at once when it is accepted.
#pragma once

#include <QDialog>

#include "ui/preferences/preferences.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace dermis {

class FolderList;

class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PreferencesDialog(Preferences& preferences, QWidget* parent = nullptr);
  [[nodiscard]] PreferenceValues values() const;
  void show(const PreferenceValues& values);

 private:
  void buildForm(QFormLayout* form);
  QComboBox* choice(const QString& name, const QString& label, const QString& help, const QStringList& words);
  QSpinBox* number(const QString& name, const QString& label, const QString& help, int lowest, int highest,
                   const QString& unit);

  QComboBox* m_theme = nullptr;
  QComboBox* m_scale = nullptr;
  QComboBox* m_unit = nullptr;
  QSpinBox* m_autosave = nullptr;
  QSpinBox* m_cache = nullptr;
  QSpinBox* m_samples = nullptr;
  QCheckBox* m_statistics = nullptr;
  FolderList* m_presets = nullptr;
  FolderList* m_environments = nullptr;
  QFormLayout* m_form = nullptr;
};

}  // namespace dermis
