// Which part of a picture is worth keeping images of.
#pragma once

#include "passes/camera_matrices.h"
#include "passes/render_targets.h"

namespace dermis {

/// The part that holds `bounds` wherever a sample's jitter moves them, on the tiles of a rasteriser; as large as what
/// `kept` holds already where that is enough, so that a turntable doesn't make its images again with every picture.
/// All of the picture where little would be saved.
[[nodiscard]] PixelArea dataWindow(const CameraMatrices& unjittered, const Bounds& bounds, glm::ivec2 size,
                                   const RenderTargets& kept);

/// What of a picture of `size` lies around a part of it: four rectangles, some of them empty.
[[nodiscard]] std::vector<PixelArea> areasAround(const PixelArea& part, glm::ivec2 size);

}  // namespace dermis
