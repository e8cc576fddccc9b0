#include "core/scene/missing_tiles.h"

#include <algorithm>
#include <set>

#include "core/image/image_tiles.h"

namespace dermis {

std::vector<int> missingTiles(const ResolvedScene& scene, std::size_t slot, TextureSlot map) {
  const ResolvedMaterial& material = scene.slots.at(slot);
  const auto& image = material.images.at(static_cast<std::size_t>(map));
  const Model& model = *scene.model;
  if (!image || image->tiles.empty() || !model.hasUvs) return {};
  const TextureBinding& binding = material.material.texture(map);
  const glm::vec2 scale(binding.uvScale[0], binding.uvScale[1]);
  // A large mesh is looked at in steps: a square has many triangles.
  constexpr std::size_t kMostTriangles = 200000;
  std::set<int> missing;
  for (const ModelPart& part : model.parts) {
    if (part.slot != slot) continue;
    const std::size_t step = std::max<std::size_t>(part.indexCount / 3 / kMostTriangles, 1);
    for (std::size_t i = 0; i + 2 < part.indexCount; i += 3 * step) {
      const auto uv = [&](std::size_t corner) {
        return model.uvs[model.indices[part.firstIndex + i + corner]] * scale;
      };
      const glm::vec2 a = uv(0), b = uv(1), c = uv(2);
      const glm::vec2 lower = glm::floor(glm::min(a, glm::min(b, c)));
      const glm::vec2 upper = glm::floor(glm::max(a, glm::max(b, c)));
      // One that lies in a square has its middle there; a larger one is looked at in a grid.
      const int steps = lower == upper ? 1 : 12;
      for (int j = 0; j < steps; ++j)
        for (int k = 0; k < steps - j; ++k) {
          const glm::vec2 share = (glm::vec2(j, k) + 1.0F / 3.0F) / static_cast<float>(steps);
          const glm::vec2 at = a + share.x * (b - a) + share.y * (c - a);
          if (!tilePlace(*image, at)) missing.insert(udimNumber(glm::ivec2(glm::floor(at))).value_or(0));
        }
    }
  }
  return {missing.begin(), missing.end()};
}

std::string missingTilesText(const ResolvedScene& scene, std::size_t slot, TextureSlot map) {
  const std::vector<int> missing = missingTiles(scene, slot, map);
  if (missing.empty()) return {};
  std::string list;
  for (const int number : missing)
    list += (list.empty() ? "" : ", ") +
            (number == 0 ? std::string("squares outside of 1001 to 1100") : std::to_string(number));
  const Image& image = *scene.slots.at(slot).images.at(static_cast<std::size_t>(map));
  return image.name + " has no tile for " + list + ", where " + scene.model->slots.at(slot).name +
         " has texture coordinates; the map is left out there";
}

}  // namespace dermis
