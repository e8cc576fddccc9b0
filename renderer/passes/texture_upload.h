// From a decoded image to a texture: what the CPU does first, on any thread, and the upload, in slices.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "colour/display_transform.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "gl/gl_objects.h"

namespace dermis {

/// How an image has to change before the GPU can take it.
struct TextureRecipe {
  TextureColour colour;
  bool isNormal = false;
  std::optional<int> channel;  ///< the only one that is read and kept, of the three or four that the image has
  int maximumSize = 0;
};

/// Levels as the GPU takes them, but for the order of their rows: the first is the highest, as in any image.
struct PreparedTexture {
  using Level = std::shared_ptr<const Image>;
  std::vector<std::vector<Level>> layers;  ///< each with its levels: one, or one a UDIM tile
  bool isSet = false;                      ///< an array texture, else a plain one
  bool srgb = false;                       ///< the GPU decodes
  bool isOneChannel = false;               ///< whichever is asked for
  Warnings messages;
};
/// Slow for a large image; touches no OpenGL. An image that may stay as it is becomes the first level itself.
[[nodiscard]] PreparedTexture prepareTexture(const std::shared_ptr<const Image>& image, const TextureRecipe& recipe);

/// A texture on its way to the GPU.
class TextureUpload {
 public:
  TextureUpload(PreparedTexture prepared, float anisotropy, const std::string& label);
  /// Sends about `bytes` more; true when all is there.
  bool step(std::size_t bytes);
  [[nodiscard]] gl::Texture take() { return std::move(m_texture); }

 private:
  PreparedTexture m_prepared;
  gl::Texture m_texture;
  std::vector<std::byte> m_rows;  ///< some of a level, first row lowest
  std::size_t m_layer = 0, m_level = 0;
  int m_row = 0;
};

}  // namespace dermis
