#include "ui/viewport/camera_history.h"

#include <utility>

#include "ui/document/carry_over.h"
#include "ui/document/document.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {
constexpr qsizetype kMostPlaces = 200;
constexpr int kPauseMs = 400;
}  // namespace

CameraHistory::CameraHistory(Document& document, Viewport& viewport) : QObject(&viewport), m_document(document) {
  m_pause.setSingleShot(true);
  m_pause.setInterval(kPauseMs);
  connect(&m_pause, &QTimer::timeout, this, &CameraHistory::note);
  connect(&viewport, &Viewport::cameraGestureEnded, &m_pause, qOverload<>(&QTimer::start));
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what != Change::Everything) return;
    const std::shared_ptr<const Model> before = std::exchange(m_model, m_document.model());
    // Another scene: the way back leads nowhere. Its first camera is known once whoever frames it has done so.
    if (m_document.undoStack().count() == 0) {
      m_places.clear();
      m_place = -1;
      m_pause.start();
    } else if (before && m_model && before != m_model) {
      // Another model in the same scene: the places come along as lights and camera do, and back again with an undo.
      const CarriedOver place(*before, *m_model);
      for (Camera& camera : m_places) camera = place(camera);
    }
  });
}

void CameraHistory::note() {
  m_pause.stop();
  if (!m_document.isReady()) return;
  if (m_place >= 0 && m_places[m_place] == m_document.camera()) return;
  m_places.resize(m_place + 1);
  m_places << m_document.camera();
  if (m_places.size() > kMostPlaces) m_places.removeFirst();
  m_place = m_places.size() - 1;
  Q_EMIT changed();
}

void CameraHistory::go(qsizetype place) {
  if (m_pause.isActive()) {
    // A move that has not been noted yet is the newest place, and going back leaves it.
    const bool back = place < m_place;
    note();
    place = back ? m_place - 1 : m_place + 1;
  }
  if (place < 0 || place >= m_places.size()) return;
  m_place = place;
  m_document.setCamera(m_places[place]);
  Q_EMIT changed();
}

}  // namespace dermis
