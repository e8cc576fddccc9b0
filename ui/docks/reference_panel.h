// The Reference dock: which photograph, where it is shown, and how.
#pragma once

#include "ui/docks/panel.h"
#include "ui/viewport/reference_photo.h"

class QComboBox;
class QLabel;

namespace dermis {

class PropertyRow;

class ReferencePanel : public Panel {
  Q_OBJECT
 public:
  explicit ReferencePanel(ReferencePhoto& photo, QWidget* parent = nullptr);
  /// Shows it over the picture, unless it is beside it already.
  void choose(const QString& path);

 private:
  PropertyRow* addNumber(GroupBox* group, const QString& label, const char* id, double lowest, double highest,
                         double softLowest, double softHighest, double ReferencePhoto::Settings::*member);
  void refresh();

  ReferencePhoto& m_photo;
  QLabel* m_name = nullptr;
  QComboBox* m_place = nullptr;
  PropertyRow* m_opacity = nullptr;
  PropertyRow* m_wipe = nullptr;
  PropertyRow* m_scale = nullptr;
  PropertyRow* m_x = nullptr;
  PropertyRow* m_y = nullptr;
};

}  // namespace dermis
