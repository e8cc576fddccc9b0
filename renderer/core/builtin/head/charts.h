// Where the skin is cut so that it can be laid flat, and the atlas of its pieces.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/builtin/head/polygonise.h"
#include "core/builtin/head/sculpt.h"

namespace dermis::sculpt {

/// The pieces. L is the side of +x. What is hidden behind lids and inside nostrils has pieces of its own.
enum class Chart : std::uint8_t {
  Face,  ///< with skull, neck and shoulders; cut at the back, from the crown down
  EarFrontL,
  EarFrontR,
  EarBackL,
  EarBackR,
  Base,
  SocketFrontL,
  SocketFrontR,
  SocketBackL,
  SocketBackR,
  NostrilL,
  NostrilR
};
inline constexpr std::size_t kChartCount = 12;
/// Texels a mm of this chart over those of the face's.
[[nodiscard]] float chartScale(Chart chart);

/// A surface with an atlas. A point on a seam has several vertices.
struct AtlasMesh {
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> pointOf;  ///< of each vertex
  std::vector<glm::vec2> uvs;          ///< of each vertex
  std::vector<glm::uvec3> triangles;   ///< of vertices
  std::vector<Chart> charts;           ///< of each triangle
  float millimetresPerUv = 1.0F;       ///< on the face
};

/// Cuts, flattens and packs. A piece that is no disc, because the sculpt has changed too much for the cuts, is
/// projected instead: its texture coordinates overlap.
[[nodiscard]] AtlasMesh unwrap(const Surface& surface, const Sculpt& sculpt);

}  // namespace dermis::sculpt
