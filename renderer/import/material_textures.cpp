#include "import/material_textures.h"

#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/lower_case.h"
#include "core/io/udim.h"
#include "import/model_io.h"
#include "import/text.h"

namespace dermis::import {
namespace {

/// Uncompressed texels of an aiTexture (BGRA from the top) as an uncompressed TGA file, which has the same order.
std::vector<std::byte> asTarga(const aiTexture& texture) {
  const std::size_t texels = static_cast<std::size_t>(texture.mWidth) * texture.mHeight;
  std::vector<std::byte> bytes(18 + texels * 4);
  const auto put = [&](std::size_t at, unsigned value) { bytes[at] = static_cast<std::byte>(value & 0xFFU); };
  put(2, 2);  // true colour, not compressed
  put(12, texture.mWidth);
  put(13, texture.mWidth >> 8U);
  put(14, texture.mHeight);
  put(15, texture.mHeight >> 8U);
  put(16, 32);
  put(17, 0x28);  // eight alpha bits, first row at the top
  std::memcpy(bytes.data() + 18, texture.pcData, texels * 4);
  return bytes;
}

std::string textureName(const aiTexture& texture, std::size_t index, const std::string& extension) {
  const std::string given = phrase(std::filesystem::path(texture.mFilename.C_Str()).filename().string(), 80);
  if (given.empty() || given.front() == '*') return fmt::format("image {}{}", index, extension);
  return std::filesystem::path(given).extension().empty() ? given + extension : given;
}

}  // namespace

bool TextureFinder::bind(const aiMaterial& source, std::initializer_list<aiTextureType> types, Material& material,
                         TextureSlot slot, TextureChannel channel) {
  for (const aiTextureType type : types) {
    aiString reference;
    unsigned uvSet = 0;
    if (source.GetTextureCount(type) == 0 ||
        source.GetTexture(type, 0, &reference, nullptr, &uvSet) != aiReturn_SUCCESS)
      continue;
    const std::string text = reference.C_Str();
    if (text.empty()) continue;
    const std::string path = resolve(text);
    const std::string map = std::string(textureSlotRow(slot).id);
    if (path.empty()) {
      warnOnce(fmt::format("{}: the {} map \"{}\" of material \"{}\" is not there; put it beside the model",
                           m_context.fileName, map, phrase(text, 80), material.name));
      return false;
    }
    TextureBinding& binding = material.texture(slot);
    binding.path = path;
    binding.channel = channel;
    if (uvSet != 0)
      warnOnce(fmt::format("{}: the {} map of material \"{}\" uses UV set {}, but only the first one is read",
                           m_context.fileName, map, material.name, uvSet));
    aiUVTransform transform;
    if (source.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == aiReturn_SUCCESS) {
      const float sx = transform.mScaling.x, sy = transform.mScaling.y;
      if (std::isfinite(sx) && std::isfinite(sy)) binding.uvScale = {sx, sy};
      if (transform.mTranslation.x != 0.0F || transform.mTranslation.y != 0.0F || transform.mRotation != 0.0F)
        warnOnce(
            fmt::format("{}: the {} map of material \"{}\" is moved or turned on the surface, which is not applied",
                        m_context.fileName, map, material.name));
    }
    return true;
  }
  return false;
}

std::string TextureFinder::resolve(const std::string& reference) {
  const auto [entry, isNew] = m_found.try_emplace(reference);
  if (!isNew) return entry->second;
  if (const aiTexture* texture = m_scene.GetEmbeddedTexture(reference.c_str()); texture != nullptr) {
    entry->second = embed(*texture, reference);
  } else if (reference.front() != '*') {
    std::filesystem::path found = findReferenced(m_context.folder, reference);
    // A set of UDIM tiles is where its first tile is.
    if (const auto first = firstUdimTile(reference); found.empty() && first)
      if (found = findReferenced(m_context.folder, *first); !found.empty())
        found.replace_filename(std::filesystem::path(reference).filename());
    std::error_code error;
    if (!found.empty()) entry->second = std::filesystem::absolute(found, error).lexically_normal().string();
  }
  return entry->second;
}

std::string TextureFinder::embed(const aiTexture& texture, const std::string& reference) {
  if (texture.pcData == nullptr || texture.mWidth == 0) return {};
  EmbeddedImage image;
  if (texture.mHeight == 0) {
    const auto* bytes = reinterpret_cast<const std::byte*>(texture.pcData);
    image.bytes.assign(bytes, bytes + texture.mWidth);
    std::string hint = lowerCase(std::string(texture.achFormatHint, strnlen(texture.achFormatHint, HINTMAXTEXTURELEN)));
    image.name = textureName(texture, m_model.embedded.size(), hint.empty() ? "" : "." + hint);
  } else {
    constexpr unsigned kLargestTarga = 65535;
    if (texture.mWidth > kLargestTarga || texture.mHeight > kLargestTarga) return {};
    image.bytes = asTarga(texture);
    image.name = fmt::format("image {}.tga", m_model.embedded.size());
  }
  // Another reference may already have brought the same image.
  for (std::size_t i = 0; i < m_model.embedded.size(); ++i)
    if (m_model.embedded[i].bytes == image.bytes) return fmt::format("embedded:{}", i);
  static_cast<void>(reference);
  m_model.embedded.push_back(std::move(image));
  return fmt::format("embedded:{}", m_model.embedded.size() - 1);
}

void TextureFinder::warnOnce(const std::string& sentence) {
  if (std::find(m_model.warnings.begin(), m_model.warnings.end(), sentence) == m_model.warnings.end())
    m_model.warnings.push_back(sentence);
}

}  // namespace dermis::import
