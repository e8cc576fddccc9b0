// What displacing a surface along its normals needs to know of the mesh beyond its vertices: how the parametrization
// lies on it, which way each place goes, and how places that coincide agree on their height.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/scene/model.h"

namespace dermis {

/// Of one vertex, as the vertex buffer holds it.
struct DisplacementFrame {
  /// The way it is displaced: the mean of the normals of all vertices at its place, so that hard edges and seams do not
  /// tear; w: mean curvature there, ½ div(direction), per scene unit, positive where the surface bulges.
  glm::vec4 directionCurvature{0.0F, 0.0F, 1.0F, 0.0F};
  /// Surface gradients of u and v, per scene unit: the gradient of any h(u,v) is h_u · gradientU + h_v · gradientV.
  /// Means over the triangles round the vertex, weighed by area.
  glm::vec4 gradientU{0.0F};
  glm::vec4 gradientV{0.0F};
};

/// Texture coordinates that a triangle uses for the heights on its border, so that all triangles round a place agree
/// even where the coordinates are cut: Castaño 2008, "Next-Generation Rendering of Subdivision Surfaces" ("dominant"
/// edges and vertices). corner[i] at vertex i; edge[i] from vertex i + 1 to i + 2.
struct DisplacementSeam {
  std::array<glm::vec2, 3> corner{};
  std::array<std::array<glm::vec2, 2>, 3> edge{};
};

/// Of one part, for choosing a level of the map that the tessellation can follow.
struct DisplacementDensity {
  float uvPerUnit = 0.0F;  ///< root of the area in texture coordinates over the area in scene units²
  float meanEdge = 0.0F;   ///< root mean square length of its triangles' edges, scene units
};

struct DisplacementFrames {
  std::vector<DisplacementFrame> vertices;    ///< parallel to the model's
  std::vector<DisplacementDensity> parts;     ///< parallel to the model's
  std::vector<std::uint32_t> seamOfTriangle;  ///< index into `seams` plus one; 0 for triangles on no seam
  std::vector<DisplacementSeam> seams;
};

[[nodiscard]] DisplacementFrames displacementFrames(const Model& model);

}  // namespace dermis
