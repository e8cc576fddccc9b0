#include "passes/data_window.h"

#include <algorithm>

namespace dermis {

PixelArea dataWindow(const CameraMatrices& unjittered, const Bounds& bounds, glm::ivec2 size,
                     const RenderTargets& kept) {
  // Whole tiles of llvmpipe, and whole quads of any driver: derivatives come out as in the whole picture.
  constexpr int kTile = 64;
  const PixelArea needed = screenArea(unjittered, bounds, size);
  PixelArea part{needed.lower / kTile * kTile, glm::min((needed.upper + kTile - 1) / kTile * kTile, size)};
  const auto pixelsOf = [](glm::ivec2 extent) { return static_cast<double>(extent.x) * extent.y; };
  const double most = 0.7 * pixelsOf(size);  // of which less is worth the trouble
  if (kept.isCropped() && kept.size() == size) {
    // A little too large costs less than other images. What comes out must come out again when it is what is kept: the
    // next sample of the same picture asks too, and other images would begin it anew.
    const PixelArea& old = kept.dataWindow();
    const PixelArea both{glm::min(part.lower, old.lower), glm::max(part.upper, old.upper)};
    if (pixelsOf(both.extent()) < std::min(2.0 * pixelsOf(part.extent()), most)) part = both;
  }
  const bool isEmpty = part.extent().x < 1 || part.extent().y < 1;
  return isEmpty || pixelsOf(part.extent()) > most ? PixelArea{glm::ivec2(0), size} : part;
}

std::vector<PixelArea> areasAround(const PixelArea& part, glm::ivec2 size) {
  return {{{0, 0}, {size.x, part.lower.y}},
          {{0, part.upper.y}, size},
          {{0, part.lower.y}, {part.lower.x, part.upper.y}},
          {{part.upper.x, part.lower.y}, {size.x, part.upper.y}}};
}

}  // namespace dermis
