#include "import/image_loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "import/image_source.h"
#include "import/jpeg_markers.h"
#include "import/pixel_type.h"
#include "import/row_reducer.h"
#include "import/text.h"
#include "import/tiff_text.h"

namespace dermis::import {
namespace {

PixelType pixelType(const OIIO::TypeDesc& format) {
  switch (format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return PixelType::U8;
    case OIIO::TypeDesc::UINT16:
      return PixelType::U16;
    case OIIO::TypeDesc::HALF:
      return PixelType::Half;
    default:
      return PixelType::Float;
  }
}

/// How many of the leading channels make a picture: R, G, B, A; grey; grey and alpha.
int pictureChannels(const OIIO::ImageSpec& spec) {
  int channels = std::min(spec.nchannels, 4);
  // A fourth (or second) channel that is depth or another layer's isn't alpha.
  if (channels == 4 && spec.alpha_channel != 3 && spec.channelnames[0] == "R" && spec.channelnames[3] != "A")
    channels = 3;
  if (channels == 2 && spec.nchannels > 2) channels = 1;
  return channels;
}

/// What is read, and where it lies in the picture.
struct Layout {
  int width = 0, height = 0;     ///< of the picture
  int offsetX = 0, offsetY = 0;  ///< of the stored pixels in the picture; may be negative
  int channels = 0;
};

Layout layoutOf(const OIIO::ImageSpec& spec, bool hasWindows) {
  Layout layout;
  layout.channels = pictureChannels(spec);
  layout.width = spec.width;
  layout.height = spec.height;
  if (hasWindows && spec.full_width > 0 && spec.full_height > 0) {
    layout.width = spec.full_width;
    layout.height = spec.full_height;
    layout.offsetX = spec.x - spec.full_x;
    layout.offsetY = spec.y - spec.full_y;
  }
  return layout;
}

/// Reads the picture's rows from the top in strips and hands each on.
class RowPump {
 public:
  RowPump(const ImageSource& source, const Layout& layout, PixelType type)
      : m_source(source),
        m_layout(layout),
        m_type(type),
        m_pixelBytes(static_cast<std::size_t>(layout.channels) * bytesPerChannel(type)) {}

  template <class Consume>
  Result<void> run(const std::stop_token& stop, Consume&& consume) {
    const OIIO::ImageSpec& spec = m_source.spec();
    const bool whole = m_layout.offsetX == 0 && m_layout.width == spec.width;
    std::vector<std::byte> line(static_cast<std::size_t>(m_layout.width) * m_pixelBytes);
    int y = 0;
    for (; y < m_layout.height && y < m_layout.offsetY; ++y) consume(std::span<const std::byte>(line));

    const int strip = stripRows();
    const int end = std::min(spec.height, m_layout.height - m_layout.offsetY);
    for (int from = 0; from < end; from += strip) {
      if (stop.stop_requested()) return cancelledError();
      const int rows = std::min(strip, spec.height - from);
      if (auto read = readStrip(from, rows); !read) return read;
      for (int row = 0; row < rows && from + row < end; ++row) {
        if (from + row + m_layout.offsetY < 0) continue;
        const std::span<const std::byte> stored(m_strip.data() + static_cast<std::size_t>(row) * storedRowBytes(),
                                                storedRowBytes());
        if (whole) {
          consume(stored);
        } else {
          place(stored, line);
          consume(std::span<const std::byte>(line));
        }
        ++y;
      }
    }
    std::fill(line.begin(), line.end(), std::byte{0});
    for (; y < m_layout.height; ++y) consume(std::span<const std::byte>(line));
    return {};
  }

 private:
  [[nodiscard]] std::size_t storedRowBytes() const {
    return static_cast<std::size_t>(m_source.spec().width) * m_pixelBytes;
  }

  /// About 8 MiB, in whole tiles, or in whole EXR blocks (256 rows at most).
  [[nodiscard]] int stripRows() const {
    const OIIO::ImageSpec& spec = m_source.spec();
    const int unit = spec.tile_height > 0 ? spec.tile_height : m_source.format() == "openexr" ? 256 : 16;
    const auto wanted = static_cast<int>((std::size_t{8} << 20U) / std::max<std::size_t>(1, storedRowBytes()));
    const int rows = std::max(1, wanted / unit) * unit;
    return std::min(rows, std::max(1, spec.height));
  }

  Result<void> readStrip(int from, int rows) {
    const OIIO::ImageSpec& spec = m_source.spec();
    OIIO::ImageInput& input = m_source.input();
    m_strip.resize(static_cast<std::size_t>(rows) * storedRowBytes());
    const int y = spec.y + from;
    bool good = false;
    std::string message;
    try {
      good = spec.tile_width > 0 ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, y, y + rows, spec.z, spec.z + 1,
                                                    0, m_layout.channels, typeDesc(m_type), m_strip.data())
                                 : input.read_scanlines(0, 0, y, y + rows, spec.z, 0, m_layout.channels,
                                                        typeDesc(m_type), m_strip.data());
      // Some decoders leave a message and pretend success: what they filled in isn't the picture.
      if (input.has_error()) good = false;
      if (!good) message = m_source.lastMessage();
    } catch (const std::exception& error) {
      message = phrase(error.what());
    }
    if (good) return {};
    return inputError(
        fmt::format("{}: the image data is damaged or cut off between rows {} and {} ({}); export or download it again",
                    m_source.name(), from, from + rows - 1, message));
  }

  /// One stored row at its place in a row of the picture, with zeros around it.
  void place(std::span<const std::byte> stored, std::vector<std::byte>& line) const {
    const int first = std::max(0, m_layout.offsetX);
    const int last = std::min(m_layout.width, m_layout.offsetX + m_source.spec().width);
    std::fill(line.begin(), line.end(), std::byte{0});
    if (last <= first) return;
    std::memcpy(line.data() + static_cast<std::size_t>(first) * m_pixelBytes,
                stored.data() + static_cast<std::size_t>(first - m_layout.offsetX) * m_pixelBytes,
                static_cast<std::size_t>(last - first) * m_pixelBytes);
  }

  const ImageSource& m_source;
  Layout m_layout;
  PixelType m_type;
  std::size_t m_pixelBytes;
  std::vector<std::byte> m_strip;
};

Result<Image> readWhole(const ImageSource& source, const Layout& layout, PixelType type, const std::stop_token& stop) {
  Image image{layout.width, layout.height, layout.channels, type, {}, source.name()};
  // Reserved, not touched: a file that lies about its size fails before the memory is used.
  image.pixels.reserve(image.rowBytes() * static_cast<std::size_t>(layout.height));
  RowPump pump(source, layout, type);
  auto done = pump.run(stop, [&](std::span<const std::byte> row) { image.pixels.append(row); });
  if (!done) return tl::unexpected(done.error());
  return image;
}

Result<Image> readReduced(const ImageSource& source, const Layout& layout, PixelType type, int maximumSize,
                          const std::stop_token& stop) {
  const double factor = static_cast<double>(maximumSize) / std::max(layout.width, layout.height);
  const auto side = [&](int n) {
    return std::clamp(static_cast<int>(std::lround(n * factor)), 1, std::min(n, maximumSize));
  };
  Image image{side(layout.width), side(layout.height), layout.channels, type, {}, source.name()};
  image.pixels.reserve(image.rowBytes() * static_cast<std::size_t>(image.height));
  RowReducer reducer(layout.width, layout.height, image.width, image.height, layout.channels,
                     [&](int, std::span<const float> row) {
                       const std::size_t at = image.pixels.size();
                       image.pixels.resize(at + image.rowBytes());
                       OIIO::convert_pixel_values(OIIO::TypeFloat, row.data(), typeDesc(type), image.pixels.data() + at,
                                                  static_cast<int>(row.size()));
                     });
  RowPump pump(source, layout, PixelType::Float);
  auto done = pump.run(stop, [&](std::span<const std::byte> row) {
    reducer.add({reinterpret_cast<const float*>(row.data()), row.size() / sizeof(float)});
  });
  if (!done) return tl::unexpected(done.error());
  image.pixels.resize(image.rowBytes() * static_cast<std::size_t>(image.height));
  return image;
}

Result<Image> read(const ImageSource& source, const ImageReadOptions& options, Warnings& warnings,
                   const std::stop_token& stop) {
  const OIIO::ImageSpec& spec = source.spec();
  const Layout layout = layoutOf(spec, source.format() == "openexr");
  const PixelType type = options.asFloat ? PixelType::Float : pixelType(spec.format);

  if (spec.nchannels > layout.channels)
    warnings.push_back(
        fmt::format("{}: of its {} channels only {} are used", source.name(), spec.nchannels,
                    fmt::join(spec.channelnames.begin(), spec.channelnames.begin() + layout.channels, ", ")));
  if (const int orientation = spec.get_int_attribute("Orientation", 1); orientation > 1)
    warnings.push_back(
        fmt::format("{}: its orientation mark ({}) is not applied; turn the pixels themselves if the map lies wrong",
                    source.name(), orientation));

  const int largest = std::max(layout.width, layout.height);
  const int maximum = std::max(1, options.maximumSize);
  if (largest <= maximum) return readWhole(source, layout, type, stop);
  auto image = readReduced(source, layout, type, maximum, stop);
  if (image && options.tellReduced)
    warnings.push_back(fmt::format("{}: reduced from {} x {} to {} x {} pixels, because {} a side is the limit",
                                   source.name(), layout.width, layout.height, image->width, image->height, maximum));
  return image;
}

/// Texts that we packed into one field (see image_writer): a JSON object of strings.
void unpackTexts(const std::string& text, std::map<std::string, std::string>& metadata) {
  const nlohmann::json packed = nlohmann::json::parse(text, nullptr, false);
  if (!packed.is_object()) return;
  for (const auto& [key, value] : packed.items())
    if (value.is_string()) metadata[key] = value.get<std::string>();
}

}  // namespace

Result<Image> loadImage(const std::filesystem::path& path, const ImageReadOptions& options, Warnings& warnings,
                        const std::stop_token& stop) try {
  if (stop.stop_requested()) return cancelledError();
  auto source = ImageSource::open(path);
  if (!source) return tl::unexpected(source.error());
  return read(*source, options, warnings, stop);
} catch (const std::bad_alloc&) {
  return runtimeError(fmt::format("{}: there is not enough memory for this image", path.filename().string()));
} catch (const std::exception& error) {
  return inputError(
      fmt::format("{}: the image cannot be decoded ({})", path.filename().string(), phrase(error.what())));
}

Result<Image> loadImage(std::span<const std::byte> bytes, const std::string& name, const ImageReadOptions& options,
                        Warnings& warnings) try {
  auto source = ImageSource::open(bytes, name);
  if (!source) return tl::unexpected(source.error());
  return read(*source, options, warnings, {});
} catch (const std::bad_alloc&) {
  return runtimeError(fmt::format("{}: there is not enough memory for this image", name));
} catch (const std::exception& error) {
  return inputError(fmt::format("{}: the image cannot be decoded ({})", name, phrase(error.what())));
}

Result<ImageInfo> inspectImage(const std::filesystem::path& path) try {
  auto source = ImageSource::open(path, true);
  if (!source) return tl::unexpected(source.error());
  const OIIO::ImageSpec& spec = source->spec();
  const Layout layout = layoutOf(spec, source->format() == "openexr");
  ImageInfo info;
  info.width = layout.width;
  info.height = layout.height;
  info.channels = spec.nchannels;
  info.type = pixelType(spec.format);
  info.format = source->format();
  info.channelNames = spec.channelnames;
  for (const OIIO::ParamValue& value : spec.extra_attribs) info.metadata[value.name().string()] = value.get_string(0);
  if (info.format == "tiff") unpackTexts(tiffDescription(path), info.metadata);
  if (info.format == "jpeg") unpackTexts(jpegText(path), info.metadata);
  return info;
} catch (const std::exception& error) {
  return inputError(
      fmt::format("{}: the image's header cannot be read ({})", path.filename().string(), phrase(error.what())));
}

}  // namespace dermis::import
