#include "ui/viewport/viewport_tool.h"

namespace dermis {

bool ViewportTool::press(const QMouseEvent&) { return false; }
void ViewportTool::drag(const QMouseEvent&) {}
void ViewportTool::release() {}
void ViewportTool::cancel() {}
bool ViewportTool::wheel(const QWheelEvent&) { return false; }
void ViewportTool::hover(const QPointF&) {}
void ViewportTool::leave() {}

}  // namespace dermis
