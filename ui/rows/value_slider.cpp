#include "ui/rows/value_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace dermis {
namespace {

constexpr int kSteps = 10000;
constexpr double kHandleRadius = 5.0;
constexpr double kMargin = kHandleRadius + 1.0;

double roundTo(double number, double step) { return std::round(number / step) * step; }

}  // namespace

ValueSlider::ValueSlider(const NumberRange& range, QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, kSteps);
  setSingleStep(kSteps / 100);
  setPageStep(kSteps / 10);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setNumberRange(range);
  // Keys and assistive technology move the integer slider itself.
  connect(this, &QSlider::valueChanged, this, [this](int position) {
    m_number = roundTo(m_range.softMin + (m_range.softMax - m_range.softMin) * position / kSteps, m_range.step());
    Q_EMIT edited(m_number, m_clock.current());
  });
}

void ValueSlider::setNumberRange(const NumberRange& range) {
  m_range = range;
  showNumber(m_number);
}

double ValueSlider::fractionOf(double number) const {
  return std::clamp((number - m_range.softMin) / std::max(m_range.softMax - m_range.softMin, 1e-9), 0.0, 1.0);
}

void ValueSlider::showNumber(double number) {
  m_number = number;
  const QSignalBlocker blocker(this);
  setValue(static_cast<int>(std::lround(fractionOf(number) * kSteps)));
  update();
}

void ValueSlider::setNumber(double number) {
  const double inside = std::clamp(number, m_range.hardMin, m_range.hardMax);
  if (inside == m_number && !m_mixed) return;
  showNumber(inside);
  Q_EMIT edited(inside, m_clock.current());
}

void ValueSlider::showDefault(std::optional<double> number) {
  m_default = number;
  update();
}

QPoint ValueSlider::handleCentre() const {
  return {static_cast<int>(std::lround(kMargin + fractionOf(m_number) * (width() - 2.0 * kMargin))), height() / 2};
}

void ValueSlider::moveTo(double number, Qt::KeyboardModifiers keys) {
  const double range = m_range.softMax - m_range.softMin;
  const double step = keys.testFlag(Qt::ControlModifier) ? range / 20.0
                      : keys.testFlag(Qt::ShiftModifier) ? m_range.step() / 10.0
                                                         : m_range.step();
  // A number past the soft range comes back step by step, and is not pulled to the end by a step away from it.
  const double rounded = std::clamp(m_range.softMin + roundTo(number - m_range.softMin, step),
                                    std::min(m_range.softMin, m_number), std::max(m_range.softMax, m_number));
  if (rounded == m_number && !m_mixed) return;
  showNumber(rounded);
  Q_EMIT edited(rounded, m_clock.current());
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    event->ignore();
    return;
  }
  setFocus(Qt::MouseFocusReason);
  m_clock.beginDrag();
  m_press = m_clock.current();
  Q_EMIT dragStarted();
  m_lastX = event->position().x();
  m_fraction = fractionOf(m_number);
  // A press beside the handle brings the handle there; a press on it moves nothing yet.
  const double away = m_lastX - handleCentre().x();
  if (std::abs(away) > kHandleRadius + 2.0 && !event->modifiers().testFlag(Qt::ShiftModifier)) {
    m_fraction = std::clamp((m_lastX - kMargin) / std::max(width() - 2.0 * kMargin, 1.0), 0.0, 1.0);
    moveTo(m_range.softMin + m_fraction * (m_range.softMax - m_range.softMin), event->modifiers());
  }
  update();
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!m_clock.dragging() || event->position().x() == m_lastX) return;
  const double fine = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.1 : 1.0;
  m_fraction += fine * (event->position().x() - m_lastX) / std::max(width() - 2.0 * kMargin, 1.0);
  m_lastX = event->position().x();
  const double inside = std::clamp(m_fraction, 0.0, 1.0);
  // Past the soft range the handle waits at the end: pulling it further out is no wish to come back.
  const bool past = m_number > m_range.softMax || m_number < m_range.softMin;
  if (past && inside == fractionOf(m_number)) return moveTo(m_number, event->modifiers());
  moveTo(m_range.softMin + inside * (m_range.softMax - m_range.softMin), event->modifiers());
}

void ValueSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_clock.dragging()) return;
  m_clock.endDrag();
  Q_EMIT dragEnded();
  update();
}

void ValueSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_default) {
    mousePressEvent(event);
    return;
  }
  showNumber(*m_default);
  // The first of the two clicks may have moved the handle: they are one gesture. Of several slots others may differ.
  Q_EMIT edited(*m_default, m_press);
}

void ValueSlider::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) {
    event->ignore();
    return;
  }
  step((event->angleDelta().y() + event->angleDelta().x()) / 120.0, event->modifiers());
  event->accept();
}

void ValueSlider::step(double ticks, Qt::KeyboardModifiers keys) {
  const double range = m_range.softMax - m_range.softMin;
  const double tick = keys.testFlag(Qt::ControlModifier) ? range / 20.0
                      : keys.testFlag(Qt::ShiftModifier) ? m_range.step()
                                                         : range / 100.0;
  moveTo(m_number + ticks * tick, keys);
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      return step(-1.0, event->modifiers());
    case Qt::Key_Right:
    case Qt::Key_Up:
      return step(1.0, event->modifiers());
    case Qt::Key_PageDown:
      return step(-10.0, event->modifiers());
    case Qt::Key_PageUp:
      return step(10.0, event->modifiers());
    case Qt::Key_Home:
      return setNumber(m_range.softMin);
    case Qt::Key_End:
      return setNumber(m_range.softMax);
    default:
      QSlider::keyPressEvent(event);
  }
}

void ValueSlider::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QPalette& colours = palette();
  const double y = height() / 2.0;
  const double left = kMargin;
  const double right = width() - kMargin;
  const double x = left + fractionOf(m_number) * (right - left);
  const bool active = isEnabled();

  // The track; the filled part starts at zero where the range spans it.
  p.setPen(Qt::NoPen);
  const bool lightTheme = colours.color(QPalette::Window).lightness() > 128;
  p.setBrush(colours.color(lightTheme ? QPalette::Mid : QPalette::Dark));
  p.drawRoundedRect(QRectF(left - 2, y - 2, right - left + 4, 4), 2, 2);
  const double from =
      m_range.softMin < 0.0 && m_range.softMax > 0.0 ? left + fractionOf(0.0) * (right - left) : left - 2;
  p.setBrush(colours.color(active ? QPalette::PlaceholderText : lightTheme ? QPalette::Dark : QPalette::Mid));
  p.drawRoundedRect(QRectF(std::min(from, x), y - 2, std::abs(x - from), 4), 2, 2);

  if (m_default) {
    const double mark = left + fractionOf(*m_default) * (right - left);
    p.setBrush(colours.color(QPalette::PlaceholderText));
    p.drawRect(QRectF(mark - 0.5, y + 4.5, 1.0, 3.0));
  }

  const bool pressed = m_clock.dragging();
  QColor handle = colours.color(active ? QPalette::ButtonText : QPalette::PlaceholderText);
  if (pressed) handle = colours.color(QPalette::BrightText);
  p.setPen(
      QPen(hasFocus() ? colours.color(QPalette::Highlight) : colours.color(QPalette::Shadow), hasFocus() ? 2.0 : 1.0));
  p.setBrush(handle);
  p.drawEllipse(QPointF(x, y), kHandleRadius, kHandleRadius);

  // Past the soft range: a small arrow at the end says that the number goes on.
  const bool above = m_number > m_range.softMax + m_range.step() * 0.5;
  const bool below = m_number < m_range.softMin - m_range.step() * 0.5;
  if (above || below) {
    const double tip = above ? width() - 0.5 : 0.5;
    const double base = above ? tip - 4.0 : tip + 4.0;
    p.setPen(Qt::NoPen);
    p.setBrush(handle);
    p.drawPolygon(QPolygonF({{tip, y}, {base, y - 8.0}, {base, y - 4.0}}));
  }
}

}  // namespace dermis
