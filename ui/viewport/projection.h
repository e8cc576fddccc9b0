// A camera and the widget that it fills: from the world to points of the widget and back. Pure functions.
#pragma once

#include <QPointF>
#include <QSizeF>
#include <optional>

#include "core/scene/scene.h"

namespace dermis {

struct Ray {
  glm::vec3 origin{0.0F};
  glm::vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit
};

class Projection {
 public:
  Projection(const Camera& camera, QSizeF size);
  /// Nothing for what lies behind the camera.
  [[nodiscard]] std::optional<QPointF> toScreen(const glm::vec3& world) const;
  [[nodiscard]] Ray ray(QPointF point) const;
  /// Scene units that one pixel of the widget covers at the distance of `world`.
  [[nodiscard]] float unitsPerPixel(const glm::vec3& world) const;
  [[nodiscard]] const glm::vec3& right() const { return m_right; }
  [[nodiscard]] const glm::vec3& up() const { return m_up; }
  [[nodiscard]] const glm::vec3& forward() const { return m_forward; }
  [[nodiscard]] QSizeF size() const { return m_size; }
  [[nodiscard]] QPointF middle() const { return {0.5 * m_size.width(), 0.5 * m_size.height()}; }

 private:
  Camera m_camera;
  QSizeF m_size;
  glm::vec3 m_right, m_up, m_forward;
};

}  // namespace dermis
