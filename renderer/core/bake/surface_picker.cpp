#include "core/bake/surface_picker.h"

#include <algorithm>

namespace dermis {

Result<SurfacePicker> SurfacePicker::create(std::shared_ptr<const Model> model) {
  auto rays = RayScene::create(*model, {});
  if (!rays) return tl::unexpected(rays.error());
  SurfacePicker made(std::move(*rays));
  std::uint32_t end = 0;
  for (const ModelPart& part : model->parts) made.m_partEnds.push_back(end += part.indexCount / 3);
  made.m_model = std::move(model);
  return made;
}

std::optional<SurfaceHit> SurfacePicker::hit(const glm::vec3& origin, const glm::vec3& direction) const {
  std::optional<RayScene::Hit> found;
  m_rays.firstHits(origin, {&direction, 1}, {&found, 1});
  if (!found) return std::nullopt;
  const glm::uvec3& corners = m_rays.corners(found->triangle);
  const auto& normals = m_model->normals;
  const glm::vec3 normal = (1.0F - found->weights.x - found->weights.y) * normals[corners.x] +
                           found->weights.x * normals[corners.y] + found->weights.y * normals[corners.z];
  const auto part = std::ranges::upper_bound(m_partEnds, found->triangle) - m_partEnds.begin();
  return SurfaceHit{found->distance, origin + found->distance * direction,
                    glm::length(normal) > 0.0F ? glm::normalize(normal) : -direction,
                    m_model->parts[static_cast<std::size_t>(part)].slot};
}

}  // namespace dermis
