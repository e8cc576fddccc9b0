// An image file opened for reading: its kind told from its first bytes, its header checked before anything is
// allocated.
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"

namespace dermis::import {

/// Pixels a side past which a file is taken to lie.
inline constexpr int kLargestSide = 1 << 17;

/// Where the bytes are while OpenImageIO reads them: a file, or memory (through a proxy, or, for formats that read
/// only named files, through an anonymous file).
class ImageSource {
 public:
  /// `withTexts`: keep what metadata the format has, for inspection.
  static Result<ImageSource> open(const std::filesystem::path& path, bool withTexts = false);
  /// `bytes` must outlive the source.
  static Result<ImageSource> open(std::span<const std::byte> bytes, const std::string& name);

  ImageSource(ImageSource&&) noexcept = default;
  ImageSource& operator=(ImageSource&&) = delete;
  ~ImageSource();

  [[nodiscard]] OIIO::ImageInput& input() const { return *m_input; }
  /// Header of the first sub-image; width, height and channels are within the limits.
  [[nodiscard]] const OIIO::ImageSpec& spec() const { return m_spec; }
  [[nodiscard]] const std::string& format() const { return m_format; }
  [[nodiscard]] const std::string& name() const { return m_name; }
  /// The library's last words as part of a sentence.
  [[nodiscard]] std::string lastMessage() const;

 private:
  ImageSource() = default;
  Result<void> startPng(std::string_view bytes, bool withTexts);
  Result<void> start(const std::string& openName, OIIO::Filesystem::IOProxy* proxy);
  [[nodiscard]] Result<void> checkHeader() const;

  std::string m_name;
  std::string m_format;
  std::uintmax_t m_bytes = 0;
  int m_anonymousFile = -1;
  std::unique_ptr<std::string>
      m_owned;  ///< bytes that m_memory reads; on the heap, so that a move leaves them in place
  std::unique_ptr<OIIO::Filesystem::IOMemReader> m_memory;
  std::unique_ptr<OIIO::ImageInput> m_input;
  OIIO::ImageSpec m_spec;
};

/// OpenImageIO's name of the format that the first bytes announce, else that of the name's extension, else empty.
[[nodiscard]] std::string imageFormat(std::span<const std::byte> head, const std::string& name);

}  // namespace dermis::import
