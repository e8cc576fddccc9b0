// How the DFG tables are stored; lighting/dfg.glsl reads them so.
#pragma once

namespace dermis {

/// Texels a side: columns over sqrt(N·V), rows over perceptual roughness, 0 and 1 on texel centres. RG, 32-bit floats.
inline constexpr int kDfgEdge = 128;

}  // namespace dermis
