// The environment itself as a cube map.
#pragma once

#include <vector>

#include "lighting/radiance_image.h"

namespace dermis {

/// Texels a side for an image with so many pixels across a quarter turn: `maximum` at most.
[[nodiscard]] int sharpFaceSize(int pixelsPerFace, int maximum);

/// Resamples to faceSize² texels a face: bilinear where the image is coarser, area-averaged where it is finer. RGB and
/// 1 interleaved, [face][row][column].
[[nodiscard]] std::vector<float> resampleToCube(const RadianceMap& map, int faceSize);

/// The next mip level of such a cube: the mean of each four texels, weighted by their solid angle.
[[nodiscard]] std::vector<float> halveCube(const std::vector<float>& rgba, int faceSize);

}  // namespace dermis
