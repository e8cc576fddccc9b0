#include "ui/viewport/legend.h"

#include <QPainter>
#include <cmath>

namespace dermis {
namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 58;
constexpr int kEdge = 14;
constexpr int kBarTop = 24;
constexpr int kBarHeight = 12;
constexpr int kRedWidth = 14;  // what is above the range, beside the bar

QColor colourOf(const glm::vec3& c) {
  const glm::vec3 inside = glm::clamp(c, glm::vec3(0.0F), glm::vec3(1.0F));
  return QColor::fromRgbF(inside.r, inside.g, inside.b);
}

}  // namespace

double roundStep(double span, int most) {
  if (!(span > 0.0) || !std::isfinite(span) || most < 1) return 1.0;
  const double least = span / most;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= least * (1.0 - 1e-9)) return factor * decade;
  return 10.0 * decade;
}

Legend::Legend(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("viewport.legend"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFixedSize(kWidth, kHeight);
  hide();
}

void Legend::showRange(const QString& title, const ValueRange& range) {
  m_title = title;
  m_range = range;
  m_unit.clear();
  m_shownPerValue = 1.0;
  if (range.inMillimetres > 0.0F) {
    const double far = static_cast<double>(range.high) * static_cast<double>(range.inMillimetres);
    const bool metres = far >= 10000.0;
    m_unit = metres ? tr("m") : tr("mm");
    m_shownPerValue = static_cast<double>(range.inMillimetres) * (metres ? 1e-3 : 1.0);
  }
  const auto shown = [&](float v) { return QString::number(static_cast<double>(v) * m_shownPerValue, 'g', 4); };
  setAccessibleName(
      tr("Legend: %1 from %2 to %3 %4").arg(title, shown(range.low), shown(range.high), m_unit).trimmed());
  update();
}

std::vector<double> Legend::ticks() const {
  const double low = static_cast<double>(m_range.low) * m_shownPerValue;
  const double high = static_cast<double>(m_range.high) * m_shownPerValue;
  const double step = roundStep(high - low, 5);
  std::vector<double> values;
  for (double v = std::ceil(low / step - 1e-9) * step; v <= high + 1e-9 * step; v += step) values.push_back(v);
  return values;
}

void Legend::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen);
  p.setBrush(QColor(20, 20, 20, 175));
  p.drawRoundedRect(rect(), 4, 4);

  p.setPen(QColor(225, 225, 225));
  const QString words = m_unit.isEmpty() ? m_title : tr("%1, %2").arg(m_title, m_unit);
  p.drawText(QRect(kEdge, 3, width() - 2 * kEdge, 20), Qt::AlignLeft | Qt::AlignVCenter, words);

  // One column of device pixels at a time: the ramp is as fine as the screen.
  const double ratio = devicePixelRatioF();
  const int barWidth = width() - 2 * kEdge - (m_range.marksAbove ? kRedWidth : 0);
  const int columns = static_cast<int>(barWidth * ratio);
  for (int i = 0; i < columns; ++i) {
    const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(columns);
    const float value = m_range.low + share * (m_range.high - m_range.low);
    p.fillRect(QRectF(kEdge + i / ratio, kBarTop, 1.0 / ratio + 0.05, kBarHeight),
               colourOf(falseColour(m_range, value)));
  }
  if (m_range.marksAbove) {
    const QRectF red(kEdge + barWidth + 2, kBarTop, kRedWidth - 2, kBarHeight);
    p.fillRect(red, colourOf(falseColour(m_range, m_range.high + 1.0F)));
  }
  const double low = static_cast<double>(m_range.low) * m_shownPerValue;
  const double high = static_cast<double>(m_range.high) * m_shownPerValue;
  const QFontMetrics metrics = fontMetrics();
  p.setRenderHint(QPainter::Antialiasing, false);
  for (const double value : ticks()) {
    const double x = kEdge + (value - low) / (high - low) * barWidth;
    p.drawLine(QPointF(x, kBarTop + kBarHeight), QPointF(x, kBarTop + kBarHeight + 3));
    QString number = QString::number(value, 'g', 4);
    const bool open = !m_range.marksAbove && m_range.ramp == ColourRamp::Viridis && value > high - 1e-6 * (high - low);
    if (open) number.prepend(QStringLiteral("≥ "));  // whatever is thicker has the last colour too
    const int wide = metrics.horizontalAdvance(number);
    const double left = std::clamp(x - wide / 2.0, 2.0, static_cast<double>(width() - wide - 2));
    p.drawText(QRectF(left, kBarTop + kBarHeight + 3, wide + 2, 16), Qt::AlignLeft | Qt::AlignVCenter, number);
  }
  if (m_range.marksAbove)
    p.drawText(QRect(width() - kEdge - kRedWidth - 8, kBarTop + kBarHeight + 3, kRedWidth + 20, 16),
               Qt::AlignRight | Qt::AlignVCenter, tr("> 1"));
}

}  // namespace dermis
