#include "ui/viewport/fly_keys.h"

#include <QAction>
#include <algorithm>

#include "ui/preferences/shortcuts.h"

namespace dermis {

FlyKeys::FlyKeys(QObject* parent) : QObject(parent) {
  const auto add = [this](const char* id, const QString& label, Qt::Key key) {
    auto* action = new QAction(label, this);
    action->setObjectName(QLatin1String(id));
    action->setShortcut(QKeySequence(key));
    Shortcuts::list(action, tr("While the right button is held in the picture"), true);
    m_actions << action;
  };
  add("fly.right", tr("Fly to the right"), Qt::Key_D);
  add("fly.left", tr("Fly to the left"), Qt::Key_A);
  add("fly.up", tr("Fly up"), Qt::Key_E);
  add("fly.down", tr("Fly down"), Qt::Key_Q);
  add("fly.forward", tr("Fly forward"), Qt::Key_W);
  add("fly.back", tr("Fly back"), Qt::Key_S);
}

int FlyKeys::keyOf(const QAction& action) { return action.shortcut().isEmpty() ? -1 : action.shortcut()[0].key(); }

bool FlyKeys::press(const QKeyEvent& event) {
  if (!std::ranges::any_of(m_actions, [&](const QAction* action) { return keyOf(*action) == event.key(); }))
    return false;
  if (!event.isAutoRepeat()) m_held.insert(event.key());
  return true;
}

glm::vec3 FlyKeys::direction() const {
  const auto held = [this](int i) { return m_held.contains(keyOf(*m_actions[i])) ? 1.0F : 0.0F; };
  return {held(0) - held(1), held(2) - held(3), held(4) - held(5)};
}

}  // namespace dermis
