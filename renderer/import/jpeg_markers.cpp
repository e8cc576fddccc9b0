#include "import/jpeg_markers.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <functional>

namespace dermis::import {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kTag = "dermis-metadata\0"sv;
constexpr std::size_t kLargestPart = 60000;
constexpr std::uint8_t kStartOfScan = 0xDA, kComment = 0xFE, kApp0 = 0xE0;

/// Calls `visit(marker, payload)` for each segment from the start until the scan begins.
/// Returns where the scan's entropy-coded data may begin, or npos where the segments don't lead to one.
std::size_t visitSegments(std::string_view bytes, const std::function<void(std::uint8_t, std::string_view)>& visit) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
  std::size_t at = 2;
  while (at + 4 <= bytes.size()) {
    if (byte(at) != 0xFF) return std::string_view::npos;
    const std::uint8_t marker = byte(at + 1);
    if (marker == 0xFF) {  // fill byte
      ++at;
      continue;
    }
    if (marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8)) {  // markers without a length
      at += 2;
      continue;
    }
    const std::size_t length = static_cast<std::size_t>(byte(at + 2)) << 8U | byte(at + 3);
    if (length < 2 || at + 2 + length > bytes.size()) return std::string_view::npos;
    visit(marker, bytes.substr(at + 4, length - 2));
    at += 2 + length;
    if (marker == kStartOfScan) return at;
  }
  return std::string_view::npos;
}

bool isWhole(std::string_view bytes) {
  const std::size_t scan = visitSegments(bytes, [](std::uint8_t, std::string_view) {});
  // Inside a scan FF is always followed by 00 or a restart mark, so FF D9 can only be the end.
  return scan != std::string_view::npos && bytes.find("\xFF\xD9"sv, scan) != std::string_view::npos;
}

std::string fileBytes(const std::filesystem::path& path, std::size_t limit) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!stream || error) return bytes;
  bytes.resize(static_cast<std::size_t>(std::min<std::uintmax_t>(size, limit)));
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace

bool jpegIsWhole(std::span<const std::byte> bytes) {
  return isWhole({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

bool jpegIsWhole(const std::filesystem::path& path) { return isWhole(fileBytes(path, std::size_t{1} << 31U)); }

std::string jpegText(const std::filesystem::path& path) {
  std::string text;
  visitSegments(fileBytes(path, std::size_t{1} << 24U), [&](std::uint8_t marker, std::string_view payload) {
    if (marker == kComment && payload.starts_with(kTag)) text += payload.substr(kTag.size());
  });
  return text;
}

std::string withJpegText(std::string_view jpeg, std::string_view text) {
  if (jpeg.size() < 4) return std::string(jpeg);
  // JFIF wants its APP0 segment to stay first.
  std::size_t at = 2;
  if (static_cast<std::uint8_t>(jpeg[3]) == kApp0 && jpeg.size() > 6)
    at += 2 + (static_cast<std::size_t>(static_cast<std::uint8_t>(jpeg[4])) << 8U | static_cast<std::uint8_t>(jpeg[5]));
  if (at > jpeg.size()) return std::string(jpeg);
  std::string out(jpeg.substr(0, at));
  while (!text.empty()) {
    const std::string_view part = text.substr(0, kLargestPart);
    const std::size_t length = 2 + kTag.size() + part.size();
    out += '\xFF';
    out += static_cast<char>(kComment);
    out += static_cast<char>(length >> 8U);
    out += static_cast<char>(length & 0xFFU);
    out += kTag;
    out += part;
    text.remove_prefix(part.size());
  }
  out += jpeg.substr(at);
  return out;
}

}  // namespace dermis::import
