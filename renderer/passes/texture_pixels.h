// What must be done to an image's pixels on the CPU before the GPU can take them.
#pragma once

#include "core/image/image.h"

namespace dermis {

/// Grey to RGB, grey and alpha to RGBA, same pixel type: GL has no sRGB format of one or two channels.
[[nodiscard]] Image greyToColour(const Image& image);
/// One channel of several, counted from 0, same pixel type.
[[nodiscard]] Image onlyChannel(const Image& image, int channel);
/// RGBA, 32-bit float; integers become 0..1, missing alpha is 1.
[[nodiscard]] Image toFloatRgba(const Image& image);
/// Float to half, values past 65504 clamped.
[[nodiscard]] Image toHalf(const Image& image);
/// sRGB-encoded colours (IEC 61966-2-1) to linear ones as half floats; alpha, the fourth or second channel, stays.
[[nodiscard]] Image srgbToLinear(const Image& image);
/// Whether the blue of a normal map is something else than its z: a third of the texels far from unit length.
[[nodiscard]] bool lacksZ(const Image& image);
/// A normal map's blue made from its red and green.
[[nodiscard]] Image withZ(const Image& image);
/// Averaged down by whole pixels until neither side is over `maximumSize`; for `srgb` the average is of linear light.
[[nodiscard]] Image reduced(const Image& image, int maximumSize, bool srgb);

/// The next mip: half as large (rounded down, at least 1), each pixel the mean of four; for `srgb` of linear light.
[[nodiscard]] Image halved(const Image& image, bool srgb);

}  // namespace dermis
