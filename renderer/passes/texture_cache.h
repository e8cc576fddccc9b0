// Material maps on the GPU: each image once for each way of reading its colours, dropped when no material uses it.
#pragma once

#include <deque>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/material/texture_slot.h"
#include "gl/gl_objects.h"
#include "passes/texture_upload.h"

namespace dermis {

class TextureCache {
 public:
  /// `maximumSize` 0: what the driver takes. `anisotropy`: samples along the long side of a pixel's footprint.
  TextureCache(int maximumSize, float anisotropy);

  /// Large images are made ready beside and sent in slices, so that no frame waits for them: asks for one. True where
  /// step() has something to do for it; false where it is there, or small enough to be uploaded by get().
  bool request(const std::shared_ptr<const Image>& image, const TextureBinding& binding, TextureSlot slot,
               Warnings& messages);
  [[nodiscard]] bool pending() const { return !m_pending.empty(); }
  /// A slice of what was asked for; true when nothing is left.
  bool step(Warnings& messages);
  /// 0..1 of all that has been asked for since nothing was.
  [[nodiscard]] double fraction() const;
  /// Drops what was asked for and isn't there.
  void forgetPending();

  /// The image as a texture with mips, uploaded at the first call; null while it is pending. sRGB colour is decoded by
  /// the texture's format; 16-bit and float images in sRGB or another colour space are converted to linear Rec.709
  /// here. Of an image with colours a slot that reads a single channel gets that alone, a quarter of the bytes. Images
  /// larger than the limit are averaged down, with a message.
  /// `asArray`: sets of UDIM tiles are array textures, a layer a tile; others are seen as one of a single layer.
  [[nodiscard]] std::shared_ptr<const gl::Texture> get(const std::shared_ptr<const Image>& image,
                                                       const TextureBinding& binding, TextureSlot slot,
                                                       Warnings& messages, bool asArray = false);
  /// Whether get() would have to upload.
  [[nodiscard]] bool has(const std::shared_ptr<const Image>& image, const TextureBinding& binding,
                         TextureSlot slot) const;

  /// Drops textures that nobody but the cache holds.
  void releaseUnused();

  [[nodiscard]] std::size_t resident() const { return m_entries.size(); }
  [[nodiscard]] std::uint64_t uploaded() const { return m_uploaded; }
  [[nodiscard]] std::uint64_t released() const { return m_released; }

 private:
  /// The image's address, the colour space asked for, whether the slot is a colour's or a normal's, and the channel
  /// that is kept alone.
  using Key = std::tuple<const Image*, std::string, bool, bool, std::optional<int>>;
  struct Entry {
    std::shared_ptr<const Image> image;  ///< held, so that its address stays its name
    std::shared_ptr<const gl::Texture> texture;
    std::shared_ptr<const gl::Texture> array;  ///< the same as an array, once somebody asked
  };
  /// A texture of an entry.
  [[nodiscard]] static std::shared_ptr<const gl::Texture> shown(Entry& entry, bool asArray);
  struct Pending {
    Key key;
    std::shared_ptr<const Image> image;
    TextureRecipe recipe;
    std::future<PreparedTexture> prepared;
    std::optional<TextureUpload> upload;
  };
  [[nodiscard]] TextureRecipe recipeFor(const Image& image, const TextureBinding& binding, TextureSlot slot,
                                        Warnings& messages) const;
  [[nodiscard]] static Key keyOf(const Image& image, const TextureBinding& binding, TextureSlot slot);

  std::map<Key, Entry> m_entries;
  std::deque<Pending> m_pending;
  std::size_t m_asked = 0;  ///< since nothing was pending
  int m_maximumSize;
  float m_anisotropy;
  std::uint64_t m_uploaded = 0, m_released = 0;
};

}  // namespace dermis
