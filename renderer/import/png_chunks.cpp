#include "import/png_chunks.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "import/image_source.h"

namespace dermis::import {
namespace {

constexpr std::size_t kSignatureBytes = 8;

/// The CRC of ISO 3309, four bits at a time (PNG, annex D).
std::uint32_t checksum(std::string_view bytes) {
  static constexpr auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int k = 0; k < 8; ++k) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
      table[n] = c;
    }
    return table;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes) crc = kTable[(crc ^ static_cast<std::uint8_t>(byte)) & 0xFFU] ^ (crc >> 8U);
  return crc ^ 0xFFFFFFFFU;
}

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

/// What the header chunk must be (PNG, §11.2.2); empty, or what is wrong.
std::string headerFault(std::string_view data) {
  if (data.size() != 13) return "its header has the wrong length";
  const std::uint32_t width = word(data, 0), height = word(data, 4);
  if (width == 0 || height == 0)
    return fmt::format("the image has {} x {} pixels, so there is nothing to show", width, height);
  if (width > kLargestSide || height > kLargestSide)
    return fmt::format("the header says {} x {} pixels, past the limit of {} a side", width, height, kLargestSide);
  const int depth = static_cast<unsigned char>(data[8]), type = static_cast<unsigned char>(data[9]);
  const bool small = depth == 1 || depth == 2 || depth == 4;
  const bool good = type == 0   ? small || depth == 8 || depth == 16
                    : type == 3 ? small || depth == 8
                                : (type == 2 || type == 4 || type == 6) && (depth == 8 || depth == 16);
  if (!good || data[10] != 0 || data[11] != 0 || data[12] < 0 || data[12] > 1)
    return "its header has values that PNG doesn't know";
  return {};
}

/// A transparency chunk of the length that the colour type asks for.
bool transparencyFits(int colourType, std::size_t length, std::size_t paletteEntries) {
  return colourType == 0   ? length == 2
         : colourType == 2 ? length == 6
                           : colourType == 3 && length >= 1 && length <= paletteEntries;
}

bool isText(std::string_view type) { return type == "tEXt" || type == "zTXt" || type == "iTXt"; }

}  // namespace

Result<std::string> checkedPng(std::string_view bytes, const std::string& name, bool withTexts) {
  const auto damaged = [&](const std::string& what) {
    return inputError(fmt::format("{}: not readable as png: {}; export or download it again", name, what));
  };
  std::string out(bytes.substr(0, kSignatureBytes));
  int colourType = -1;
  std::size_t palette = 0;
  enum class Pixels { None, Running, Over } pixels = Pixels::None;
  for (std::size_t at = kSignatureBytes;;) {
    if (at + 12 > bytes.size() || word(bytes, at) > bytes.size() - at - 12)
      return damaged(fmt::format("it is cut off at byte {}", bytes.size()));
    const std::size_t length = word(bytes, at);
    const std::string_view type = bytes.substr(at + 4, 4);
    const std::string_view data = bytes.substr(at + 8, length);
    const std::string_view chunk = bytes.substr(at, length + 12);
    if (checksum(bytes.substr(at + 4, length + 4)) != word(bytes, at + 8 + length))
      return damaged(fmt::format("it is damaged after byte {}", at));
    at += chunk.size();

    const bool first = colourType < 0;
    if (first != (type == "IHDR")) return damaged("its header is missing or comes twice");
    if (pixels == Pixels::Running && type != "IDAT") pixels = Pixels::Over;
    bool keep = false;
    if (type == "IHDR") {
      if (const std::string fault = headerFault(data); !fault.empty()) return damaged(fault);
      colourType = static_cast<unsigned char>(data[9]);
      keep = true;
    } else if (type == "PLTE") {
      keep = palette == 0 && pixels == Pixels::None && length % 3 == 0 && length >= 3 && length <= 768 &&
             (colourType & 2) != 0;
      if (colourType == 3 && !keep) return damaged("its palette cannot be used");
      if (keep) palette = length / 3;
    } else if (type == "tRNS") {
      keep = pixels == Pixels::None && transparencyFits(colourType, length, palette);
    } else if (type == "IDAT") {
      if (colourType == 3 && palette == 0) return damaged("its palette is missing");
      keep = pixels != Pixels::Over;
      pixels = pixels == Pixels::None ? Pixels::Running : pixels;
    } else if (type == "IEND") {
      if (pixels == Pixels::None) return damaged("it holds no pixels");
      return out + std::string(chunk);
    } else {
      keep = withTexts && isText(type);
    }
    if (keep) out += chunk;
  }
}

}  // namespace dermis::import
