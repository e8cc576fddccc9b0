// Material maps on the GPU: each image once for each way of reading its colours, dropped when no material uses it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/material/texture_slot.h"
#include "gl/gl_objects.h"

namespace dermis {

class TextureCache {
 public:
  /// `maximumSize` 0: what the driver takes. `anisotropy`: samples along the long side of a pixel's footprint.
  TextureCache(int maximumSize, float anisotropy);

  /// The image as a texture with mips, uploaded at the first call. sRGB colour is decoded by the texture's format;
  /// 16-bit and float images in sRGB or another colour space are converted to linear Rec.709 here. Images larger than
  /// the limit are averaged down, with a message.
  [[nodiscard]] std::shared_ptr<const gl::Texture> get(const std::shared_ptr<const Image>& image,
                                                       const TextureBinding& binding, TextureSlot slot,
                                                       Warnings& messages);
  /// Whether get() would have to upload.
  [[nodiscard]] bool has(const std::shared_ptr<const Image>& image, const TextureBinding& binding,
                         TextureSlot slot) const;

  /// Drops textures that nobody but the cache holds.
  void releaseUnused();

  [[nodiscard]] std::size_t resident() const { return m_entries.size(); }
  [[nodiscard]] std::uint64_t uploaded() const { return m_uploaded; }
  [[nodiscard]] std::uint64_t released() const { return m_released; }

 private:
  /// The image's address, the colour space asked for, and whether the slot is a colour's or a normal's.
  using Key = std::tuple<const Image*, std::string, bool, bool>;
  struct Entry {
    std::shared_ptr<const Image> image;  ///< held, so that its address stays its name
    std::shared_ptr<const gl::Texture> texture;
  };
  [[nodiscard]] static Key keyOf(const Image& image, const TextureBinding& binding, TextureSlot slot);

  std::map<Key, Entry> m_entries;
  int m_maximumSize;
  float m_anisotropy;
  std::uint64_t m_uploaded = 0, m_released = 0;
};

}  // namespace dermis
