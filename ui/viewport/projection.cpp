#include "ui/viewport/projection.h"

#include <algorithm>
#include <cmath>

namespace dermis {

Projection::Projection(const Camera& camera, QSizeF size) : m_camera(camera), m_size(size) {
  m_forward = glm::normalize(camera.target - camera.position);
  m_right = glm::normalize(glm::cross(m_forward, camera.up));
  m_up = glm::cross(m_right, m_forward);
}

float Projection::unitsPerPixel(const glm::vec3& world) const {
  const float distance = std::max(glm::dot(world - m_camera.position, m_forward), 1e-6F);
  const float whole = m_camera.orthographicHeight.value_or(2.0F * distance *
                                                           std::tan(0.5F * glm::radians(m_camera.verticalFovDegrees)));
  return whole / static_cast<float>(std::max(m_size.height(), 1.0));
}

std::optional<QPointF> Projection::toScreen(const glm::vec3& world) const {
  const glm::vec3 offset = world - m_camera.position;
  if (!m_camera.orthographicHeight && glm::dot(offset, m_forward) <= 1e-6F) return std::nullopt;
  const float scale = 1.0F / unitsPerPixel(world);
  return middle() + QPointF(static_cast<qreal>(glm::dot(offset, m_right) * scale),
                            -static_cast<qreal>(glm::dot(offset, m_up) * scale));
}

Ray Projection::ray(QPointF point) const {
  const QPointF offset = point - middle();
  // One unit in front of the camera.
  const float scale = unitsPerPixel(m_camera.position + m_forward);
  const glm::vec3 across = scale * (static_cast<float>(offset.x()) * m_right - static_cast<float>(offset.y()) * m_up);
  if (m_camera.orthographicHeight) return {m_camera.position + across, m_forward};
  return {m_camera.position, glm::normalize(m_forward + across)};
}

}  // namespace dermis
