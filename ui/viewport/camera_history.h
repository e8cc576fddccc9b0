// Where the camera has been: back and forward, apart from undo.
#pragma once

#include <QList>
#include <QObject>
#include <QTimer>
#include <memory>

#include "core/scene/scene.h"

namespace dermis {

class Document;
class Viewport;
struct Model;

class CameraHistory : public QObject {
  Q_OBJECT
 public:
  CameraHistory(Document& document, Viewport& viewport);
  void back() { go(m_place - 1); }
  void forward() { go(m_place + 1); }
  [[nodiscard]] bool canGoBack() const { return m_place > 0; }
  [[nodiscard]] bool canGoForward() const { return m_place + 1 < m_places.size(); }
  /// Remembers where the camera is now; gestures and bookmarks tell.
  void note();

 Q_SIGNALS:
  void changed();

 private:
  void go(qsizetype place);

  Document& m_document;
  std::shared_ptr<const Model> m_model;  ///< beside which the places are
  QList<Camera> m_places;
  qsizetype m_place = -1;
  QTimer m_pause;  ///< wheel ticks that follow each other are one move
};

}  // namespace dermis
