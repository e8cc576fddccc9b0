#include "passes/texture_cache.h"

#include <algorithm>
#include <cctype>

#include "colour/display_transform.h"
#include "passes/texture_pixels.h"

namespace dermis {

namespace {

struct GlFormat {
  GLenum internal, format, type;
};

bool isNormal(TextureSlot slot) { return slot == TextureSlot::Normal || slot == TextureSlot::DetailNormal; }

GlFormat formatFor(const Image& image, bool srgb) {
  constexpr GLenum kFormats[4] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  constexpr GLenum kU8[4] = {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
  constexpr GLenum kU16[4] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
  constexpr GLenum kHalf[4] = {GL_R16F, GL_RG16F, GL_RGB16F, GL_RGBA16F};
  constexpr GLenum kFloat[4] = {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
  const auto c = static_cast<std::size_t>(image.channels - 1);
  switch (image.type) {
    case PixelType::U8:
      if (srgb)
        return {image.channels == 3 ? GLenum{GL_SRGB8} : GLenum{GL_SRGB8_ALPHA8}, kFormats[c], GL_UNSIGNED_BYTE};
      return {kU8[c], kFormats[c], GL_UNSIGNED_BYTE};
    case PixelType::U16:
      return {kU16[c], kFormats[c], GL_UNSIGNED_SHORT};
    case PixelType::Half:
      return {kHalf[c], kFormats[c], GL_HALF_FLOAT};
    default:
      return {kFloat[c], kFormats[c], GL_FLOAT};
  }
}

gl::Texture uploadTexture(const Image& image, bool srgb, float anisotropy) {
  const GlFormat format = formatFor(image, srgb);
  gl::Texture texture = gl::Texture::create(
      {.format = format.internal, .width = image.width, .height = image.height, .levels = 0, .label = image.name});
  // Rows come from the top, texture coordinates count from the bottom.
  const Image flipped = flippedRows(image);
  texture.upload(0, format.format, format.type, flipped.pixels.data());
  if (image.channels <= 2) {
    // Grey is grey in every channel; the second channel of a grey image is its alpha.
    const GLint swizzle[4] = {GL_RED, GL_RED, GL_RED, image.channels == 2 ? GL_GREEN : GL_ONE};
    glTextureParameteriv(texture.id(), GL_TEXTURE_SWIZZLE_RGBA, swizzle);
  }
  texture.generateMipmaps();
  texture.setWrap(GL_REPEAT);
  texture.setAnisotropy(anisotropy);
  return texture;
}

}  // namespace

TextureCache::TextureCache(int maximumSize, float anisotropy) : m_maximumSize(maximumSize), m_anisotropy(anisotropy) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  m_maximumSize = maximumSize > 0 ? std::min(maximumSize, most) : most;
}

TextureCache::Key TextureCache::keyOf(const Image& image, const TextureBinding& binding, TextureSlot slot) {
  return {&image, binding.colorSpace.value_or(""), textureSlotRow(slot).isColour, isNormal(slot)};
}

bool TextureCache::has(const std::shared_ptr<const Image>& image, const TextureBinding& binding,
                       TextureSlot slot) const {
  return m_entries.contains(keyOf(*image, binding, slot));
}

std::shared_ptr<const gl::Texture> TextureCache::get(const std::shared_ptr<const Image>& image,
                                                     const TextureBinding& binding, TextureSlot slot,
                                                     Warnings& messages) {
  const Key key = keyOf(*image, binding, slot);
  if (const auto it = m_entries.find(key); it != m_entries.end()) return it->second.texture;

  TextureColour colour;
  Warnings warnings;
  if (auto found = textureColour(binding.colorSpace.value_or(""), textureSlotRow(slot).isColour,
                                 image->isFloatingPoint(), warnings))
    colour = *found;
  else
    messages.push_back(found.error().message);
  for (const std::string& warning : warnings) messages.push_back(image->name + ": " + warning);

  // What the GPU decodes itself stays as it is; the rest becomes linear here.
  const Image* source = image.get();
  Image changed;
  bool srgb = colour.decode == TextureColour::Decode::Srgb;
  if (srgb && source->type == PixelType::U8 && source->channels <= 2) {
    changed = greyToColour(*source);
    source = &changed;
  } else if (srgb && source->type != PixelType::U8) {
    changed = srgbToLinear(*source);
    source = &changed;
    srgb = false;
  } else if (colour.decode == TextureColour::Decode::Convert) {
    changed = toFloatRgba(*source);
    colour.convert(reinterpret_cast<float*>(changed.pixels.data()),
                   static_cast<std::size_t>(changed.width) * static_cast<std::size_t>(changed.height));
    changed = toHalf(changed);
    source = &changed;
  }
  // Some detail maps keep a height in the blue of a normal.
  if (isNormal(slot) && lacksZ(*source)) {
    changed = withZ(*source);
    source = &changed;
  }
  if (source->width > m_maximumSize || source->height > m_maximumSize) {
    const int width = source->width;
    const int height = source->height;
    changed = reduced(*source, m_maximumSize, srgb);
    source = &changed;
    messages.push_back(image->name + ": " + std::to_string(width) + " × " + std::to_string(height) +
                       " pixels is more than the graphics driver takes; reduced to " + std::to_string(source->width) +
                       " × " + std::to_string(source->height) + ".");
  }
  Entry entry{image, std::make_shared<gl::Texture>(uploadTexture(*source, srgb, m_anisotropy))};
  ++m_uploaded;
  return m_entries.emplace(key, std::move(entry)).first->second.texture;
}

void TextureCache::releaseUnused() {
  m_released += std::erase_if(m_entries, [](const auto& entry) { return entry.second.texture.use_count() == 1; });
}

}  // namespace dermis
