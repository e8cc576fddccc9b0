// A material's textures: found on disk or inside the model.
#pragma once

#include <assimp/scene.h>

#include <initializer_list>
#include <map>
#include <string>

#include "core/scene/model.h"
#include "import/model_materials.h"

namespace dermis::import {

/// Resolves texture references of one file; remembers what it has already found, taken or warned of.
class TextureFinder {
 public:
  TextureFinder(Model& model, const aiScene& scene, const TextureContext& context)
      : m_model(model), m_scene(scene), m_context(context) {}

  /// Binds the first of `types` that the material has to the slot. True where a texture was found.
  bool bind(const aiMaterial& source, std::initializer_list<aiTextureType> types, Material& material, TextureSlot slot,
            TextureChannel channel = TextureChannel::R);

 private:
  /// Absolute path, `embedded:N`, or empty.
  std::string resolve(const std::string& reference);
  std::string embed(const aiTexture& texture, const std::string& reference);
  void warnOnce(const std::string& sentence);

  Model& m_model;
  const aiScene& m_scene;
  const TextureContext& m_context;
  std::map<std::string, std::string> m_found;
};

}  // namespace dermis::import
