// The Environment dock: the lights of the surroundings, and how they are turned, exposed and seen.
#pragma once

#include <functional>

#include "core/scene/scene.h"
#include "ui/docks/panel.h"

namespace dermis {

class Document;
class EnvironmentList;
class Loading;
class Preferences;
class PropertyRow;
class RigBox;

class EnvironmentPanel : public Panel {
  Q_OBJECT
 public:
  EnvironmentPanel(Document& document, Loading& loading, Preferences& preferences, QWidget* parent = nullptr);

  [[nodiscard]] RigBox* rigBox() { return m_rig; }

 Q_SIGNALS:
  void chooseFileRequested();

 private:
  void buildList(Preferences& preferences);
  void buildRows();
  void refresh();
  void edit(const QString& what, quint64 gesture, const std::function<void(EnvironmentSource&)>& change);

  Document& m_document;
  Loading& m_loading;
  EnvironmentList* m_list = nullptr;
  RigBox* m_rig = nullptr;
  PropertyRow* m_rotation = nullptr;
  PropertyRow* m_exposure = nullptr;
  PropertyRow* m_background = nullptr;
  PropertyRow* m_blur = nullptr;
  PropertyRow* m_color = nullptr;
};

}  // namespace dermis
