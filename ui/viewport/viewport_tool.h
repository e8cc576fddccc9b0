// What lies over the picture and may take a gesture before the camera does: gizmos, a ruler, the handle of a split
// view.
#pragma once

#include <Qt>

class QMouseEvent;
class QPainter;
class QPointF;
class QString;
class QWheelEvent;

namespace dermis {

class Projection;

class ViewportTool {
 public:
  ViewportTool() = default;
  virtual ~ViewportTool() = default;
  ViewportTool(const ViewportTool&) = delete;
  ViewportTool& operator=(const ViewportTool&) = delete;

  /// True where the tool takes the gesture: it gets drag() until release() or cancel().
  virtual bool press(const QMouseEvent& event);
  virtual void drag(const QMouseEvent& event);
  virtual void release();
  /// Esc: everything is as it was before the press.
  virtual void cancel();
  virtual bool wheel(const QWheelEvent& event);
  /// The pointer moves with no button held.
  virtual void hover(const QPointF& at);
  virtual void leave();
  virtual void paint(QPainter& painter, const Projection& projection) = 0;
};

/// Words in a dark box over the picture; `side` says where of `at` the box stands (Qt::AlignLeft: to the left of it;
/// AlignHCenter: about it).
void paintTag(QPainter& painter, const QPointF& at, Qt::AlignmentFlag side, const QString& words);

}  // namespace dermis
