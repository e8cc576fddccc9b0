// The finest relief of skin as a tile that repeats: what a map of the whole head has no texels for.
#pragma once

#include "core/image/image.h"

namespace dermis::skin {

/// A side of the tile on the skin.
inline constexpr float kDetailTileMm = 40.0F;

/// Normals, +Y, 8 bit, 512 texels a side, true to size where the tile covers kDetailTileMm: the net of furrows in two
/// sizes, and pores.
[[nodiscard]] Image makeSkinDetail();

}  // namespace dermis::skin
