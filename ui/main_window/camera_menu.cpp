#include "ui/main_window/camera_menu.h"

#include <QCoreApplication>
#include <QMenu>
#include <functional>

#include "ui/document/document.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {

constexpr float kTurn = 0.0873F;  // radians: 5 degrees
constexpr float kShift = 24.0F;   // pixels
constexpr float kZoom = 1.0F;     // as a tick of the wheel

/// Whose words these are, for translators.
struct CameraMenu {
  Q_DECLARE_TR_FUNCTIONS(dermis::CameraMenu)
};

}  // namespace

void onPicture(Viewport& viewport, QAction* action) {
  action->setShortcutContext(Qt::WidgetShortcut);
  viewport.addAction(action);
}

void fillCameraMenu(QMenu* menu, Document& document, Viewport& viewport) {
  using Step = std::function<Camera(const Camera&)>;
  const auto add = [&](const QString& label, const char* id, const QList<QKeySequence>& keys, const Step& step) {
    QAction* action = menu->addAction(label);
    action->setObjectName(QLatin1String(id));
    action->setShortcuts(keys);
    onPicture(viewport, action);
    QObject::connect(action, &QAction::triggered, &viewport,
                     [&document, &viewport, step] { viewport.goTo(step(document.camera())); });
  };
  // The picture goes the way of the arrow, as it follows a hand.
  const auto turn = [](float x, float y) {
    return [=](const Camera& camera) { return navigation::orbit(camera, x * kTurn, y * kTurn); };
  };
  const auto shift = [&viewport](float x, float y) {
    return [=, &viewport](const Camera& camera) {
      return navigation::pan(camera, x * kShift, y * kShift, static_cast<float>(viewport.height()));
    };
  };
  const auto zoom = [](float steps) { return [=](const Camera& camera) { return navigation::zoom(camera, steps); }; };
  add(CameraMenu::tr("Turn &left"), "view.turnLeft", {QKeySequence(Qt::Key_Left)}, turn(-1.0F, 0.0F));
  add(CameraMenu::tr("Turn &right"), "view.turnRight", {QKeySequence(Qt::Key_Right)}, turn(1.0F, 0.0F));
  add(CameraMenu::tr("Turn &up"), "view.turnUp", {QKeySequence(Qt::Key_Up)}, turn(0.0F, -1.0F));
  add(CameraMenu::tr("Turn &down"), "view.turnDown", {QKeySequence(Qt::Key_Down)}, turn(0.0F, 1.0F));
  menu->addSeparator();
  add(CameraMenu::tr("Shift left"), "view.shiftLeft", {QKeySequence(Qt::SHIFT | Qt::Key_Left)}, shift(-1.0F, 0.0F));
  add(CameraMenu::tr("Shift right"), "view.shiftRight", {QKeySequence(Qt::SHIFT | Qt::Key_Right)}, shift(1.0F, 0.0F));
  add(CameraMenu::tr("Shift up"), "view.shiftUp", {QKeySequence(Qt::SHIFT | Qt::Key_Up)}, shift(0.0F, 1.0F));
  add(CameraMenu::tr("Shift down"), "view.shiftDown", {QKeySequence(Qt::SHIFT | Qt::Key_Down)}, shift(0.0F, -1.0F));
  menu->addSeparator();
  add(CameraMenu::tr("&Closer"), "view.closer", {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Equal)}, zoom(kZoom));
  add(CameraMenu::tr("&Farther"), "view.farther", {QKeySequence(Qt::Key_Minus)}, zoom(-kZoom));
}

}  // namespace dermis
