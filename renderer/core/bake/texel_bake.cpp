#include "core/bake/texel_bake.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/bake/mesh_bake.h"
#include "core/bake/parallel.h"
#include "core/bake/point_bake.h"

namespace dermis {
namespace {

/// What lies under a texel.
struct Place {
  std::uint32_t texel;
  glm::vec3 position, normal;
};

float cross2(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

/// The texels whose centres lie in each triangle, its edges included; coordinates outside 0..1 come round.
std::vector<Place> placesOf(const Model& model, int size) {
  const auto n = static_cast<std::size_t>(size);
  std::vector<std::uint32_t> placeOf(n * n, 0);  // counted from 1
  std::vector<Place> places;
  for (std::size_t t = 0; t + 2 < model.indices.size(); t += 3) {
    const glm::uvec3 corners(model.indices[t], model.indices[t + 1], model.indices[t + 2]);
    const float side = static_cast<float>(size);
    const glm::vec2 a = model.uvs[corners.x] * side, b = model.uvs[corners.y] * side, c = model.uvs[corners.z] * side;
    const float area = cross2(b - a, c - a);
    const glm::vec2 least = glm::min(a, glm::min(b, c)), most = glm::max(a, glm::max(b, c));
    // A triangle that goes round the texture more than once says nothing of any place on it.
    const glm::vec2 farthest = glm::max(-least, most);
    constexpr float kFarthest = 1e8F;
    if (area == 0.0F || most.x - least.x > side || most.y - least.y > side) continue;
    if (std::max(farthest.x, farthest.y) > kFarthest) continue;
    const int rowEnd = static_cast<int>(std::ceil(most.y)), columnEnd = static_cast<int>(std::ceil(most.x));
    for (int y = static_cast<int>(std::floor(least.y)); y < rowEnd; ++y)
      for (int x = static_cast<int>(std::floor(least.x)); x < columnEnd; ++x) {
        const glm::vec2 p = glm::vec2(x, y) + 0.5F;
        const float wb = cross2(p - a, c - a) / area, wc = cross2(b - a, p - a) / area, wa = 1.0F - wb - wc;
        if (std::min({wa, wb, wc}) < -1e-5F) continue;
        const auto column = static_cast<std::size_t>(((x % size) + size) % size);
        const auto row = static_cast<std::size_t>(size - 1 - ((y % size) + size) % size);
        const std::size_t texel = row * n + column;
        Place place{static_cast<std::uint32_t>(texel),
                    wa * model.positions[corners.x] + wb * model.positions[corners.y] + wc * model.positions[corners.z],
                    wa * model.normals[corners.x] + wb * model.normals[corners.y] + wc * model.normals[corners.z]};
        const float length = glm::length(place.normal);
        if (length < 1e-6F) continue;
        place.normal /= length;
        if (placeOf[texel] == 0) {
          places.push_back(place);
          placeOf[texel] = static_cast<std::uint32_t>(places.size());
        } else {
          places[placeOf[texel] - 1] = place;
        }
      }
  }
  return places;
}

/// Gives each texel without a value that of the nearest one with a value, in steps to the eight neighbours.
void fillBetween(std::vector<float>& values, const std::vector<Place>& places, int size) {
  std::vector<bool> known(values.size(), false);
  std::vector<std::uint32_t> front;
  for (const Place& place : places) {
    known[place.texel] = true;
    front.push_back(place.texel);
  }
  const auto n = static_cast<std::uint32_t>(size);
  for (std::vector<std::uint32_t> next; !front.empty(); front.swap(next)) {
    next.clear();
    for (const std::uint32_t at : front)
      for (std::uint32_t dy = 0; dy < 3; ++dy)
        for (std::uint32_t dx = 0; dx < 3; ++dx) {
          // The texture repeats.
          const std::uint32_t there = (at / n + n + dy - 1) % n * n + (at % n + n + dx - 1) % n;
          if (known[there]) continue;
          known[there] = true;
          values[there] = values[at];
          next.push_back(there);
        }
  }
}

}  // namespace

Result<Image> bakeTexels(const Model& model, const std::string& name, BakedMap map, const TexelBakeOptions& options) {
  if (!model.hasUvs)
    return inputError(name + " has no texture coordinates to lay a map out by; unwrap it in a modelling program first");
  const Result<RayScene> scene = RayScene::create(model, {});
  if (!scene) return tl::unexpected(scene.error());
  const std::vector<Place> places = placesOf(model, options.size);
  if (places.empty())
    return inputError(name + " covers no texel by its texture coordinates; unwrap it in a modelling program first");

  const bool thickness = map == BakedMap::Thickness;
  const RaySet rays(options.rays, thickness ? kThicknessConeDegrees : 90.0F);
  const float contact = kContactMm / options.millimetresPerUnit;
  const auto side = static_cast<std::size_t>(options.size);
  std::vector<float> values(side * side, 0.0F);
  const auto work = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Place& place = places[i];
      if (!thickness) {
        values[place.texel] = occlusionOf(hiddenSky(*scene, place.position, place.normal, rays));
        continue;
      }
      const float length = thicknessAt(*scene, place.position, place.normal, rays, contact).length;
      values[place.texel] = std::min(length * options.millimetresPerUnit, kThickestMm);
    }
  };
  const auto report = [&](float share) {
    if (options.progress != nullptr) *options.progress = share;
  };
  if (!forPieces(places.size(), 256, options.stop, work, report)) return cancelledError();
  fillBetween(values, places, options.size);

  Image image;
  image.width = image.height = options.size;
  image.channels = 1;
  image.type = PixelType::Float;
  image.pixels.resize(values.size() * sizeof(float));
  std::memcpy(image.pixels.data(), values.data(), image.pixels.size());
  return image;
}

}  // namespace dermis
