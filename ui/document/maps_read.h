// Which maps a shading model reads.
#pragma once

#include "core/material/shading_model.h"
#include "core/material/texture_slot.h"

namespace dermis {

/// Whether a shading model reads a map.
[[nodiscard]] bool readsMap(ShadingModel model, TextureSlot slot);

}  // namespace dermis
