#include "core/io/png_writer.h"

#include <png.h>
#include <zlib.h>

#include <bit>
#include <csetjmp>
#include <string_view>
#include <vector>

#include "core/base/file_io.h"

namespace dermis {
namespace {

/// Runs and Huffman codes alone, over differences from the row above: pictures hold few longer repeats, so files are as
/// small as at deflate's level 3 (the built-in look a tenth smaller, its colour map a twentieth larger) in half its
/// time.
constexpr int kStrategy = Z_RLE;
constexpr int kFilter = PNG_FILTER_UP;

int colourType(int channels) {
  switch (channels) {
    case 1:
      return PNG_COLOR_TYPE_GRAY;
    case 2:
      return PNG_COLOR_TYPE_GRAY_ALPHA;
    case 3:
      return PNG_COLOR_TYPE_RGB;
    default:
      return PNG_COLOR_TYPE_RGB_ALPHA;
  }
}

void append(png_structp png, png_bytep data, png_size_t length) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(std::bit_cast<const char*>(data), length);
}

/// libpng reports by longjmp: everything with a destructor lives in the caller.
bool encode(png_structp png, png_infop info, const Image& image, std::vector<png_bytep>& rows,
            std::vector<png_text>& texts, std::string& bytes) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT: libpng's interface
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_compression_strategy(png, kStrategy);
  png_set_filter(png, 0, kFilter);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
               image.type == PixelType::U16 ? 16 : 8, colourType(image.channels), PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_RELATIVE);
  if (!texts.empty()) png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
  png_write_info(png, info);
  if (image.type == PixelType::U16 && std::endian::native == std::endian::little) png_set_swap(png);
  png_write_image(png, rows.data());
  png_write_end(png, info);
  return true;
}

}  // namespace

Result<void> writePng(const std::filesystem::path& path, const Image& image,
                      const std::map<std::string, std::string>& texts) {
  if (image.isFloatingPoint())
    return runtimeError(path.string() + " cannot be written: PNG holds no floating-point values; write EXR");
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y)
    rows.push_back(std::bit_cast<png_bytep>(
        const_cast<std::byte*>(image.pixels.data() + static_cast<std::size_t>(y) * image.rowBytes())));
  std::vector<png_text> chunks;
  for (const auto& [key, text] : texts) {
    png_text chunk{};
    chunk.compression = text.size() > 1024 ? PNG_ITXT_COMPRESSION_zTXt : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(key.c_str());
    chunk.text = const_cast<char*>(text.c_str());
    chunk.itxt_length = text.size();
    chunks.push_back(chunk);
  }
  std::string bytes;
  png_structp png = png_create_write_struct(
      PNG_LIBPNG_VER_STRING, nullptr, [](png_structp p, png_const_charp) { png_longjmp(p, 1); },
      [](png_structp, png_const_charp) {});
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool done = info != nullptr && encode(png, info, image, rows, chunks, bytes);
  png_destroy_write_struct(&png, &info);
  if (!done) return runtimeError(path.string() + " cannot be written: the picture could not be encoded as PNG");
  return writeFileAtomically(path, bytes);
}

}  // namespace dermis
