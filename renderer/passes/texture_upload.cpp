#include "passes/texture_upload.h"

#include <algorithm>
#include <cstring>

#include "core/image/image_tiles.h"
#include "passes/texture_pixels.h"

namespace dermis {

namespace {

struct GlFormat {
  GLenum internal, format, type;
};

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

/// One picture's levels.
std::vector<PreparedTexture::Level> prepareLevels(const std::shared_ptr<const Image>& image,
                                                  const TextureRecipe& recipe, bool& srgb, Warnings& messages) {
  // What the GPU decodes itself stays as it is; the rest becomes linear here.
  PreparedTexture::Level source = image;
  const auto becomes = [&](Image changed) { source = std::make_shared<const Image>(std::move(changed)); };
  srgb = recipe.colour.decode == TextureColour::Decode::Srgb;
  if (srgb && !recipe.channel && source->type == PixelType::U8 && source->channels <= 2) {
    becomes(greyToColour(*source));
  } else if (srgb && (recipe.channel || source->type != PixelType::U8)) {
    becomes(srgbToLinear(*source));
    srgb = false;
  } else if (recipe.colour.decode == TextureColour::Decode::Convert) {
    Image linear = toFloatRgba(*source);
    recipe.colour.convert(reinterpret_cast<float*>(linear.pixels.data()),
                          static_cast<std::size_t>(linear.width) * static_cast<std::size_t>(linear.height));
    becomes(toHalf(linear));
  }
  if (recipe.channel) becomes(onlyChannel(*source, *recipe.channel));
  // Some detail maps keep a height in the blue of a normal.
  if (recipe.isNormal && lacksZ(*source)) becomes(withZ(*source));
  if (source->width > recipe.maximumSize || source->height > recipe.maximumSize) {
    const int width = source->width;
    const int height = source->height;
    becomes(reduced(*source, recipe.maximumSize, srgb));
    messages.push_back(image->name + ": " + std::to_string(width) + " × " + std::to_string(height) +
                       " pixels is more than the graphics driver takes; reduced to " + std::to_string(source->width) +
                       " × " + std::to_string(source->height) + ".");
  }
  std::vector<PreparedTexture::Level> levels = {source};
  // Made here and not by the driver: software GL would compile a program for each format first.
  while (levels.back()->width > 1 || levels.back()->height > 1)
    levels.push_back(std::make_shared<const Image>(halved(*levels.back(), srgb)));
  return levels;
}

}  // namespace

PreparedTexture prepareTexture(const std::shared_ptr<const Image>& image, const TextureRecipe& recipe) {
  PreparedTexture prepared;
  prepared.isOneChannel = recipe.channel.has_value();
  if (image->tiles.empty()) {
    prepared.layers.push_back(prepareLevels(image, recipe, prepared.srgb, prepared.messages));
    return prepared;
  }
  prepared.isSet = true;
  for (std::size_t i = 0; i < image->tiles.size(); ++i) {
    Warnings said;
    const auto tile = std::make_shared<const Image>(tileOf(*image, i));
    prepared.layers.push_back(prepareLevels(tile, recipe, prepared.srgb, said));
    if (i == 0) prepared.messages = std::move(said);  // the same for all
  }
  return prepared;
}

TextureUpload::TextureUpload(PreparedTexture prepared, float anisotropy, const std::string& label)
    : m_prepared(std::move(prepared)) {
  const Image& first = *m_prepared.layers.front().front();
  const bool isSet = m_prepared.isSet;
  m_texture = gl::Texture::create({.target = isSet ? GLenum{GL_TEXTURE_2D_ARRAY} : GLenum{GL_TEXTURE_2D},
                                   .format = formatFor(first, m_prepared.srgb).internal,
                                   .width = first.width,
                                   .height = first.height,
                                   .depth = static_cast<int>(m_prepared.layers.size()),
                                   .levels = 0,
                                   .label = label});
  if (first.channels <= 2) {
    // Grey is grey in every channel; the second channel of a grey image is its alpha.
    const GLint alpha = m_prepared.isOneChannel ? GL_RED : first.channels == 2 ? GL_GREEN : GL_ONE;
    const GLint swizzle[4] = {GL_RED, GL_RED, GL_RED, alpha};
    glTextureParameteriv(m_texture.id(), GL_TEXTURE_SWIZZLE_RGBA, swizzle);
  }
  m_texture.setWrap(isSet ? GL_CLAMP_TO_EDGE : GL_REPEAT);
  m_texture.setAnisotropy(anisotropy);
}

bool TextureUpload::step(std::size_t bytes) {
  // So few at once that they are still in the processor's cache when the driver reads them.
  constexpr std::size_t kRowBytes = 256U << 10U;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  std::size_t sent = 0;
  while (m_layer < m_prepared.layers.size() && sent < bytes) {
    std::vector<PreparedTexture::Level>& levels = m_prepared.layers[m_layer];
    const Image& level = *levels[m_level];
    const GlFormat format = formatFor(level, m_prepared.srgb);
    const std::size_t row = level.rowBytes();
    const int rows = std::min(level.height - m_row, static_cast<int>(std::max<std::size_t>(kRowBytes / row, 1)));
    // Rows come from the top, texture coordinates count from the bottom.
    m_rows.resize(static_cast<std::size_t>(rows) * row);
    for (int i = 0; i < rows; ++i)
      std::memcpy(m_rows.data() + static_cast<std::size_t>(i) * row,
                  level.pixels.data() + static_cast<std::size_t>(level.height - 1 - m_row - i) * row, row);
    const auto mip = static_cast<GLint>(m_level);
    if (m_prepared.isSet)
      glTextureSubImage3D(m_texture.id(), mip, 0, m_row, static_cast<GLint>(m_layer), level.width, rows, 1,
                          format.format, format.type, m_rows.data());
    else
      glTextureSubImage2D(m_texture.id(), mip, 0, m_row, level.width, rows, format.format, format.type, m_rows.data());
    sent += static_cast<std::size_t>(rows) * row;
    m_row += rows;
    if (m_row < level.height) continue;
    levels[m_level].reset();
    m_row = 0;
    if (++m_level < levels.size()) continue;
    m_level = 0;
    ++m_layer;
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  return m_layer == m_prepared.layers.size();
}

}  // namespace dermis
