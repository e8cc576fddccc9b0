#include "ui/viewport/light_shapes.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ui/rows/colour_math.h"
#include "ui/viewport/handle_paint.h"
#include "ui/viewport/light_dome.h"

namespace dermis::shapes {
namespace {

constexpr double kMark = 8.0;  // half the size of a mark
using handles::kAccent;
using handles::kPale;
using handles::kRing;
using handles::outlined;

QColor colourOf(const Light& light) {
  const float most = std::max({light.color.r, light.color.g, light.color.b, 1e-6F});
  return toScreen(light.color / most);
}

bool hasSize(const Light& light) {
  return light.type == LightType::Sphere || light.type == LightType::Rect || light.type == LightType::Spot ||
         light.visible;
}

/// The way the light travels on the screen, from where it comes.
QPointF wayOnScreen(const Projection& view, const Light& light, const glm::vec3& centre) {
  const bool aimed = light.type != LightType::Point && light.type != LightType::Sphere;
  const glm::vec3 way =
      aimed && glm::length(light.direction) > 0.0F ? glm::normalize(light.direction) : -dome::towards(light, centre);
  return {static_cast<double>(glm::dot(way, view.right())), -static_cast<double>(glm::dot(way, view.up()))};
}

void paintMark(QPainter& p, const Light& light, QPointF at) {
  const double m = kMark;
  switch (light.type) {
    case LightType::Point:
      p.drawEllipse(at, 0.55 * m, 0.55 * m);
      for (int i = 0; i < 8; ++i) {
        const double a = i * std::numbers::pi / 4.0;
        const QPointF way(std::cos(a), std::sin(a));
        p.drawLine(at + 0.75 * m * way, at + 1.05 * m * way);
      }
      break;
    case LightType::Directional:
      p.drawEllipse(at, 0.75 * m, 0.75 * m);
      break;
    case LightType::Spot: {
      QPolygonF cone;
      cone << at + QPointF(-0.35 * m, -0.8 * m) << at + QPointF(0.35 * m, -0.8 * m) << at + QPointF(0.8 * m, 0.8 * m)
           << at + QPointF(-0.8 * m, 0.8 * m);
      p.drawPolygon(cone);
      break;
    }
    case LightType::Sphere:
      p.drawEllipse(at, m, m);
      p.drawArc(QRectF(at - QPointF(m, 0.4 * m), QSizeF(2 * m, 0.8 * m)), 180 * 16, 180 * 16);
      break;
    case LightType::Rect:
      p.drawRect(QRectF(at - QPointF(m, 0.7 * m), QSizeF(2 * m, 1.4 * m)));
      break;
  }
}

void polyline(QPainter& p, const Projection& view, const std::vector<glm::vec3>& points, bool closed) {
  QPolygonF line;
  for (const glm::vec3& point : points) {
    const auto at = view.toScreen(point);
    if (!at || std::abs(at->x()) > 1e5 || std::abs(at->y()) > 1e5) return;
    line << *at;
  }
  if (closed)
    p.drawPolygon(line);
  else
    p.drawPolyline(line);
}

/// Two unit vectors across `z`, as the renderer lays out a rectangle's sides.
void frameAbout(const glm::vec3& z, glm::vec3& x, glm::vec3& y) {
  const glm::vec3 up = std::abs(z.y) > 0.99F ? glm::vec3(0.0F, 0.0F, -1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  x = glm::normalize(glm::cross(up, z));
  y = glm::cross(z, x);
}

std::vector<glm::vec3> circle(const glm::vec3& centre, const glm::vec3& x, const glm::vec3& y, float radius) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 48; ++i) {
    const float a = static_cast<float>(i) / 48.0F * 2.0F * std::numbers::pi_v<float>;
    points.push_back(centre + radius * (std::cos(a) * x + std::sin(a) * y));
  }
  return points;
}

}  // namespace

void paintRings(QPainter& p, const Projection& view) {
  p.setRenderHint(QPainter::Antialiasing);
  p.setBrush(Qt::NoBrush);
  const double r = dome::ringRadius(view);
  for (const double radius : {r, 2.0 * r}) {
    p.setPen(QPen(QColor(0, 0, 0, 90), 3.0));
    p.drawEllipse(view.middle(), radius, radius);
    p.setPen(QPen(QColor(230, 230, 230, 130), 1.0));
    p.drawEllipse(view.middle(), radius, radius);
  }
}

void paintHandle(QPainter& p, const Projection& view, const Light& light, QPointF at, const glm::vec3& centre,
                 bool selected, bool hovered) {
  p.setRenderHint(QPainter::Antialiasing);
  const QColor line = selected ? kAccent : kPale;
  p.setOpacity(light.enabled ? 1.0 : 0.45);
  // The way the light goes, as far as it goes across the screen.
  const QPointF way = wayOnScreen(view, light, centre);
  const double length = std::hypot(way.x(), way.y());
  if (length > 0.15 && light.type != LightType::Point) {
    const QPointF unit = way / length;
    const QPointF from = at + 14.0 * unit, to = at + (14.0 + 20.0 * length) * unit;
    const QPointF side(-unit.y(), unit.x());
    outlined(p, line, 1.5, [&] {
      p.drawLine(from, to);
      p.drawLine(to, to - 5.0 * unit + 3.5 * side);
      p.drawLine(to, to - 5.0 * unit - 3.5 * side);
    });
  }
  handles::setGround(p, hovered || selected);
  p.drawEllipse(at, 12.5, 12.5);
  handles::setMark(p, colourOf(light), selected, hovered);
  paintMark(p, light, at);
  if (selected && hasSize(light)) {
    outlined(p, kAccent, 1.0, [&] {
      if (light.type == LightType::Rect) {
        // Its sides' proportions.
        const double most = static_cast<double>(std::max({light.sizeMm.x, light.sizeMm.y, 1e-3F}));
        const double w = kRing * static_cast<double>(light.sizeMm.x) / most;
        const double h = kRing * static_cast<double>(light.sizeMm.y) / most;
        p.drawRect(QRectF(at - QPointF(w, h), QSizeF(2 * w, 2 * h)));
      } else {
        p.drawEllipse(at, kRing, kRing);
      }
    });
    handles::paintSizeHandles(p, sizeHandles(light, at));
  }
  p.setOpacity(1.0);
}

void paintInPlace(QPainter& p, const Projection& view, const Light& light, const glm::vec3& centre,
                  float millimetresPerUnit) {
  if (light.type == LightType::Directional) return;
  p.setRenderHint(QPainter::Antialiasing);
  const glm::vec3 aim = glm::length(light.direction) > 0.0F ? glm::normalize(light.direction) : glm::vec3(0, 0, -1);
  const float reach = glm::length(light.position - centre);
  glm::vec3 x, y;
  frameAbout(aim, x, y);
  outlined(p, QColor(255, 196, 87, 200), 1.2, [&] {
    switch (light.type) {
      case LightType::Sphere:
        polyline(p, view, circle(light.position, view.right(), view.up(), light.radiusMm / millimetresPerUnit), true);
        break;
      case LightType::Rect: {
        const glm::vec2 half = 0.5F * light.sizeMm / millimetresPerUnit;
        polyline(p, view,
                 {light.position - half.x * x - half.y * y, light.position + half.x * x - half.y * y,
                  light.position + half.x * x + half.y * y, light.position - half.x * x + half.y * y},
                 true);
        break;
      }
      case LightType::Spot:
        for (const float degrees : {light.innerDegrees, light.outerDegrees}) {
          const float angle = glm::radians(std::min(degrees, 89.0F));
          const glm::vec3 end = light.position + reach * aim;
          const float radius = reach * std::tan(angle);
          polyline(p, view, circle(end, x, y, radius), true);
          for (const glm::vec3& side : {x, -x, y, -y}) polyline(p, view, {light.position, end + radius * side}, false);
        }
        break;
      default:
        if (light.visible)
          polyline(p, view, circle(light.position, view.right(), view.up(), light.radiusMm / millimetresPerUnit), true);
        break;
    }
    polyline(p, view, {light.position, light.position + 0.25F * reach * aim}, false);
  });
}

QList<QPointF> sizeHandles(const Light& light, QPointF at) {
  if (!hasSize(light)) return {};
  if (light.type != LightType::Rect) return {at + QPointF(kRing, 0.0)};
  const double most = static_cast<double>(std::max({light.sizeMm.x, light.sizeMm.y, 1e-3F}));
  return {at + QPointF(kRing * static_cast<double>(light.sizeMm.x) / most, 0.0),
          at - QPointF(0.0, kRing * static_cast<double>(light.sizeMm.y) / most)};
}

Light dragged(const Light& start, int which, QPointF at, QPointF from, QPointF to) {
  const float factor = handles::sizeFactor(which, at, from, to);
  if (start.type != LightType::Rect) return dome::resized(start, factor);
  Light next = start;
  float& side = which == 1 ? next.sizeMm.y : next.sizeMm.x;
  side = std::max(side * factor, 0.1F);
  return next;
}

}  // namespace dermis::shapes
