#include "ui/viewport/overlay.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace dermis {
namespace {
constexpr int kLongest = 130;
}

ScaleBar::ScaleBar(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFixedSize(kLongest + 80, 24);
}

void ScaleBar::showScale(double millimetresPerPixel) {
  if (!(millimetresPerPixel > 0.0) || !std::isfinite(millimetresPerPixel)) return;
  // The largest of 1, 2, 5 × 10ⁿ that fits.
  const double room = millimetresPerPixel * kLongest;
  const double decade = std::pow(10.0, std::floor(std::log10(room)));
  const double length = room >= 5.0 * decade ? 5.0 * decade : room >= 2.0 * decade ? 2.0 * decade : decade;
  const int pixels = static_cast<int>(std::lround(length / millimetresPerPixel));
  const QString words = length >= 1000.0 ? tr("%1 m").arg(length / 1000.0) : tr("%1 mm").arg(length);
  if (pixels == m_pixels && words == m_text) return;
  m_pixels = pixels;
  m_text = words;
  setAccessibleName(tr("Scale: the bar is %1 long").arg(words));
  update();
}

void ScaleBar::paintEvent(QPaintEvent*) {
  if (m_pixels <= 0) return;
  QPainter p(this);
  const QRect bar(1, 10, m_pixels, 4);
  p.fillRect(bar.adjusted(-1, -1, 1, 1), QColor(0, 0, 0, 130));
  p.fillRect(bar, QColor(225, 225, 225));
  p.fillRect(bar.adjusted(0, 1, -m_pixels / 2, -1), QColor(70, 70, 70));
  const QRect words(bar.right() + 8, 0, width() - bar.right() - 8, 24);
  p.setPen(QColor(0, 0, 0, 190));
  p.drawText(words.translated(1, 1), Qt::AlignVCenter, m_text);
  p.setPen(QColor(225, 225, 225));
  p.drawText(words, Qt::AlignVCenter, m_text);
}

OverlayLabel::OverlayLabel(QWidget* parent) : QLabel(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setStyleSheet(
      QStringLiteral("background: rgba(20,20,20,150); color: #dcdcdc; border-radius: 3px; padding: 3px 8px;"));
}

}  // namespace dermis
