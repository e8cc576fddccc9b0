#include "import/tiff_text.h"

#include <cstdint>
#include <fstream>

namespace dermis::import {
namespace {

constexpr std::uint16_t kImageDescription = 270, kAscii = 2;
constexpr std::uint64_t kLongestText = std::uint64_t{64} << 20U;

/// Reads numbers of a TIFF file in its own byte order.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : m_stream(path, std::ios::binary) {
    m_big = m_stream.get() == 'M';
    m_stream.get();
  }
  void seek(std::uint64_t at) { m_stream.seekg(static_cast<std::streamoff>(at)); }
  std::uint64_t number(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) {
      const auto byte = static_cast<std::uint64_t>(m_stream.get() & 0xFF);
      value = m_big ? value << 8U | byte : value | byte << (8U * static_cast<unsigned>(i));
    }
    return value;
  }
  std::string text(std::uint64_t length) {
    std::string out(length, '\0');
    m_stream.read(out.data(), static_cast<std::streamsize>(length));
    return m_stream ? out : std::string();
  }
  [[nodiscard]] bool good() const { return m_stream.good(); }
  [[nodiscard]] std::uint64_t at() { return static_cast<std::uint64_t>(m_stream.tellg()); }

 private:
  std::ifstream m_stream;
  bool m_big = false;
};

}  // namespace

std::string tiffDescription(const std::filesystem::path& path) {
  Reader reader(path);
  // BigTIFF (version 43) has 8-byte offsets and counts where TIFF 6.0 has 4.
  const bool wide = reader.number(2) == 43;
  const int offsetBytes = wide ? 8 : 4;
  if (wide) reader.number(4);
  reader.seek(reader.number(offsetBytes));
  const std::uint64_t entries = reader.number(wide ? 8 : 2);
  for (std::uint64_t i = 0; i < entries && i < 4096 && reader.good(); ++i) {
    const std::uint64_t tag = reader.number(2);
    const std::uint64_t type = reader.number(2);
    const std::uint64_t count = reader.number(offsetBytes);
    if (tag == kImageDescription && type == kAscii && count > 0 && count <= kLongestText) {
      if (count > static_cast<std::uint64_t>(offsetBytes)) reader.seek(reader.number(offsetBytes));
      std::string text = reader.text(count);
      while (!text.empty() && text.back() == '\0') text.pop_back();
      return text;
    }
    reader.number(offsetBytes);
  }
  return {};
}

}  // namespace dermis::import
