// The file's materials as slots in `metallic_roughness`.
#pragma once

#include <assimp/scene.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/model.h"

namespace dermis::import {

/// Where a file's textures are looked for.
struct TextureContext {
  std::filesystem::path folder;  ///< of the model
  std::string fileName;          ///< for messages
  bool gltf = false;             ///< packed metallic-roughness, UVs wrapped as glTF says
};

/// Fills Model::slots (one for each of `materials`, indices in aiScene::mMaterials, in that order) and
/// Model::embedded (only images that a slot uses). A texture that cannot be found is a warning.
void addSlots(Model& model, const aiScene& scene, const std::vector<unsigned>& materials,
              const TextureContext& context);

}  // namespace dermis::import
