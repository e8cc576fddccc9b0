// Where a light's shadow map looks from and how far it reaches: geometry only, no OpenGL.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/scene/model.h"
#include "lighting/light_point.h"

namespace dermis {

/// A model as a few hundred boxes, and how far its triangles lie below the surface that its normals describe.
struct ShadowGeometry {
  std::vector<Bounds> boxes;  ///< together they hold every triangle
  Bounds bounds;
  /// A facet of length e on a surface of radius of curvature R lies up to e²/(6R) below it. From there its neighbours
  /// hide a low light that the smooth normal still faces, in steps as large as the facets; a shadow is asked for from
  /// this far above (after Hanika 2021, "Hacking the Shadow Terminator"). Scene units; 19 of 20 edges have less.
  float facetDepth = 0.0F;

  [[nodiscard]] static ShadowGeometry of(const Model& model);
};

/// An eye of a light: an origin, or only a direction.
struct ShadowAxes {
  glm::vec3 origin{0.0F};
  glm::vec3 right{1.0F, 0.0F, 0.0F}, up{0.0F, 1.0F, 0.0F}, forward{0.0F, 0.0F, -1.0F};
  bool perspective = true;
  bool cubeFace = false;
  bool operator==(const ShadowAxes&) const = default;
};

/// What a map covers: lengths across a parallel map, tangents across a perspective one; depths are scene units.
struct ShadowWindow {
  glm::vec2 lower{0.0F}, upper{0.0F};
  float near = 0.0F, far = 1.0F;

  [[nodiscard]] bool empty() const { return !(lower.x < upper.x && lower.y < upper.y); }
  [[nodiscard]] bool contains(const ShadowWindow& other) const;
  [[nodiscard]] glm::vec2 extent() const { return upper - lower; }
  bool operator==(const ShadowWindow&) const = default;
};

/// The eyes that a light needs: one, or the six faces of a cube for a light between what it lights; none where the
/// light reaches nothing.
[[nodiscard]] std::vector<ShadowAxes> shadowAxes(const LightPoint& light, const ShadowGeometry& geometry);

/// What one of them must cover: the boxes that `viewProjection` (the camera's, reversed depth) may show, as far as the
/// light's cone reaches. Depths hold every caster, wherever it is.
[[nodiscard]] ShadowWindow shadowWindow(const ShadowAxes& axes, const LightPoint& light, const ShadowGeometry& geometry,
                                        const glm::mat4& viewProjection);

/// Texels across the longer side of `window` that are no larger than a pixel, which is `pixel` scene units wide.
[[nodiscard]] float texelsNeeded(const ShadowAxes& axes, const ShadowWindow& window, const ShadowGeometry& geometry,
                                 float pixel);

/// The C++ twin of ShadowView in shadows.glsl (std140).
struct ShadowViewBlock {
  glm::mat4 texelFromWorld{1.0F};  ///< of a position relative to the centre
  std::array<glm::vec4, 3> plane;  ///< a world plane's first three coefficients in texels and depth
  glm::vec4 texel{0.0F};           ///< see shadows.glsl
};

struct ShadowView {
  glm::mat4 clip{1.0F};  ///< of a position relative to the centre; depth reversed in 0..1, w > 0 in front
  ShadowViewBlock block;
};

/// Matrices for a window of `resolution`² texels in layer `layer`, its grid moved by `shift` (−½..½ texels). Positions
/// are taken relative to `centre`, so that a distant light costs no digits.
[[nodiscard]] ShadowView shadowView(const ShadowAxes& axes, const ShadowWindow& window, int resolution, int layer,
                                    glm::vec2 shift, const glm::vec3& centre, float facetDepth);

}  // namespace dermis
