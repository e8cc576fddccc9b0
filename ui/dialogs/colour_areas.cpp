#include "ui/dialogs/colour_areas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace dermis {
namespace {

void drawRing(QPainter& p, const QPointF& at, bool focus, const QPalette& palette) {
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(QColor(0, 0, 0, 160), 3.0));
  p.drawEllipse(at, 5.0, 5.0);
  p.setPen(QPen(focus ? palette.color(QPalette::Highlight) : QColor(Qt::white), 1.6));
  p.drawEllipse(at, 5.0, 5.0);
}

}  // namespace

SaturationSquare::SaturationSquare(QWidget* parent) : QWidget(parent) {
  setFixedHeight(150);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::CrossCursor);
  setAccessibleName(tr("Saturation and value"));
}

void SaturationSquare::showHsv(float hue, float saturation, float value) {
  m_hue = hue;
  m_saturation = saturation;
  m_value = value;
  update();
}

void SaturationSquare::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  QLinearGradient across(0, 0, width(), 0);
  across.setColorAt(0, Qt::white);
  across.setColorAt(1, QColor::fromHsvF(m_hue, 1, 1));
  p.fillRect(rect(), across);
  QLinearGradient down(0, 0, 0, height());
  down.setColorAt(0, Qt::transparent);
  down.setColorAt(1, Qt::black);
  p.fillRect(rect(), down);
  drawRing(p, QPointF(static_cast<double>(m_saturation) * width(), (1.0 - static_cast<double>(m_value)) * height()),
           hasFocus(), palette());
}

void SaturationSquare::pickAt(const QPointF& at) {
  m_saturation = static_cast<float>(std::clamp(at.x() / width(), 0.0, 1.0));
  m_value = static_cast<float>(std::clamp(1.0 - at.y() / height(), 0.0, 1.0));
  update();
  Q_EMIT picked(m_saturation, m_value, m_clock.current());
}

void SaturationSquare::mousePressEvent(QMouseEvent* event) {
  m_clock.beginDrag();
  pickAt(event->position());
}
void SaturationSquare::mouseMoveEvent(QMouseEvent* event) {
  if (m_clock.dragging()) pickAt(event->position());
}
void SaturationSquare::mouseReleaseEvent(QMouseEvent*) { m_clock.endDrag(); }

void SaturationSquare::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.002 : 0.02;
  double x = static_cast<double>(m_saturation);
  double y = 1.0 - static_cast<double>(m_value);
  switch (event->key()) {
    case Qt::Key_Left:
      x -= step;
      break;
    case Qt::Key_Right:
      x += step;
      break;
    case Qt::Key_Up:
      y -= step;
      break;
    case Qt::Key_Down:
      y += step;
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  pickAt({x * width(), y * height()});
}

HueStrip::HueStrip(QWidget* parent) : QWidget(parent) {
  setFixedHeight(16);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::CrossCursor);
  setAccessibleName(tr("Hue"));
}

void HueStrip::showHue(float hue) {
  m_hue = hue;
  update();
}

void HueStrip::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  QLinearGradient across(0, 0, width(), 0);
  for (int i = 0; i <= 6; ++i) across.setColorAt(i / 6.0, QColor::fromHsvF(static_cast<float>(i % 6) / 6.0F, 1, 1));
  p.setPen(Qt::NoPen);
  p.setBrush(across);
  p.drawRoundedRect(rect(), 3, 3);
  drawRing(p, QPointF(std::clamp(static_cast<double>(m_hue) * width(), 6.0, width() - 6.0), height() / 2.0), hasFocus(),
           palette());
}

void HueStrip::pickAt(const QPointF& at) {
  m_hue = static_cast<float>(std::clamp(at.x() / width(), 0.0, 0.9999));
  update();
  Q_EMIT picked(m_hue, m_clock.current());
}

void HueStrip::mousePressEvent(QMouseEvent* event) {
  m_clock.beginDrag();
  pickAt(event->position());
}
void HueStrip::mouseMoveEvent(QMouseEvent* event) {
  if (m_clock.dragging()) pickAt(event->position());
}
void HueStrip::mouseReleaseEvent(QMouseEvent*) { m_clock.endDrag(); }

void HueStrip::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.001 : 0.01;
  if (event->key() == Qt::Key_Left)
    pickAt({(static_cast<double>(m_hue) - step) * width(), 0});
  else if (event->key() == Qt::Key_Right)
    pickAt({(static_cast<double>(m_hue) + step) * width(), 0});
  else
    QWidget::keyPressEvent(event);
}

}  // namespace dermis
