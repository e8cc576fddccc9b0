#include "import/image_writer.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/base/file_io.h"
#include "core/base/lower_case.h"
#include "import/jpeg_markers.h"
#include "import/pixel_type.h"
#include "import/text.h"

namespace dermis::import {
namespace {

/// Format by the extension; empty for an extension that isn't one of the four.
std::string formatOf(const std::filesystem::path& path) {
  const std::string extension = lowerCase(path.extension().string());
  if (extension == ".png") return "png";
  if (extension == ".jpg" || extension == ".jpeg") return "jpeg";
  if (extension == ".tif" || extension == ".tiff") return "tiff";
  if (extension == ".exr") return "openexr";
  return {};
}

Result<void> checkLayers(const std::string& name, const std::string& format, const std::vector<ImageLayer>& layers) {
  if (layers.empty()) return runtimeError(fmt::format("{}: there is no image to write", name));
  if (layers.size() > 1 && format != "openexr")
    return runtimeError(fmt::format("{}: several layers need OpenEXR; choose a name that ends in .exr", name));
  const Image& first = layers.front().image;
  for (const ImageLayer& layer : layers) {
    const Image& image = layer.image;
    if (image.width < 1 || image.height < 1 || image.channels < 1 ||
        image.pixels.size() != image.rowBytes() * static_cast<std::size_t>(image.height))
      return runtimeError(fmt::format("{}: layer \"{}\" holds no whole image", name, layer.name));
    if (image.width != first.width || image.height != first.height)
      return runtimeError(fmt::format("{}: layer \"{}\" is {} x {} pixels, the first one {} x {}", name, layer.name,
                                      image.width, image.height, first.width, first.height));
    if (layer.channels.size() != static_cast<std::size_t>(image.channels))
      return runtimeError(fmt::format("{}: layer \"{}\" names {} channels for {}", name, layer.name,
                                      layer.channels.size(), image.channels));
  }
  return {};
}

void addMetadata(OIIO::ImageSpec& spec, const std::string& format, const std::map<std::string, std::string>& metadata) {
  if (metadata.empty()) return;
  if (format == "tiff") {
    spec.attribute("ImageDescription",
                   nlohmann::json(metadata).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else if (format != "jpeg") {
    for (const auto& [key, text] : metadata) spec.attribute(key, text);
  }
}

/// Header and interleaved pixels as OpenImageIO wants them.
struct Prepared {
  OIIO::ImageSpec spec;
  std::vector<std::byte> pixels;  ///< empty where the layer's own can be used
  const std::byte* data = nullptr;
  OIIO::TypeDesc dataType;  ///< UNKNOWN: each channel as the spec says
};

/// One part with the channels of all layers, each in its own type.
Prepared prepareExr(const std::vector<ImageLayer>& layers) {
  Prepared out;
  const Image& first = layers.front().image;
  out.spec = OIIO::ImageSpec(first.width, first.height, 0, OIIO::TypeFloat);
  // 8- and 16-bit layers become half: EXR has no display-referred integers.
  const auto storedType = [](PixelType type) { return type == PixelType::Float ? OIIO::TypeFloat : OIIO::TypeHalf; };
  out.spec.channelnames.clear();
  for (const ImageLayer& layer : layers)
    for (const std::string& channel : layer.channels) {
      out.spec.channelnames.push_back(layer.name.empty() ? channel : layer.name + "." + channel);
      out.spec.channelformats.push_back(storedType(layer.image.type));
    }
  out.spec.nchannels = static_cast<int>(out.spec.channelnames.size());
  const auto alpha = std::find(out.spec.channelnames.begin(), out.spec.channelnames.end(), "A");
  out.spec.alpha_channel =
      alpha == out.spec.channelnames.end() ? -1 : static_cast<int>(alpha - out.spec.channelnames.begin());
  out.spec.attribute("compression", "zip");
  out.spec.attribute("oiio:ColorSpace", "Linear");
  // Rec.709 primaries, D65 white (ITU-R BT.709-6, items 1.3 and 1.4).
  constexpr std::array<float, 8> kRec709 = {0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F};
  out.spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), kRec709.data());

  const auto sameType = [&](const OIIO::TypeDesc& type) { return type == out.spec.channelformats.front(); };
  const bool mixed = !std::all_of(out.spec.channelformats.begin(), out.spec.channelformats.end(), sameType);
  out.spec.format = mixed ? OIIO::TypeFloat : out.spec.channelformats.front();
  if (!mixed) out.spec.channelformats.clear();

  out.dataType = OIIO::TypeFloat;
  if (layers.size() == 1) {
    out.data = first.pixels.data();
    out.dataType = typeDesc(first.type);
    return out;
  }
  const auto pixelFloats = static_cast<std::size_t>(out.spec.nchannels);
  const std::size_t count = static_cast<std::size_t>(first.width) * static_cast<std::size_t>(first.height);
  out.pixels.resize(count * pixelFloats * sizeof(float));
  std::size_t offset = 0;
  for (const ImageLayer& layer : layers) {
    OIIO::convert_image(layer.image.channels, layer.image.width, layer.image.height, 1, layer.image.pixels.data(),
                        typeDesc(layer.image.type), OIIO::AutoStride, OIIO::AutoStride, OIIO::AutoStride,
                        out.pixels.data() + offset * sizeof(float), OIIO::TypeFloat,
                        static_cast<OIIO::stride_t>(pixelFloats * sizeof(float)), OIIO::AutoStride, OIIO::AutoStride);
    offset += layer.channels.size();
  }
  out.data = out.pixels.data();
  return out;
}

Prepared prepareDisplay(const ImageLayer& layer, const std::string& format, int jpegQuality) {
  const Image& image = layer.image;
  Prepared out;
  const bool eightBits = format == "jpeg" || image.type == PixelType::U8;
  out.spec = OIIO::ImageSpec(image.width, image.height, image.channels, eightBits ? OIIO::TypeUInt8 : OIIO::TypeUInt16);
  out.data = image.pixels.data();
  out.dataType = typeDesc(image.type);
  // JPEG knows no alpha: it is left out.
  if (format == "jpeg" && (image.channels == 4 || image.channels == 2)) {
    const int kept = image.channels - 1;
    const std::size_t channelBytes = bytesPerChannel(image.type);
    const std::size_t from = channelBytes * static_cast<std::size_t>(image.channels);
    const std::size_t to = channelBytes * static_cast<std::size_t>(kept);
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    out.pixels.resize(count * to);
    for (std::size_t i = 0; i < count; ++i) std::memcpy(out.pixels.data() + i * to, image.pixels.data() + i * from, to);
    out.data = out.pixels.data();
    out.spec = OIIO::ImageSpec(image.width, image.height, kept, OIIO::TypeUInt8);
  }
  if (out.spec.nchannels == 2) out.spec.alpha_channel = 1;
  if (out.spec.alpha_channel >= 0) out.spec.attribute("oiio:UnassociatedAlpha", 1);
  if (!image.isFloatingPoint()) out.spec.attribute("oiio:ColorSpace", "sRGB");
  if (format == "jpeg") {
    out.spec.attribute("CompressionQuality", jpegQuality);
    out.spec.attribute("jpeg:subsampling", "4:4:4");
  }
  if (format == "tiff") out.spec.attribute("compression", "zip");
  return out;
}

Result<void> encode(const Prepared& prepared, const std::string& format, const std::string& name,
                    const std::string& openName, OIIO::Filesystem::IOProxy* proxy) {
  const auto output = OIIO::ImageOutput::create(format);
  if (!output) return runtimeError(fmt::format("{}: this OpenImageIO cannot write {}", name, format));
  if (proxy != nullptr) output->set_ioproxy(proxy);
  const bool good = output->open(openName, prepared.spec) && output->write_image(prepared.dataType, prepared.data);
  const bool closed = output->close();
  if (good && closed) return {};
  const std::string message = phrase(output->geterror());
  return runtimeError(
      fmt::format("{}: the image cannot be encoded ({})", name, message.empty() ? "no reason given" : message));
}

}  // namespace

Result<void> writeImage(const std::filesystem::path& path, const std::vector<ImageLayer>& layers,
                        const ImageWriteOptions& options) try {
  const std::string name = path.filename().string();
  const std::string format = formatOf(path);
  if (format.empty())
    return runtimeError(
        fmt::format("{}: images are written as .png, .jpg, .tif or .exr; choose one of these endings", path.string()));
  if (auto checked = checkLayers(name, format, layers); !checked) return checked;
  Prepared prepared =
      format == "openexr" ? prepareExr(layers) : prepareDisplay(layers.front(), format, options.jpegQuality);
  addMetadata(prepared.spec, format, options.metadata);
  // Else OpenImageIO puts in the time: what we write depends on nothing but what we were given.
  prepared.spec.attribute("DateTime", "");

  // libtiff goes back in its file to write its directory, which OpenImageIO's memory proxy doesn't get right.
  if (format == "tiff")
    return replaceFileAtomically(path, [&](const std::filesystem::path& temporary) {
      return encode(prepared, format, name, temporary.string(), nullptr);
    });
  // Encoded in memory, so that a full disk shows while we write, not in a library that may not look.
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (auto encoded = encode(prepared, format, name, name, &memory); !encoded) return encoded;
  const std::string_view view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (format == "jpeg" && !options.metadata.empty())
    return writeFileAtomically(
        path,
        withJpegText(view,
                     nlohmann::json(options.metadata).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
  return writeFileAtomically(path, view);
} catch (const std::bad_alloc&) {
  return runtimeError(fmt::format("{}: there is not enough memory to write this image", path.filename().string()));
} catch (const std::exception& error) {
  return runtimeError(
      fmt::format("{}: the image cannot be written ({})", path.filename().string(), phrase(error.what())));
}

}  // namespace dermis::import
