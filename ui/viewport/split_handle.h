// The line between the two halves of a split view, and the hand on it.
#pragma once

#include <QString>

#include "ui/viewport/viewport_tool.h"

namespace dermis {

class Viewport;

class SplitHandle : public ViewportTool {
 public:
  explicit SplitHandle(Viewport& viewport) : m_viewport(viewport) {}
  /// What stands on each side.
  void setNames(const QString& left, const QString& right);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release() override;
  void cancel() override;
  void hover(const QPointF& at) override;
  void leave() override;
  void paint(QPainter& painter, const Projection& projection) override;

 private:
  [[nodiscard]] bool isUnder(const QPointF& at) const;
  Viewport& m_viewport;
  QString m_left, m_right;
  bool m_dragging = false;
  bool m_hovered = false;
  double m_before = 0.5;
};

}  // namespace dermis
