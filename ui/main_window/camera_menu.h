// The camera by keys: what a drag and the wheel do, while the picture has the focus.
#pragma once

class QAction;
class QMenu;

namespace dermis {

class Document;
class Viewport;

/// Turn, shift, closer and farther, with their keys.
void fillCameraMenu(QMenu* menu, Document& document, Viewport& viewport);
/// The action's keys are heard while the picture has the focus: elsewhere arrows move in lists and sliders.
void onPicture(Viewport& viewport, QAction* action);

}  // namespace dermis
