#include "ui/viewport/overlay_canvas.h"

#include <QPainter>

#include "ui/viewport/viewport_tool.h"

namespace dermis {

OverlayCanvas::OverlayCanvas(std::function<Projection()> projection, QWidget* parent)
    : QWidget(parent), m_projection(std::move(projection)) {
  setObjectName(QStringLiteral("viewport.canvas"));
  setAccessibleName(tr("Tools over the picture"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
}

void OverlayCanvas::setTools(const QList<ViewportTool*>& tools) {
  m_tools = tools;
  update();
}

void OverlayCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Projection projection = m_projection();
  for (qsizetype i = m_tools.size() - 1; i >= 0; --i) {
    painter.save();
    m_tools[i]->paint(painter, projection);
    painter.restore();
  }
}

}  // namespace dermis
