// The embedded head: a bust made by the program itself, from numbers alone.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/scene/model.h"

namespace dermis {

/// About 30,000, 120,000 and 500,000 triangles, with the same atlas.
enum class HeadLevel : std::uint8_t { Low, Medium, High };
/// "head-low", "head", "head-high"; empty for another name.
[[nodiscard]] std::optional<HeadLevel> headLevel(std::string_view name);

struct Head {
  /// Metres, the origin between the eyes, facing +Z. Slots face, eye, lens, hair. The face's vertices come first.
  Model model;
  /// Of the face's vertices: where they lie in the symmetrical head, millimetres, and their normals there. The regions,
  /// and noise in space, count from these.
  std::vector<glm::vec3> rest, restNormals;
  /// One unit of the face's texture coordinates on the skin.
  float millimetresPerUv = 1.0F;
};

/// Made anew: seconds. Always the same bytes, whatever the number of threads.
[[nodiscard]] Head makeHead(HeadLevel level);

/// The same, remembered while somebody holds it and kept on disk in the user's cache. Thread-safe.
[[nodiscard]] std::shared_ptr<const Head> builtinHead(HeadLevel level);

/// What a map of the face is made from.
struct HeadAtlas {
  int size = 0;
  /// Per texel, row by row from the top: rest position and normal of the skin there; covered is 0 where the atlas has
  /// none. Beyond the charts' borders the nearest place goes on for `gutter` texels (covered 1; inside a chart 2).
  std::vector<glm::vec3> rest, normals;
  std::vector<std::uint8_t> covered;
  float millimetresPerTexel = 1.0F;
};
/// Lays the face's triangles into size × size texels. Region weights of a texel: HeadRegions::at(rest).
[[nodiscard]] HeadAtlas rasteriseHead(const Head& head, int size, int gutter = 8);

}  // namespace dermis
