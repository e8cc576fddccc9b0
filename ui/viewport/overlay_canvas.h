// One see-through widget over the picture in which all tools paint.
#pragma once

#include <QList>
#include <QWidget>
#include <functional>

#include "ui/viewport/projection.h"

namespace dermis {

class ViewportTool;

class OverlayCanvas : public QWidget {
  Q_OBJECT
 public:
  OverlayCanvas(std::function<Projection()> projection, QWidget* parent);
  /// The first tool is on top.
  void setTools(const QList<ViewportTool*>& tools);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::function<Projection()> m_projection;
  QList<ViewportTool*> m_tools;
};

}  // namespace dermis
