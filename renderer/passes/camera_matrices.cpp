#include "passes/camera_matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace dermis {

glm::vec2 pixelJitter(int index) {
  // Powers of the plastic number's inverse; doubles, so that the ten-thousandth sample is as good as the first.
  constexpr double kA1 = 0.7548776662466927;
  constexpr double kA2 = 0.5698402909980532;
  const double x = 0.5 + kA1 * index;
  const double y = 0.5 + kA2 * index;
  return {static_cast<float>(x - std::floor(x) - 0.5), static_cast<float>(y - std::floor(y) - 0.5)};
}

CameraMatrices cameraMatrices(const Camera& camera, const Bounds& bounds, glm::ivec2 size, glm::vec2 jitter,
                              std::span<const glm::vec3> extra) {
  CameraMatrices m;
  const glm::vec3 towards = camera.target - camera.position;
  m.position = camera.position;
  m.forward = glm::dot(towards, towards) > 0.0F ? glm::normalize(towards) : glm::vec3(0.0F, 0.0F, -1.0F);
  // An `up` along the view has no sideways part: take another axis.
  glm::vec3 up = camera.up;
  if (glm::length(glm::cross(m.forward, up)) < 1e-6F * std::max(glm::length(up), 1e-6F))
    up = std::abs(m.forward.y) > 0.9F ? glm::vec3(0.0F, 0.0F, -1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  m.view = glm::lookAt(camera.position, camera.position + m.forward, up);

  const float aspect = static_cast<float>(size.x) / static_cast<float>(std::max(size.y, 1));
  const float radius = std::max(bounds.radius(), 1e-6F);
  const float distance = glm::dot(bounds.centre() - camera.position, m.forward);
  glm::mat4 p(0.0F);
  if (camera.orthographicHeight) {
    m.orthographic = true;
    float near = distance - radius;
    float far = distance + radius;
    for (const glm::vec3& point : extra) {
      const float d = glm::dot(point - camera.position, m.forward);
      near = std::min(near, d - 0.1F * radius);
      far = std::max(far, d + 0.1F * radius);
    }
    // A margin keeps what lies on the sphere itself; an orthographic camera sees behind its position too.
    const float margin = 0.01F * (far - near);
    near -= margin;
    far += margin;
    const float halfHeight = 0.5F * std::max(*camera.orthographicHeight, 1e-6F);
    p[0][0] = 1.0F / (halfHeight * aspect);
    p[1][1] = 1.0F / halfHeight;
    p[2][2] = 1.0F / (far - near);
    p[3][2] = far / (far - near);
    p[3][3] = 1.0F;
    m.near = near;
  } else {
    // Near enough to fly between the lashes, far enough for the depth of a float.
    m.near = std::max(0.5F * (distance - radius), 1e-3F * radius);
    const float f = 1.0F / std::tan(0.5F * glm::radians(std::clamp(camera.verticalFovDegrees, 0.01F, 179.0F)));
    p[0][0] = f / aspect;
    p[1][1] = f;
    p[2][3] = -1.0F;
    p[3][2] = m.near;
  }
  // Moving the picture by whole clip units: a pixel is 2/size of them.
  const glm::vec2 shift = 2.0F * jitter / glm::vec2(size);
  m.projection = glm::translate(glm::mat4(1.0F), glm::vec3(shift, 0.0F)) * p;
  m.viewProjection = m.projection * m.view;
  m.inverseViewProjection = glm::inverse(m.viewProjection);
  return m;
}

CameraMatrices cropped(const CameraMatrices& camera, const PixelArea& part, glm::ivec2 size) {
  const glm::vec2 extent(part.extent());
  const glm::vec2 scale = glm::vec2(size) / extent;
  const glm::vec2 shift = (glm::vec2(size) - 2.0F * glm::vec2(part.lower)) / extent - 1.0F;
  CameraMatrices m = camera;
  m.projection =
      glm::scale(glm::translate(glm::mat4(1.0F), glm::vec3(shift, 0.0F)), glm::vec3(scale, 1.0F)) * camera.projection;
  m.viewProjection = m.projection * m.view;
  m.inverseViewProjection = glm::inverse(m.viewProjection);
  return m;
}

float nearestPixel(const CameraMatrices& camera, const Bounds& bounds, glm::ivec2 size) {
  const float atOne = 2.0F / (camera.projection[1][1] * static_cast<float>(std::max(size.y, 1)));
  if (camera.orthographic) return atOne;
  // The corner of the box that lies farthest against the view.
  const glm::vec3 nearest = glm::mix(bounds.max, bounds.min, glm::greaterThan(camera.forward, glm::vec3(0.0F)));
  return atOne * std::max(glm::dot(nearest - camera.position, camera.forward), 0.0F);
}

PixelArea screenArea(const CameraMatrices& camera, const Bounds& bounds, glm::ivec2 size) {
  const PixelArea whole{glm::ivec2(0), size};
  if (bounds.empty()) return whole;
  glm::vec2 lower(1.0F);
  glm::vec2 upper(-1.0F);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 point((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                          (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                          (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
    const glm::vec4 clip = camera.viewProjection * glm::vec4(point, 1.0F);
    if (clip.w <= 0.0F) return whole;
    lower = glm::min(lower, glm::vec2(clip) / clip.w);
    upper = glm::max(upper, glm::vec2(clip) / clip.w);
  }
  // Two pixels for filters that look at neighbours.
  const glm::vec2 scale = 0.5F * glm::vec2(size);
  PixelArea area;
  area.lower = glm::ivec2(glm::floor((glm::clamp(lower, -1.0F, 1.0F) + 1.0F) * scale)) - 2;
  area.upper = glm::ivec2(glm::ceil((glm::clamp(upper, -1.0F, 1.0F) + 1.0F) * scale)) + 2;
  area.lower = glm::clamp(area.lower, glm::ivec2(0), size);
  area.upper = glm::clamp(area.upper, area.lower, size);
  return area;
}

}  // namespace dermis
