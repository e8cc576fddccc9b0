#include "core/scene/pick.h"

#include <cmath>

namespace dermis {

std::optional<SurfaceHit> hitModel(const Model& model, const glm::vec3& origin, const glm::vec3& direction) {
  // Möller & Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection", without culling.
  float nearest = std::numeric_limits<float>::max();
  std::optional<SurfaceHit> hit;
  std::size_t first = 0;
  float bestU = 0.0F, bestV = 0.0F;
  for (const ModelPart& part : model.parts) {
    for (std::size_t i = part.firstIndex; i + 2 < std::size_t{part.firstIndex} + part.indexCount; i += 3) {
      const glm::vec3& a = model.positions[model.indices[i]];
      const glm::vec3 ab = model.positions[model.indices[i + 1]] - a;
      const glm::vec3 ac = model.positions[model.indices[i + 2]] - a;
      const glm::vec3 p = glm::cross(direction, ac);
      const float determinant = glm::dot(ab, p);
      if (determinant == 0.0F) continue;
      const float inverse = 1.0F / determinant;
      const glm::vec3 offset = origin - a;
      const float u = glm::dot(offset, p) * inverse;
      if (!(u >= 0.0F && u <= 1.0F)) continue;
      const glm::vec3 q = glm::cross(offset, ab);
      const float v = glm::dot(direction, q) * inverse;
      if (!(v >= 0.0F && u + v <= 1.0F)) continue;
      const float t = glm::dot(ac, q) * inverse;
      if (!(t > 0.0F && t < nearest)) continue;
      nearest = t;
      first = i;
      bestU = u;
      bestV = v;
      hit = SurfaceHit{t, origin + t * direction, {}, part.slot};
    }
  }
  if (hit) {
    const glm::vec3 normal = (1.0F - bestU - bestV) * model.normals[model.indices[first]] +
                             bestU * model.normals[model.indices[first + 1]] +
                             bestV * model.normals[model.indices[first + 2]];
    hit->normal = glm::length(normal) > 0.0F ? glm::normalize(normal) : -direction;
  }
  return hit;
}

}  // namespace dermis
