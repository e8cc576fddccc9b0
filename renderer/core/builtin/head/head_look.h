// What the embedded head wears as long as nobody says otherwise.
#pragma once

#include <array>
#include <string_view>

#include "core/scene/model.h"

namespace dermis {

/// The slots `face`, `eye`, `lens`, `hair` with their materials: the face in the maps made for it, of a size at which a
/// texel is about a pixel where the head fills a window.
[[nodiscard]] std::array<ModelSlot, 4> headSlots();

/// Whether a map is laid out for the embedded head and means nothing on another model.
[[nodiscard]] bool isHeadMap(std::string_view reference);

}  // namespace dermis
