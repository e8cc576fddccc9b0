// The fields of a light rig in the Environment dock: its elements, where each is, how large and how bright.
#pragma once

#include <QWidget>
#include <functional>

#include "core/light_rig/light_rig.h"
#include "ui/rows/value_editor.h"

class QLabel;
class QPushButton;

namespace dermis {

class GroupBox;
class PropertyRow;
class QuietComboBox;
class RigEdit;

class RigBox : public QWidget {
  Q_OBJECT
 public:
  explicit RigBox(QWidget* parent = nullptr);
  /// To be called once.
  void setEdit(RigEdit& edit);

 Q_SIGNALS:
  void saveRequested();

 private:
  using Change = std::function<RigElement(const RigElement&, float)>;
  PropertyRow* addRow(const QString& label, const char* id, const NumberRange& range, Change change);
  void refresh();
  void showElement(const RigElement& element);
  /// What a reset returns to: the element in the rig that this one came from.
  void showDefaults(const RigElement& before);

  RigEdit* m_edit = nullptr;
  GroupBox* m_group = nullptr;
  QuietComboBox* m_elements = nullptr;
  QLabel* m_state = nullptr;
  QPushButton* m_save = nullptr;
  PropertyRow* m_on = nullptr;
  PropertyRow* m_azimuth = nullptr;
  PropertyRow* m_elevation = nullptr;
  PropertyRow* m_width = nullptr;
  PropertyRow* m_height = nullptr;
  PropertyRow* m_amount = nullptr;
};

}  // namespace dermis
