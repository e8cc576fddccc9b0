#include "ui/viewport/rig_marks.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/light_rig/light_colour.h"
#include "core/light_rig/rig_gestures.h"
#include "ui/rows/colour_math.h"
#include "ui/viewport/handle_paint.h"
#include "ui/viewport/viewport_tool.h"

namespace dermis::marks {
namespace {

constexpr double kMark = 7.5;
using handles::kRing;

QString words(const char* text) { return QCoreApplication::translate("dermis::RigMarks", text); }

QColor colourOf(const RigElement& e) {
  glm::dvec3 colour(e.color.value_or(glm::vec3(1.0F)));
  if (e.temperatureK) colour = colourOfChromaticity(blackBodyChromaticity(*e.temperatureK));
  if (e.daylightK) colour = colourOfChromaticity(daylightChromaticity(*e.daylightK));
  return toScreen(glm::vec3(colour / std::max({colour.r, colour.g, colour.b, 1e-6})));
}

/// Half the width and height, the longer one 1.
QSizeF proportions(const RigElement& element) {
  const auto size = sizeOf(element);
  if (!size) return {1.0, 1.0};
  const double most = static_cast<double>(std::max({size->size.x, size->size.y, 1e-6F}));
  return {std::max(static_cast<double>(size->size.x) / most, 0.2),
          std::max(static_cast<double>(size->size.y) / most, 0.2)};
}

void paintMark(QPainter& p, const RigElement& element, QPointF at) {
  const double m = kMark;
  const QSizeF half = proportions(element) * m;
  const QRectF box(at - QPointF(half.width(), half.height()), 2.0 * half);
  switch (element.type) {
    case RigElementType::Disc:
      p.drawEllipse(at, m, m);
      break;
    case RigElementType::Ring:
      p.drawEllipse(at, m, m);
      p.setBrush(QColor(20, 20, 20));
      p.drawEllipse(at, 0.5 * m, 0.5 * m);
      break;
    case RigElementType::Glow:
      p.drawEllipse(box);
      break;
    case RigElementType::Sky:
      p.drawEllipse(at, 0.5 * m, 0.5 * m);
      for (int i = 0; i < 8; ++i) {
        const double a = i * std::numbers::pi / 4.0;
        const QPointF way(std::cos(a), std::sin(a));
        p.drawLine(at + 0.75 * m * way, at + 1.1 * m * way);
      }
      break;
    case RigElementType::Window:
      p.drawRect(box);
      p.drawLine(QPointF(at.x(), box.top()), QPointF(at.x(), box.bottom()));
      p.drawLine(QPointF(box.left(), at.y()), QPointF(box.right(), at.y()));
      break;
    default:
      p.drawRect(box);
      break;
  }
}

}  // namespace

QString nameOf(const RigElement& element) {
  if (!element.name.empty()) return QString::fromStdString(element.name);
  static constexpr std::array kNames = {
      QT_TRANSLATE_NOOP("dermis::RigMarks", "Softbox"),     QT_TRANSLATE_NOOP("dermis::RigMarks", "Strip"),
      QT_TRANSLATE_NOOP("dermis::RigMarks", "Disc"),        QT_TRANSLATE_NOOP("dermis::RigMarks", "Ring"),
      QT_TRANSLATE_NOOP("dermis::RigMarks", "Window"),      QT_TRANSLATE_NOOP("dermis::RigMarks", "Glow"),
      QT_TRANSLATE_NOOP("dermis::RigMarks", "Dome"),        QT_TRANSLATE_NOOP("dermis::RigMarks", "Overcast sky"),
      QT_TRANSLATE_NOOP("dermis::RigMarks", "Sky and sun"), QT_TRANSLATE_NOOP("dermis::RigMarks", "Ground")};
  return words(kNames.at(static_cast<std::size_t>(element.type)));
}

void paintHandle(QPainter& p, const RigElement& element, QPointF at, bool selected, bool hovered) {
  p.setRenderHint(QPainter::Antialiasing);
  p.setOpacity(element.enabled ? 1.0 : 0.45);
  handles::setGround(p, hovered || selected);
  p.drawRoundedRect(QRectF(at - QPointF(12, 12), QSizeF(24, 24)), 4, 4);
  handles::setMark(p, colourOf(element), selected, hovered);
  paintMark(p, element, at);
  if (selected) {
    const QSizeF half = proportions(element) * kRing;
    const auto size = sizeOf(element);
    const QRectF box(at - QPointF(half.width(), half.height()), 2.0 * half);
    handles::outlined(p, handles::kAccent, 1.0, [&] {
      if (size && size->isRound)
        p.drawEllipse(box);
      else
        p.drawRect(box);
    });
    handles::paintSizeHandles(p, sizeHandles(element, at));
  }
  p.setOpacity(1.0);
  if (!selected && !hovered) return;
  paintTag(p, at + QPointF(0.0, selected ? kRing + 15.0 : 24.0), Qt::AlignHCenter, nameOf(element));
}

QList<QPointF> sizeHandles(const RigElement& element, QPointF at) {
  const auto size = sizeOf(element);
  if (!size) return {};
  const QSizeF half = proportions(element) * kRing;
  QList<QPointF> handles = {at + QPointF(half.width(), 0.0)};
  if (!size->isRound) handles << at - QPointF(0.0, half.height());
  return handles;
}

RigElement dragged(const RigElement& start, int which, QPointF at, QPointF from, QPointF to) {
  const auto size = sizeOf(start);
  if (!size) return start;
  const float factor = handles::sizeFactor(which, at, from, to);
  glm::vec2 next = size->size;
  if (size->isRound || which == 0) next.x *= factor;
  if (size->isRound || which == 1) next.y *= factor;
  // Three digits: a number for people.
  for (glm::length_t i = 0; i < 2; ++i) next[i] = std::round(next[i] * 1000.0F) / 1000.0F;
  return withSize(start, next);
}

}  // namespace dermis::marks
