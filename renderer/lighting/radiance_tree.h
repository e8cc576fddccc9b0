// The light of an environment as point sources on the sphere, and as a quadtree of their sums.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lighting/radiance_image.h"

namespace dermis {

/// What a patch of the sphere sends: enough to integrate a smooth kernel against it to second order.
struct RadianceSource {
  float halfX, halfY, halfZ;  ///< half the unit vector to the patch's centre of light (halved: see ggx_prefilter.cpp)
  float variance;             ///< of the light about that centre, per tangent axis, rad²
  float red, green, blue;     ///< radiance · solid angle
  float solidAngle;           ///< sr; 0 where the patch holds no pixel
};

/// Sources sorted into the cells of a cube, with their sums in a quadtree over each face.
///
/// Every pixel is a source at its centre that carries its own solid angle, which is the sum that the accuracy figures
/// refer to. Pixels that share a cell of a 512² cube (0.2°) become one source, and sources add up to 256², 128² … 1²
/// cells. Centres are weighted by luminance, so a sun stays where it is at every level.
class RadianceTree {
 public:
  static constexpr int kLeafLevel = 8;  ///< 256 cells a side

  /// From a lat-long image or six faces. Coarser images than 1024×512 are interpolated to at least that first: their
  /// pixels would stand apart under a narrow lobe.
  explicit RadianceTree(const RadianceMap& map);

  /// Cells of a level, by face and Morton order: the children of cell i are 4i … 4i+3 of the next level.
  [[nodiscard]] std::span<const RadianceSource> level(int l) const { return m_levels[static_cast<std::size_t>(l)]; }
  /// The sources in a cell of kLeafLevel.
  [[nodiscard]] std::span<const RadianceSource> sources(std::uint32_t cell) const {
    return {m_sources.data() + m_first[cell], m_first[cell + 1] - m_first[cell]};
  }

 private:
  std::vector<RadianceSource> m_sources;
  std::vector<std::uint32_t> m_first;
  std::array<std::vector<RadianceSource>, kLeafLevel + 1> m_levels;
};

}  // namespace dermis
