// The Camera & view dock: lens, ready-made views, display transform, exposure, and which image of the frame is shown.
#pragma once

#include <vector>

#include "renderer.h"
#include "ui/docks/panel.h"

class QComboBox;
class QLabel;

namespace dermis {

class BookmarksBox;
class Document;
class PropertyRow;

class CameraPanel : public Panel {
  Q_OBJECT
 public:
  explicit CameraPanel(Document& document, QWidget* parent = nullptr);
  void showAov(Aov aov);
  [[nodiscard]] BookmarksBox* bookmarks() const { return m_bookmarks; }

 Q_SIGNALS:
  void viewRequested(const QString& namedCamera);
  void aovChosen(dermis::Aov aov);
  void problem(const QString& sentence);

 private:
  void buildLens();
  void buildViews();
  void buildDisplay();
  void refresh();

  Document& m_document;
  BookmarksBox* m_bookmarks = nullptr;
  PropertyRow* m_orthographic = nullptr;
  PropertyRow* m_fov = nullptr;
  PropertyRow* m_height = nullptr;
  PropertyRow* m_exposure = nullptr;
  QComboBox* m_transform = nullptr;
  QComboBox* m_display = nullptr;
  QComboBox* m_aov = nullptr;
};

}  // namespace dermis
