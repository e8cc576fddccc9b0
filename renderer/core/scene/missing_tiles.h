// Which tiles of a UDIM set a model asks for and the set doesn't have.
#pragma once

#include <vector>

#include "core/scene/resolved_scene.h"

namespace dermis {

/// Numbers of the tiles that triangles of the slot lie in, ascending, without those that its map has; 0 stands for all
/// squares outside of 1001 to 1100. Empty for maps that are no sets.
[[nodiscard]] std::vector<int> missingTiles(const ResolvedScene& scene, std::size_t slot, TextureSlot map);

/// The sentence for the log, empty where nothing is missing.
[[nodiscard]] std::string missingTilesText(const ResolvedScene& scene, std::size_t slot, TextureSlot map);

}  // namespace dermis
