#include "core/scene/tangents.h"

#include <array>
#include <cmath>

namespace dermis {
namespace {

/// +1 or −1 as the triangle's UVs run counter-clockwise or clockwise; 0 where they have no area.
double uvSide(const Model& model, const std::uint32_t* corner) {
  const glm::dvec2 a = model.uvs[corner[0]];
  const glm::dvec2 u = glm::dvec2(model.uvs[corner[1]]) - a;
  const glm::dvec2 v = glm::dvec2(model.uvs[corner[2]]) - a;
  const double area = u.x * v.y - u.y * v.x;
  return area > 0.0 ? 1.0 : area < 0.0 ? -1.0 : 0.0;
}

/// dP/du of the triangle, not normalised but for its sign.
glm::dvec3 alongU(const Model& model, const std::uint32_t* corner, double side) {
  const glm::dvec3 p = model.positions[corner[0]];
  const glm::dvec3 e1 = glm::dvec3(model.positions[corner[1]]) - p;
  const glm::dvec3 e2 = glm::dvec3(model.positions[corner[2]]) - p;
  const double v1 = static_cast<double>(model.uvs[corner[1]].y) - static_cast<double>(model.uvs[corner[0]].y);
  const double v2 = static_cast<double>(model.uvs[corner[2]].y) - static_cast<double>(model.uvs[corner[0]].y);
  return side * (v2 * e1 - v1 * e2);
}

glm::dvec3 onPlane(const glm::dvec3& v, const glm::dvec3& normal) { return v - glm::dot(v, normal) * normal; }

glm::vec3 anyPerpendicular(const glm::vec3& normal) {
  const glm::vec3 axis = std::abs(normal.x) < 0.9F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  return glm::normalize(axis - glm::dot(axis, normal) * normal);
}

/// Which ways round the UVs of a vertex's triangles run.
enum Sides : std::uint8_t { kNone = 0, kPlus = 1, kMinus = 2 };

/// A vertex with triangles of both sides gets a twin for the clockwise ones. Fills in w for vertices without a tangent.
void splitMirrored(Model& model) {
  std::vector<std::uint8_t> sides(model.positions.size(), kNone);
  const auto wants = [&](std::uint32_t i) { return model.tangents[i].w == 0.0F; };
  for (std::size_t i = 0; i + 2 < model.indices.size(); i += 3) {
    const double side = uvSide(model, &model.indices[i]);
    if (side == 0.0) continue;
    for (std::size_t c = 0; c < 3; ++c) sides[model.indices[i + c]] |= side > 0.0 ? kPlus : kMinus;
  }
  std::vector<std::uint32_t> twin(sides.size(), 0);
  for (std::size_t i = 0; i + 2 < model.indices.size(); i += 3) {
    if (uvSide(model, &model.indices[i]) >= 0.0) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& index = model.indices[i + c];
      if (index >= sides.size() || !wants(index) || sides[index] != (kPlus | kMinus)) continue;
      if (twin[index] == 0) {
        twin[index] = static_cast<std::uint32_t>(model.positions.size());
        model.positions.push_back(model.positions[index]);
        model.normals.push_back(model.normals[index]);
        model.uvs.push_back(model.uvs[index]);
        model.tangents.push_back(model.tangents[index]);
      }
      index = twin[index];
    }
  }
  sides.resize(model.positions.size(), kMinus);
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (model.tangents[i].w == 0.0F) model.tangents[i] = {0.0F, 0.0F, 0.0F, sides[i] == kMinus ? -2.0F : 2.0F};
}

}  // namespace

void completeTangents(Model& model) {
  // While we work, w = ±2 marks a vertex whose tangent is being made; afterwards w = ±1 everywhere.
  splitMirrored(model);

  // Sum dP/du of the triangles round each vertex, each laid into the vertex's tangent plane and made unit, by angle.
  const auto making = [&](std::uint32_t i) { return std::abs(model.tangents[i].w) > 1.5F; };
  for (std::size_t i = 0; i + 2 < model.indices.size(); i += 3) {
    const std::uint32_t* corner = &model.indices[i];
    if (!making(corner[0]) && !making(corner[1]) && !making(corner[2])) continue;
    const double side = uvSide(model, corner);
    if (side == 0.0) continue;
    const glm::dvec3 along = alongU(model, corner, side);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t at = corner[c];
      if (!making(at)) continue;
      const glm::dvec3 normal = model.normals[at];
      const glm::dvec3 p = model.positions[at];
      const glm::dvec3 a = onPlane(glm::dvec3(model.positions[corner[(c + 1) % 3]]) - p, normal);
      const glm::dvec3 b = onPlane(glm::dvec3(model.positions[corner[(c + 2) % 3]]) - p, normal);
      const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      const glm::dvec3 tangent = onPlane(along, normal);
      const double length = glm::length(tangent);
      if (length > 0.0) model.tangents[at] += glm::vec4(glm::vec3(tangent * (angle / length)), 0.0F);
    }
  }

  // Unit length, perpendicular to the normal; any frame where the UVs give no direction.
  for (std::size_t i = 0; i < model.tangents.size(); ++i) {
    const glm::vec3 normal = model.normals[i];
    glm::vec3 tangent(model.tangents[i]);
    const float w = model.tangents[i].w < 0.0F ? -1.0F : 1.0F;
    tangent -= glm::dot(tangent, normal) * normal;
    const float length = glm::length(tangent);
    constexpr float kNoDirection = 1e-6F;
    tangent = length > kNoDirection ? tangent / length : anyPerpendicular(normal);
    model.tangents[i] = glm::vec4(tangent, w);
  }
}

}  // namespace dermis
