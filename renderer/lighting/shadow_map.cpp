#include "lighting/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace dermis {

namespace {

constexpr float kWidestTangent = 1.45F;  // 55°: beyond it a flat map wastes most of its texels
constexpr float kCubeTangent = 1.03F;    // a face of a cube overlaps its neighbours, for filters
constexpr float kNearestShare = 1e-3F;   // of the bounding radius: a caster nearer to the light than that is lost
constexpr float kOffsetTexels = 0.04F;   // what rounding of depths and positions needs
constexpr int kCells = 14;               // along the longest side of the model

std::array<glm::vec3, 8> cornersOf(const Bounds& box) {
  std::array<glm::vec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.at(i) = {(i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                     (i & 4U) != 0 ? box.max.z : box.min.z};
  return corners;
}

/// Whether all of a box lies beyond one plane of the camera's view. Infinite far: there is no far plane.
bool isHidden(const std::array<glm::vec3, 8>& corners, const glm::mat4& viewProjection) {
  std::array<int, 5> beyond{};
  for (const glm::vec3& corner : corners) {
    const glm::vec4 clip = viewProjection * glm::vec4(corner, 1.0F);
    beyond[0] += clip.x < -clip.w ? 1 : 0;
    beyond[1] += clip.x > clip.w ? 1 : 0;
    beyond[2] += clip.y < -clip.w ? 1 : 0;
    beyond[3] += clip.y > clip.w ? 1 : 0;
    beyond[4] += clip.z > clip.w ? 1 : 0;  // before the near plane of the reversed depth
  }
  return std::any_of(beyond.begin(), beyond.end(), [](int count) { return count == 8; });
}

ShadowAxes looking(const glm::vec3& origin, const glm::vec3& forward, bool perspective) {
  ShadowAxes axes;
  axes.origin = origin;
  axes.forward = forward;
  const glm::vec3 up = std::abs(forward.y) > 0.95F ? glm::vec3(0.0F, 0.0F, -1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  axes.right = glm::normalize(glm::cross(forward, up));
  axes.up = glm::cross(axes.right, forward);
  axes.perspective = perspective;
  return axes;
}

glm::vec3 seenFrom(const ShadowAxes& axes, const glm::vec3& point) {
  const glm::vec3 offset = point - axes.origin;
  return {glm::dot(offset, axes.right), glm::dot(offset, axes.up), glm::dot(offset, axes.forward)};
}

/// The widest tangent of any corner; nothing where some lie beside or behind the eye.
std::optional<float> widestTangent(const ShadowAxes& axes, const ShadowGeometry& geometry) {
  float widest = 0.0F;
  for (const Bounds& box : geometry.boxes)
    for (const glm::vec3& corner : cornersOf(box)) {
      const glm::vec3 seen = seenFrom(axes, corner);
      if (seen.z <= 0.0F) return std::nullopt;
      widest = std::max({widest, std::abs(seen.x / seen.z), std::abs(seen.y / seen.z)});
    }
  return widest;
}

/// Half of what an eye can see at most: all of a parallel one, a face of a cube, the cone of a spot.
float limitOf(const ShadowAxes& axes, const LightPoint& light) {
  if (!axes.perspective) return std::numeric_limits<float>::max();
  if (axes.cubeFace) return kCubeTangent;
  if (light.type == LightType::Spot)
    return std::min(kWidestTangent, std::tan(glm::radians(std::min(light.outerDegrees, 89.0F))) + 1e-3F);
  return kWidestTangent;
}

}  // namespace

ShadowGeometry ShadowGeometry::of(const Model& model) {
  ShadowGeometry geometry;
  geometry.bounds = model.bounds;
  const glm::vec3 extent = model.bounds.empty() ? glm::vec3(0.0F) : model.bounds.max - model.bounds.min;
  const float cell = std::max({extent.x, extent.y, extent.z, 1e-20F}) / kCells;
  std::unordered_map<int, std::size_t> places;
  std::vector<float> depths;
  const std::size_t stride = std::max<std::size_t>(1, model.indices.size() / 3 / 100000);
  for (std::size_t i = 0; i + 2 < model.indices.size(); i += 3) {
    std::array<glm::vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner.at(k) = model.positions[model.indices[i + k]];
    const glm::ivec3 at = glm::clamp(
        glm::ivec3(glm::floor(((corner[0] + corner[1] + corner[2]) / 3.0F - model.bounds.min) / cell)), 0, kCells);
    const auto [place, isNew] = places.try_emplace((at.z * 32 + at.y) * 32 + at.x, geometry.boxes.size());
    if (isNew) geometry.boxes.emplace_back();
    for (const glm::vec3& p : corner) geometry.boxes[place->second].grow(p);
    if ((i / 3) % stride != 0 || model.normals.size() != model.positions.size()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const glm::vec3 turn = model.normals[model.indices[i + k]] - model.normals[model.indices[i + next]];
      // e²/(6R), with e/R the angle between the normals of an edge's ends.
      depths.push_back(glm::length(corner.at(k) - corner.at(next)) * glm::length(turn) / 6.0F);
    }
  }
  if (!depths.empty()) {
    const auto at = depths.begin() + static_cast<std::ptrdiff_t>((depths.size() - 1) * 19 / 20);
    std::nth_element(depths.begin(), at, depths.end());
    geometry.facetDepth = *at;
  }
  return geometry;
}

bool ShadowWindow::contains(const ShadowWindow& other) const {
  return lower.x <= other.lower.x && lower.y <= other.lower.y && upper.x >= other.upper.x && upper.y >= other.upper.y &&
         near <= other.near && far >= other.far;
}

std::vector<ShadowAxes> shadowAxes(const LightPoint& light, const ShadowGeometry& geometry) {
  if (geometry.boxes.empty()) return {};
  const glm::vec3 centre = geometry.bounds.centre();
  if (light.type == LightType::Directional) return {looking(centre, light.direction, false)};
  if (light.type == LightType::Spot && std::tan(glm::radians(std::min(light.outerDegrees, 89.0F))) <= kWidestTangent)
    return {looking(light.position, light.direction, true)};
  const glm::vec3 towards = centre - light.position;
  if (glm::length(towards) > 1e-6F * geometry.bounds.radius()) {
    const ShadowAxes axes = looking(light.position, glm::normalize(towards), true);
    const std::optional<float> widest = widestTangent(axes, geometry);
    if (widest && *widest <= kWidestTangent) return {axes};
  }
  // Between what it lights: +X −X +Y −Y +Z −Z, as shadows.glsl counts them.
  std::vector<ShadowAxes> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {1.0F, -1.0F}) {
      glm::vec3 forward(0.0F);
      forward[axis] = sign;
      faces.push_back(looking(light.position, forward, true));
      faces.back().cubeFace = true;
    }
  return faces;
}

ShadowWindow shadowWindow(const ShadowAxes& axes, const LightPoint& light, const ShadowGeometry& geometry,
                          const glm::mat4& viewProjection) {
  const float limit = limitOf(axes, light);
  const float nearest = kNearestShare * geometry.bounds.radius();
  ShadowWindow window;
  window.lower = glm::vec2(std::numeric_limits<float>::max());
  window.upper = glm::vec2(std::numeric_limits<float>::lowest());
  window.near = std::numeric_limits<float>::max();
  window.far = std::numeric_limits<float>::lowest();
  for (const Bounds& box : geometry.boxes) {
    const auto corners = cornersOf(box);
    glm::vec2 lower(std::numeric_limits<float>::max());
    glm::vec2 upper(std::numeric_limits<float>::lowest());
    float near = std::numeric_limits<float>::max();
    float far = std::numeric_limits<float>::lowest();
    bool reachesBehind = false;
    for (const glm::vec3& corner : corners) {
      const glm::vec3 seen = seenFrom(axes, corner);
      near = std::min(near, seen.z);
      far = std::max(far, seen.z);
      if (axes.perspective && seen.z < nearest) {
        reachesBehind = true;
        continue;
      }
      const glm::vec2 across = axes.perspective ? glm::vec2(seen) / seen.z : glm::vec2(seen);
      lower = glm::min(lower, across);
      upper = glm::max(upper, across);
    }
    if (axes.perspective && far < nearest) continue;  // behind the light
    window.near = std::min(window.near, near);
    window.far = std::max(window.far, far);
    if (isHidden(corners, viewProjection)) continue;
    if (reachesBehind) {
      // Beside the eye tangents are endless: as far as the eye sees.
      lower = glm::vec2(-limit);
      upper = glm::vec2(limit);
    }
    window.lower = glm::min(window.lower, glm::max(lower, glm::vec2(-limit)));
    window.upper = glm::max(window.upper, glm::min(upper, glm::vec2(limit)));
  }
  if (axes.perspective) window.near = std::max(0.999F * window.near, nearest);
  return window;
}

float texelsNeeded(const ShadowAxes& axes, const ShadowWindow& window, const ShadowGeometry& geometry, float pixel) {
  const glm::vec2 extent = window.extent();
  // A perspective map's texels are largest where it reaches farthest; the middle of the model is what counts.
  const float depth =
      axes.perspective ? std::max(glm::dot(geometry.bounds.centre() - axes.origin, axes.forward), window.near) : 1.0F;
  return std::max(extent.x, extent.y) * depth / std::max(pixel, 1e-20F);
}

ShadowView shadowView(const ShadowAxes& axes, const ShadowWindow& window, int resolution, int layer, glm::vec2 shift,
                      const glm::vec3& centre, float facetDepth) {
  const auto texels = static_cast<float>(resolution);
  const glm::vec2 extent = window.extent();
  const glm::vec2 texel = extent / texels;
  const glm::vec2 lower = window.lower + shift * texel;
  const glm::vec2 sum = 2.0F * lower + extent;
  const glm::vec3 from = seenFrom(axes, centre);  // of the centre, what all positions are relative to
  // Rows of the matrix: what the position's offset is multiplied by, and what is added.
  const auto row = [](const glm::vec3& times, float plus) { return glm::vec4(times, plus); };
  glm::vec4 x, y, z, w;
  if (axes.perspective) {
    x = row((2.0F * axes.right - sum.x * axes.forward) / extent.x, (2.0F * from.x - sum.x * from.z) / extent.x);
    y = row((2.0F * axes.up - sum.y * axes.forward) / extent.y, (2.0F * from.y - sum.y * from.z) / extent.y);
    // Reversed with the far plane at infinity: near / depth, which a float keeps equally well everywhere.
    z = row(glm::vec3(0.0F), window.near);
    w = row(axes.forward, from.z);
  } else {
    const float range = std::max(window.far - window.near, 1e-20F);
    x = row(2.0F * axes.right / extent.x, (2.0F * from.x - sum.x) / extent.x);
    y = row(2.0F * axes.up / extent.y, (2.0F * from.y - sum.y) / extent.y);
    z = row(-axes.forward / range, (window.far - from.z) / range);
    w = row(glm::vec3(0.0F), 1.0F);
  }
  ShadowView view;
  view.clip = glm::transpose(glm::mat4(x, y, z, w));
  const glm::mat4 texelMatrix = glm::transpose(glm::mat4(0.5F * texels * (x + w), 0.5F * texels * (y + w), z, w));
  view.block.texelFromWorld = texelMatrix;
  // A plane's coefficients go with the inverse, transposed: the columns of the inverse, one a coefficient.
  const glm::dmat4 inverse = glm::inverse(glm::dmat4(texelMatrix));
  for (int i = 0; i < 3; ++i) view.block.plane.at(static_cast<std::size_t>(i)) = glm::vec4(inverse[i]);

  const float across = std::max(texel.x, texel.y);
  const float atCentre = axes.perspective ? across * std::max(from.z, window.near) : across;
  const float perDepth = axes.perspective ? 0.0F : 1.0F / std::max(window.far - window.near, 1e-20F);
  view.block.texel = {across, perDepth, facetDepth + kOffsetTexels * atCentre, static_cast<float>(layer)};
  return view;
}

}  // namespace dermis
