#include "ui/jobs/picture_job.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <cstring>

#include "core/io/importer.h"
#include "core/io/png_writer.h"

namespace dermis {
namespace {

std::vector<std::string> channelNames(int channels) {
  static const std::vector<std::string> kNames = {"R", "G", "B", "A"};
  return channels == 1 ? std::vector<std::string>{"R"}
                       : std::vector<std::string>(kNames.begin(), kNames.begin() + channels);
}

/// 16-bit display codes as floats with alpha multiplied: what an EXR holds of a picture that went through a view.
Image asPremultipliedFloat(const Image& image) {
  Image out = image;
  out.type = PixelType::Float;
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  out.pixels.resize(count * 4 * sizeof(float));
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t codes[4];
    std::memcpy(codes, image.pixels.data() + i * sizeof codes, sizeof codes);
    float values[4];
    for (int c = 0; c < 4; ++c) values[c] = static_cast<float>(codes[c]) / 65535.0F;
    for (int c = 0; c < 3; ++c) values[c] *= values[3];
    std::memcpy(out.pixels.data() + i * sizeof values, values, sizeof values);
  }
  return out;
}

Result<void> accumulate(Renderer& renderer, const FrameRequest& frame, const std::function<void(double)>& progress,
                        std::stop_token stop) {
  while (renderer.runJobs(20.0)) {
    if (stop.stop_requested()) return cancelledError();
    progress(0.3 * renderer.jobProgress().second);
  }
  if (const Result<void> done = renderer.finishJobs(); !done) return done;
  for (int sample = 0; sample < frame.targetSamples; ++sample) {
    if (stop.stop_requested()) return cancelledError();
    if (!renderer.renderFrame(frame)) {
      const Warnings said = renderer.takeMessages();
      return runtimeError(said.empty() ? "the picture could not be drawn" : said.front());
    }
    progress(0.3 + 0.65 * (sample + 1) / frame.targetSamples);
    if (!renderer.accumulating()) break;
  }
  return {};
}

Result<void> write(Renderer& renderer, const ResolvedScene& scene, const PictureRequest& request,
                   const std::vector<Aov>& aovs, const PictureMetadata& metadata) {
  const ViewSettings& view = scene.scene.view;
  const std::string ending = request.path.extension().string();
  std::map<std::string, std::string> texts;
  if (metadata) texts = metadata(scene, request, renderer.glInfo().renderer);
  if (ending == ".png" || ending == ".PNG")
    return writePng(request.path, renderer.readDisplay(view, PixelType::U8), texts);

  std::vector<ImageLayer> layers(1);
  if (ending == ".exr" || ending == ".EXR")
    layers[0].image = view.transform == "Raw" ? renderer.readAov(Aov::Beauty)
                                              : asPremultipliedFloat(renderer.readDisplay(view, PixelType::U16));
  else
    layers[0].image = renderer.readDisplay(view, PixelType::U8);
  layers[0].channels = channelNames(layers[0].image.channels);
  for (const Aov aov : aovs) {
    ImageLayer layer;
    layer.name = toString(aov);
    layer.image = renderer.readAov(aov);
    layer.channels = channelNames(layer.image.channels);
    layers.push_back(std::move(layer));
  }
  const Result<const Importer*> module = importer();
  if (!module) return tl::unexpected(module.error());
  ImageWriteOptions options;
  options.metadata = texts;
  return (*module)->writeImage(request.path, layers, options);
}

}  // namespace

Result<void> drawPicture(QOffscreenSurface& surface, const std::shared_ptr<const ResolvedScene>& scene,
                         const PictureRequest& request, const std::filesystem::path& cacheFolder,
                         const PictureMetadata& metadata, const std::function<void(double)>& progress,
                         std::stop_token stop) {
  QOpenGLContext context;
  context.setFormat(surface.requestedFormat());
  if (!context.create() || !context.makeCurrent(&surface))
    return runtimeError("no second OpenGL context could be made to draw the picture");
  Result<void> result;
  {
    RendererOptions options;
    options.cacheFolder = cacheFolder;
    options.bakeMeshes = true;
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create(options);
    if (!renderer) {
      result = tl::unexpected(renderer.error());
    } else {
      auto seen = std::make_shared<ResolvedScene>(*scene);
      if (request.transparent)
        seen->scene.environment.background = Background{BackgroundKind::None, 0.0F, glm::vec3(0.0F)};
      std::vector<Aov> aovs;
      if (request.allLayers)
        for (const Aov aov : allAovs())
          if (aov != Aov::Beauty) aovs.push_back(aov);
      (*renderer)->keepAovs(aovs);
      (*renderer)->setScene(seen);
      FrameRequest frame;
      frame.size = request.size;
      frame.camera = seen->camera;
      frame.view = seen->scene.view;
      frame.targetSamples = request.samples;
      frame.exactDisplay = true;
      result = accumulate(**renderer, frame, progress, stop);
      if (result) result = write(**renderer, *seen, request, aovs, metadata);
    }
  }
  context.doneCurrent();
  return result;
}

}  // namespace dermis
