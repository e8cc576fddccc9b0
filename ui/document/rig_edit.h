// The light rig that lights the scene, as something to edit: a built-in one or a file becomes the scene's own at the
// first change, and what it gives as light follows beside the event loop, coarsely while a hand is at it.
#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>

#include "core/light_rig/light_rig.h"
#include "ui/document/sections.h"
#include "ui/rows/gesture.h"

namespace dermis {

class Document;
class TaskRunner;

class RigEdit : public QObject {
  Q_OBJECT
 public:
  RigEdit(Document& document, TaskRunner& tasks, QObject* parent = nullptr);

  /// Null where an image or a constant lights the scene.
  [[nodiscard]] const LightRig* rig() const { return m_rig ? &*m_rig : nullptr; }
  /// The element as it was in the rig that this one came from; null where it has none.
  [[nodiscard]] const RigElement* original(std::size_t index) const;
  /// Whether the scene keeps it: nothing else has it.
  [[nodiscard]] bool isOwn() const;
  [[nodiscard]] float rotationDegrees() const;

  /// One undo entry a gesture; back at the gesture's start there is none.
  void setElement(std::size_t index, const RigElement& element, const QString& text, Gesture gesture);
  /// While a hand drags: the light is made coarsely, and wholly when it lets go.
  void setDragging(bool dragging);
  /// The picture is being made ready for what it was given last.
  void setPictureBusy(bool busy);

  [[nodiscard]] int selected() const { return m_selected; }
  void select(int element);

 Q_SIGNALS:
  /// Another rig, or another value of it.
  void changed();
  void selectionChanged(int element);

 private:
  void follow();
  void bake();
  [[nodiscard]] bool lightIsCurrent() const;

  Document& m_document;
  TaskRunner& m_tasks;
  std::optional<LightRig> m_rig;
  std::optional<LightRig> m_original;  ///< what it was before it became the scene's own
  EnvironmentSource m_of;              ///< what m_rig was read from
  /// What the images that have been seen are the light of.
  std::map<std::weak_ptr<const EnvironmentImages>, EnvironmentSource, std::owner_less<>> m_known;
  bool m_dragging = false, m_baking = false, m_bakingCoarse = false;
  EnvironmentSource m_bakingFor;
  bool m_pictureBusy = false;
  QTimer m_soon;  ///< the picture may never say that it is ready: it is hidden, or there is none
  int m_selected = -1;
  Gesture m_gesture = 0;
  LightRig m_startRig;
  EnvironmentLook m_start;  ///< before the gesture
};

}  // namespace dermis
