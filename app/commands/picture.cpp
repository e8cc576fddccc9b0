#include "app/commands/picture.h"

#include <fmt/format.h>

#include <cstring>
#include <memory>

#include "app/commands/metadata.h"
#include "core/io/importer.h"
#include "core/io/png_writer.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

bool isRaw(const Look& look) { return look.resolved.scene.view.transform == "Raw"; }

/// What a file of this name holds a channel.
PixelType depthOf(const fs::path& file) {
  const std::string extension = extensionOf(file);
  if (extension == ".exr") return PixelType::Float;
  return extension == ".tif" || extension == ".tiff" ? PixelType::U16 : PixelType::U8;
}

std::vector<std::string> channelNames(const Image& image) {
  static const std::vector<std::string> kNames = {"R", "G", "B", "A"};
  return {kNames.begin(), kNames.begin() + image.channels};
}

/// U8 without its alpha where that is 1 everywhere; multiplied into the colour where the format has none.
Image withoutAlpha(const Image& image, bool mustGo) {
  if (image.channels != 4 || image.type != PixelType::U8) return image;
  const std::size_t count = image.pixels.size() / 4;
  bool opaque = true;
  for (std::size_t i = 0; i < count && opaque; ++i) opaque = image.pixels[4 * i + 3] == std::byte{255};
  if (!opaque && !mustGo) return image;
  Image out = image;
  out.channels = 3;
  out.pixels.resize(count * 3);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto value = std::to_integer<unsigned>(image.pixels[4 * i + c]);
      const auto alpha = std::to_integer<unsigned>(image.pixels[4 * i + 3]);
      out.pixels[3 * i + c] = static_cast<std::byte>((value * alpha + 127) / 255);
    }
  return out;
}

/// 16-bit codes as floats with alpha multiplied, for an EXR of a display-encoded picture.
Image asPremultipliedFloat(const Image& image) {
  Image out = image;
  out.type = PixelType::Float;
  const std::size_t count = image.pixels.size() / 8;
  out.pixels.resize(count * 4 * sizeof(float));
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t codes[4];
    std::memcpy(codes, image.pixels.data() + 8 * i, sizeof codes);
    float values[4];
    for (int c = 0; c < 4; ++c) values[c] = static_cast<float>(codes[c]) / 65535.0F;
    for (int c = 0; c < 3; ++c) values[c] *= values[3];
    std::memcpy(out.pixels.data() + i * sizeof values, values, sizeof values);
  }
  return out;
}

Outcome<void> writeLayers(const fs::path& file, const std::vector<ImageLayer>& layers,
                          const ImageWriteOptions& options) {
  // PNG is written here: the import module would cost more to load than the whole picture.
  if (extensionOf(file) == ".png") {
    const Result<void> written = writePng(file, layers.front().image, options.metadata);
    if (!written) return failure(written.error());
    return {};
  }
  const Result<const Importer*> module = importer();
  if (!module) return failure(module.error());
  const Result<void> written = (*module)->writeImage(file, layers, options);
  if (!written) return failure(written.error());
  return {};
}

}  // namespace

Outcome<std::vector<ImageLayer>> renderLayers(Renderer& renderer, const Look& look, const PictureRequest& request,
                                              ProgressLine& progress) {
  renderer.keepAovs(request.aovs);
  renderer.setScene(std::make_shared<const ResolvedScene>(look.resolved));
  if (const auto done = finishJobs(renderer, progress); !done) return tl::unexpected(done.error());

  FrameRequest frame;
  frame.size = request.size;
  frame.camera = look.resolved.camera;
  frame.view = look.resolved.scene.view;
  frame.targetSamples = request.samples;
  frame.references = request.references;
  frame.exactDisplay = true;
  frame.eightBits = depthOf(request.output) == PixelType::U8;
  for (int sample = 0; sample < request.samples; ++sample) {
    if (!renderer.renderFrame(frame)) {
      const Warnings messages = renderer.takeMessages();
      return failure(
          Error{Error::Kind::Runtime, messages.empty() ? "the picture could not be drawn" : messages.front()});
    }
    progress.show(fmt::format("sample {} of {}", sample + 1, request.samples),
                  static_cast<double>(sample + 1) / request.samples);
    if (!renderer.accumulating()) break;
  }
  progress.clear();

  std::vector<ImageLayer> layers;
  const std::string extension = extensionOf(request.output);
  const bool exr = extension == ".exr";
  const auto shown = [&](Aov aov) {
    return withoutAlpha(renderer.readView(aov, frame.view, depthOf(request.output)), extension.starts_with(".jp"));
  };
  ImageLayer beauty;
  if (exr) {
    beauty.image = isRaw(look) ? renderer.readAov(Aov::Beauty)
                               : asPremultipliedFloat(renderer.readDisplay(frame.view, PixelType::U16));
  } else {
    beauty.image = shown(Aov::Beauty);
  }
  beauty.channels = channelNames(beauty.image);
  layers.push_back(std::move(beauty));
  for (const Aov aov : request.aovs) {
    if (aov == Aov::Beauty) continue;
    ImageLayer layer;
    layer.name = toString(aov);
    layer.image = exr ? renderer.readAov(aov) : shown(aov);
    layer.channels = layer.image.channels == 1 ? std::vector<std::string>{"R"} : channelNames(layer.image);
    layers.push_back(std::move(layer));
  }
  return layers;
}

fs::path aovFile(const fs::path& output, std::string_view aov) {
  fs::path file = output;
  return file.replace_extension("." + std::string(aov) + output.extension().string());
}

Outcome<void> writePicture(Renderer& renderer, const Look& look, const PictureRequest& request,
                           std::vector<ImageLayer> layers) {
  const auto optionsFor = [&](const std::string& aov) {
    ImageWriteOptions options;
    if (request.metadata)
      options.metadata = pictureMetadata(look, {request.size, request.samples, look.resolved.scene.view.transform,
                                                renderer.glInfo().renderer, aov, request.references});
    return options;
  };
  const std::string extension = extensionOf(request.output);
  if (extension == ".exr") return writeLayers(request.output, layers, optionsFor({}));
  for (ImageLayer& layer : layers) {
    const ImageWriteOptions options = optionsFor(layer.name);
    const fs::path file = layer.name.empty() ? request.output : aovFile(request.output, layer.name);
    layer.name.clear();
    if (auto written = writeLayers(file, {std::move(layer)}, options); !written) return written;
  }
  return {};
}

}  // namespace dermis::cli
