// The keys that fly while the right button is held, as a person has set them.
#pragma once

#include <QKeyEvent>
#include <QList>
#include <QObject>
#include <QSet>
#include <glm/glm.hpp>

class QAction;

namespace dermis {

class FlyKeys : public QObject {
  Q_OBJECT
 public:
  explicit FlyKeys(QObject* parent);
  /// Whether the key is one of them; it counts as held from then on.
  bool press(const QKeyEvent& event);
  bool release(const QKeyEvent& event) { return m_held.remove(event.key()); }
  void clear() { m_held.clear(); }
  [[nodiscard]] bool any() const { return !m_held.isEmpty(); }
  /// Along the camera's own right, up and forward.
  [[nodiscard]] glm::vec3 direction() const;

 private:
  [[nodiscard]] static int keyOf(const QAction& action);
  QList<QAction*> m_actions;  ///< right, left, up, down, forward, back; of no widget: only their shortcuts are of use
  QSet<int> m_held;
};

}  // namespace dermis
