// Any decoded image as light: linear Rec.709 radiance in floats.
#pragma once

#include "core/image/image.h"

namespace dermis {

/// Three float channels. 8- and 16-bit images are decoded from sRGB (IEC 61966-2-1), half and float ones are taken as
/// linear; grey is repeated, alpha dropped. Values that aren't finite stay as they are: the lighting cleans and counts.
[[nodiscard]] Image toLinearRadiance(const Image& image);

}  // namespace dermis
