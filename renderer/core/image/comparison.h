// How far apart two images are: per channel, and as a person would see it.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"

namespace dermis {

struct Comparison {
  double mean = 0.0;           ///< mean absolute channel difference
  double maximum = 0.0;        ///< largest one; infinity where a value is NaN or infinite in one image alone
  double failing = 0.0;        ///< share of the pixels with a channel past the tolerance
  double flip = 0.0;           ///< mean FLIP, 0 alike … 1 apart
  std::vector<float> flipMap;  ///< one value a pixel, row by row from the top
  int width = 0, height = 0;
};

/// Values as stored: integers as 0..1, floats as they are. Where only one image has alpha, the other counts as opaque;
/// grey counts as three equal channels. Errors: Input, where the sizes differ.
[[nodiscard]] Result<Comparison> compareImages(const Image& a, const Image& b, double tolerance);

/// Channel c (0..3) of every pixel as a float: grey repeated, a missing alpha 1.
[[nodiscard]] std::vector<float> channelValues(const Image& image, int c);

/// LDR-FLIP of two display-encoded (sRGB) pictures, values clamped to 0..1, at 67 pixels a degree: Andersson, Nilsson,
/// Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG 2020.
/// `a` and `b` hold the three channels one after the other.
[[nodiscard]] std::vector<float> flipMap(const std::vector<float> (&a)[3], const std::vector<float> (&b)[3], int width,
                                         int height);

/// The map as an 8-bit RGB picture, dark (alike) to bright yellow (apart).
[[nodiscard]] Image heatMap(const std::vector<float>& map, int width, int height);

}  // namespace dermis
