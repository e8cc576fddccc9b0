// What lies over the picture: statistics, the view's name and legend, the scale, and what to say where there is none.
#include <QLabel>
#include <QResizeEvent>
#include <algorithm>

#include "ui/document/document.h"
#include "ui/viewport/legend.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/overlay_canvas.h"
#include "ui/viewport/view_modes.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {
constexpr int kEdge = 10;
}

void Viewport::setStatisticsVisible(bool visible) { m_statistics->setVisible(visible); }

void Viewport::refreshViewName() {
  QStringList words;
  if (m_aov != Aov::Beauty) words << viewMode(m_aov).label;
  if (m_withoutSubsurface) words << tr("without subsurface");
  m_viewName->setText(words.join(QStringLiteral(" · ")));
  m_viewName->setAccessibleName(words.isEmpty() ? QString() : tr("Shown: %1").arg(words.join(QStringLiteral(", "))));
  m_viewName->setVisible(!words.isEmpty());
  refreshLegend();
  placeOverlays();
}

void Viewport::refreshLegend() {
  const std::shared_ptr<const ResolvedScene> scene = m_aov == Aov::Beauty ? nullptr : m_document.snapshot();
  const auto range = scene ? valueRange(m_aov, *scene, m_document.camera()) : std::nullopt;
  m_legend->setVisible(range.has_value());
  if (range) m_legend->showRange(viewMode(m_aov).label, *range);
}

void Viewport::refreshStatistics(double milliseconds) {
  // A picture that compiled a program or waited for the machine says little of the next one.
  if (m_smoothedMs > 0.0 && (milliseconds > 5.0 * m_smoothedMs || m_smoothedMs > 5.0 * milliseconds))
    m_smoothedMs = 0.0;
  m_smoothedMs = m_smoothedMs <= 0.0 ? milliseconds : 0.8 * m_smoothedMs + 0.2 * milliseconds;
  m_scaleBar->showScale(
      static_cast<double>(navigation::unitsPerPixel(m_document.camera(), static_cast<float>(height()))) *
      static_cast<double>(m_document.millimetresPerUnit()));
  if (!m_statistics->isVisible()) return;
  const RenderStatistics now = m_renderer ? m_renderer->statistics() : RenderStatistics{};
  // Often enough to read, not at every picture: the label is composed with the window.
  const bool last = now.samples >= now.targetSamples;
  if (m_sinceText.isValid() && m_sinceText.elapsed() < 500 && !last) return;
  m_sinceText.start();
  const QString line = tr("%1 fps   %2 ms   %3/%4", "pictures a second, time of one, samples of how many")
                           .arg(1000.0 / std::max(m_smoothedMs, 0.1), 0, 'f', m_smoothedMs > 100.0 ? 1 : 0)
                           .arg(m_smoothedMs, 0, 'f', 1)
                           .arg(now.samples)
                           .arg(now.targetSamples);
  if (line == m_statistics->text()) return;
  m_statistics->setText(line);
  placeOverlays();
}

void Viewport::showProblem(const QString& sentence) {
  m_problem->setText(sentence);
  m_problem->show();
  m_problem->raise();
}

void Viewport::placeOverlays() {
  m_statistics->adjustSize();
  m_statistics->move(width() - m_statistics->width() - kEdge, height() - m_statistics->height() - kEdge);
  m_scaleBar->move(kEdge + 4, height() - m_scaleBar->height() - kEdge);
  m_viewName->adjustSize();
  m_viewName->move(kEdge, kEdge);
  m_legend->move(width() - m_legend->width() - kEdge, kEdge);
  m_problem->setGeometry(rect());
  m_canvas->setGeometry(rect());
}

void Viewport::resizeEvent(QResizeEvent* event) {
  GlWidget::resizeEvent(event);
  placeOverlays();
  tellPixels();
}

void Viewport::tellPixels() { Q_EMIT pictureResized(QSize(width(), height()) * devicePixelRatioF()); }

}  // namespace dermis
