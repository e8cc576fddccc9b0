#include "passes/data_window.h"

namespace dermis {

PixelArea dataWindow(const CameraMatrices& unjittered, const Bounds& bounds, glm::ivec2 size,
                     const RenderTargets& kept) {
  // Whole tiles of llvmpipe, and whole quads of any driver: derivatives come out as in the whole picture.
  constexpr int kTile = 64;
  const PixelArea needed = screenArea(unjittered, bounds, size);
  PixelArea part{needed.lower / kTile * kTile, glm::min((needed.upper + kTile - 1) / kTile * kTile, size)};
  const auto pixelsOf = [](glm::ivec2 extent) { return static_cast<double>(extent.x) * extent.y; };
  if (kept.isCropped() && kept.size() == size) {
    const PixelArea& old = kept.dataWindow();
    // A little too large costs less than other images.
    if (old.holds(part) && pixelsOf(old.extent()) < 2.0 * pixelsOf(part.extent())) return old;
    if (!old.holds(part)) part = {glm::min(part.lower, old.lower), glm::max(part.upper, old.upper)};
  }
  constexpr double kWorthwhile = 0.7;
  const bool isEmpty = part.extent().x < 1 || part.extent().y < 1;
  return isEmpty || pixelsOf(part.extent()) > kWorthwhile * pixelsOf(size) ? PixelArea{glm::ivec2(0), size} : part;
}

std::vector<PixelArea> areasAround(const PixelArea& part, glm::ivec2 size) {
  return {{{0, 0}, {size.x, part.lower.y}},
          {{0, part.upper.y}, size},
          {{0, part.lower.y}, {part.lower.x, part.upper.y}},
          {{part.upper.x, part.lower.y}, {size.x, part.upper.y}}};
}

}  // namespace dermis
