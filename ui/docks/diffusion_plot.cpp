#include "ui/docks/diffusion_plot.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "ui/viewport/legend.h"

namespace dermis {
namespace {

constexpr double kShown = 0.92;        // share of the light within the right end of the widest channel
constexpr double kDecades = 4.0;       // of a logarithmic axis
constexpr double kFirstPixels = 1.0;   // R(r) of Burley's profile has no end at r = 0: it is drawn from here
constexpr double kClippedPixels = 10;  // and a linear axis ends at its value here

QString numberText(double v) { return QString::number(v, 'g', 3); }

/// As many decimals as a step needs, so that the numbers of an axis line up.
QString tickText(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  return QString::number(value, 'f', decimals);
}

bool isDark(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128; }

}  // namespace

std::array<QColor, 3> channelColours(const QPalette& palette) {
  if (isDark(palette)) return {QColor(0xf0, 0x6a, 0x62), QColor(0x74, 0xc6, 0x6e), QColor(0x74, 0xa4, 0xf2)};
  return {QColor(0xc0, 0x20, 0x1c), QColor(0x1c, 0x7d, 0x20), QColor(0x1f, 0x4f, 0xb8)};
}

DiffusionPlot::DiffusionPlot(QWidget* parent) : QWidget(parent) {
  setMinimumSize(220, 150);
  setMouseTracking(true);
  setAccessibleName(tr("Diffusion profile"));
}

void DiffusionPlot::showCurves(const DiffusionCurves& curves) {
  if (curves == m_curves) return;
  m_curves = curves;
  refreshRange();
  update();
}

void DiffusionPlot::setRadial(bool radial) {
  m_radial = radial;
  refreshRange();
  update();
}

void DiffusionPlot::setLogarithmic(bool logarithmic) {
  m_logarithmic = logarithmic;
  refreshRange();
  update();
}

glm::dvec3 DiffusionPlot::plotted(const DiffusionProfile& profile, double r) const {
  const glm::dvec3 density = profile.value(r);
  return m_radial ? glm::two_pi<double>() * r * density : density;
}

void DiffusionPlot::refreshRange() {
  double longest = 0.0;
  for (int c = 0; c < 3; ++c) longest = std::max(longest, m_curves.chosen.radius(c, kShown));
  if (!(longest > 0.0) && m_curves.other)
    for (int c = 0; c < 3; ++c) longest = std::max(longest, m_curves.other->radius(c, kShown));
  // In steps, so that the axis rests while a slider moves a little.
  const double step = longest > 0.0 ? roundStep(longest, 8) : 1.0;
  m_longest = longest > 0.0 ? std::ceil(longest / step) * step : 1.0;

  double highest = 0.0;
  const double first = m_longest * (m_radial || m_logarithmic ? kFirstPixels : kClippedPixels) / 400.0;
  const auto look = [&](const DiffusionProfile& profile) {
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 v = plotted(profile, first + (m_longest - first) * i / 199.0);
      for (int c = 0; c < 3; ++c)
        if (std::isfinite(v[c])) highest = std::max(highest, v[c]);
    }
  };
  look(m_curves.chosen);
  if (m_curves.other && !m_logarithmic) {
    // The other family may be much narrower: it may be cut off, not make the chosen one a line on the floor.
    const double own = highest;
    look(*m_curves.other);
    highest = own > 0.0 ? std::min(highest, 1.3 * own) : highest;
  }
  if (!(highest > 0.0)) highest = 1.0;
  if (m_logarithmic) {
    m_highest = std::pow(10.0, std::ceil(std::log10(highest) - 1e-9));
    m_lowest = m_highest * std::pow(10.0, -kDecades);
  } else {
    const double grid = roundStep(highest, 5);
    m_highest = std::ceil(highest * 1.02 / grid) * grid;
    m_lowest = 0.0;
  }
}

QRectF DiffusionPlot::area() const {
  const QFontMetrics metrics = fontMetrics();
  const double left = metrics.horizontalAdvance(QStringLiteral("0.000")) + 14.0;
  return QRectF(left, 2.0 * metrics.height() + 4.0, width() - left - 14.0, height() - 4.6 * metrics.height() - 10.0);
}

double DiffusionPlot::xOf(double r) const { return area().left() + r / m_longest * area().width(); }
double DiffusionPlot::radiusAt(double x) const { return (x - area().left()) / area().width() * m_longest; }

double DiffusionPlot::yOf(double value) const {
  const QRectF a = area();
  if (!m_logarithmic) return a.bottom() - (value - m_lowest) / (m_highest - m_lowest) * a.height();
  if (!(value > 0.0)) return a.bottom() + a.height();
  return a.bottom() - std::log10(value / m_lowest) / std::log10(m_highest / m_lowest) * a.height();
}

void DiffusionPlot::paintAxes(QPainter& p) const {
  const QRectF a = area();
  const QColor ink = palette().color(QPalette::WindowText);
  QColor quiet = ink;
  quiet.setAlphaF(0.7F);
  QColor grid = ink;
  grid.setAlphaF(0.12F);
  const QFontMetrics metrics = fontMetrics();

  const double step = roundStep(m_longest, std::max(2, static_cast<int>(a.width() / 52.0)));
  for (int i = 0; i * step <= m_longest * (1.0 + 1e-9); ++i) {
    const double x = xOf(i * step);
    p.setPen(QPen(grid, 1.0));
    p.drawLine(QPointF(x, a.top()), QPointF(x, a.bottom()));
    p.setPen(quiet);
    p.drawLine(QPointF(x, a.bottom()), QPointF(x, a.bottom() + 4.0));
    p.drawText(QRectF(x - 30.0, a.bottom() + 4.0, 60.0, metrics.height()), Qt::AlignHCenter | Qt::AlignTop,
               tickText(i * step, step));
  }
  const auto across = [&](double value, const QString& words) {
    const double y = yOf(value);
    p.setPen(QPen(grid, 1.0));
    p.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
    p.setPen(quiet);
    p.drawLine(QPointF(a.left() - 4.0, y), QPointF(a.left(), y));
    p.drawText(QRectF(0.0, y - metrics.height() / 2.0, a.left() - 7.0, metrics.height()),
               Qt::AlignRight | Qt::AlignVCenter, words);
  };
  if (m_logarithmic) {
    for (int decade = 0; decade <= static_cast<int>(kDecades); ++decade) {
      const double value = m_highest * std::pow(10.0, -decade);
      across(value, value >= 1e4 || value < 1e-3 ? QString::number(value, 'e', 0) : numberText(value));
    }
  } else {
    const double rise = roundStep(m_highest, std::max(2, static_cast<int>(a.height() / 34.0)));
    for (int i = 0; i * rise <= m_highest * (1.0 + 1e-9); ++i) across(i * rise, tickText(i * rise, rise));
  }
  p.setPen(quiet);
  p.drawLine(a.bottomLeft(), a.bottomRight());
  p.drawLine(a.topLeft(), a.bottomLeft());
  p.drawText(QRectF(a.left(), a.bottom() + 4.0 + metrics.height(), a.width(), metrics.height() + 2.0),
             Qt::AlignHCenter | Qt::AlignTop, tr("distance r from where light entered, mm"));
  p.drawText(QRectF(8.0, 2.0, width() - 16.0, metrics.height()), Qt::AlignLeft | Qt::AlignTop,
             m_radial ? tr("2πr·R(r): share leaving per mm of r, 1/mm") : tr("R(r): share leaving per area, 1/mm²"));
}

void DiffusionPlot::paintPixel(QPainter& p) const {
  if (!(m_curves.pixelMm > 0.0)) return;
  const QRectF a = area();
  QColor ink = palette().color(QPalette::WindowText);
  const double x = std::min(xOf(m_curves.pixelMm), a.right());
  QColor band = ink;
  band.setAlphaF(0.10F);
  p.fillRect(QRectF(a.left(), a.top(), x - a.left(), a.height()), band);
  ink.setAlphaF(0.75F);
  p.setPen(QPen(ink, 1.0, Qt::DotLine));
  if (x < a.right()) p.drawLine(QPointF(x, a.top()), QPointF(x, a.bottom()));
  const QString words = tr("pixel %1 mm").arg(numberText(m_curves.pixelMm));
  const double wide = fontMetrics().horizontalAdvance(words);
  const double left = std::clamp(x + 4.0, a.left() + 2.0, a.right() - wide - 2.0);
  p.drawText(QRectF(left, a.top() - fontMetrics().height() - 1.0, wide + 4.0, fontMetrics().height()),
             Qt::AlignLeft | Qt::AlignVCenter, words);
}

void DiffusionPlot::paintCurves(QPainter& p, const DiffusionProfile& profile, bool dashed) const {
  const QRectF a = area();
  const std::array<QColor, 3> colours = channelColours(palette());
  const int columns = std::max(2, static_cast<int>(a.width() * devicePixelRatioF()));
  std::array<QPainterPath, 3> paths;
  std::array<bool, 3> begun{};
  for (int i = 0; i <= columns; ++i) {
    const double r = m_longest * std::max(static_cast<double>(i), 0.25) / columns;
    const glm::dvec3 v = plotted(profile, r);
    for (int c = 0; c < 3; ++c) {
      const auto index = static_cast<std::size_t>(c);
      // Far outside is far enough: huge coordinates are slow to stroke.
      const double y = std::clamp(std::isfinite(v[c]) ? yOf(v[c]) : a.top(), a.top() - 400.0, a.bottom() + 400.0);
      const QPointF at(xOf(r), y);
      if (begun.at(index))
        paths.at(index).lineTo(at);
      else
        paths.at(index).moveTo(at);
      begun.at(index) = true;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    QColor colour = colours.at(c);
    if (dashed) colour.setAlphaF(0.75F);
    QPen pen(colour, dashed ? 1.2 : 2.0);
    if (dashed) pen.setDashPattern({4.0, 4.0});
    p.setPen(pen);
    p.drawPath(paths.at(c));
  }
}

void DiffusionPlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.fillRect(rect(), palette().color(QPalette::Base));
  paintAxes(p);
  paintPixel(p);
  p.save();
  p.setClipRect(area().adjusted(0.0, -1.0, 1.0, 1.0));
  if (m_curves.other) paintCurves(p, *m_curves.other, true);
  paintCurves(p, m_curves.chosen, false);
  if (m_hover >= 0.0) {
    QColor ink = palette().color(QPalette::WindowText);
    p.setPen(QPen(ink, 1.0));
    p.drawLine(QPointF(xOf(m_hover), area().top()), QPointF(xOf(m_hover), area().bottom()));
    const glm::dvec3 v = plotted(m_curves.chosen, std::max(m_hover, 1e-6 * m_longest));
    const std::array<QColor, 3> colours = channelColours(palette());
    p.setPen(Qt::NoPen);
    for (int c = 0; c < 3; ++c) {
      p.setBrush(colours.at(static_cast<std::size_t>(c)));
      if (std::isfinite(v[c])) p.drawEllipse(QPointF(xOf(m_hover), yOf(v[c])), 3.5, 3.5);
    }
  }
  p.restore();
}

void DiffusionPlot::mouseMoveEvent(QMouseEvent* event) {
  const double r = radiusAt(event->position().x());
  m_hover = r >= 0.0 && r <= m_longest ? r : -1.0;
  Q_EMIT hovered(m_hover);
  update();
}

void DiffusionPlot::leaveEvent(QEvent*) {
  m_hover = -1.0;
  Q_EMIT hovered(m_hover);
  update();
}

}  // namespace dermis
