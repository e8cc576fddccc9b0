#include "ui/jobs/picture_job.h"

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/io/importer.h"
#include "core/io/png_writer.h"

namespace dermis {
namespace {

bool isExr(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".exr" || ending == ".EXR";
}

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

/// Draws one picture to its last sample; `progress` gets 0..1 of it.
Result<void> accumulate(Renderer& renderer, const FrameRequest& frame, const std::function<void(double)>& progress,
                        const std::stop_token& stop) {
  renderer.restartAccumulation();
  for (int sample = 0; sample < frame.targetSamples; ++sample) {
    if (stop.stop_requested()) return cancelledError();
    if (!renderer.renderFrame(frame)) {
      const Warnings said = renderer.takeMessages();
      return runtimeError(said.empty() ? "the picture could not be drawn" : said.front());
    }
    progress(static_cast<double>(sample + 1) / frame.targetSamples);
    if (!renderer.accumulating()) break;
  }
  return {};
}

/// Programs, environment, what is measured of the model; `progress` gets 0..1.
Result<void> prepare(Renderer& renderer, const std::function<void(double)>& progress, const std::stop_token& stop) {
  while (renderer.runJobs(20.0)) {
    if (stop.stop_requested()) return cancelledError();
    progress(renderer.jobProgress().second);
  }
  return renderer.finishJobs();
}

Result<void> write(Renderer& renderer, const ResolvedScene& scene, const PictureRequest& request,
                   const std::filesystem::path& path, const std::vector<Aov>& aovs, const PictureMetadata& metadata) {
  const ViewSettings& view = scene.scene.view;
  const std::string ending = path.extension().string();
  std::map<std::string, std::string> texts;
  if (metadata) texts = metadata(scene, request, renderer.glInfo().renderer);
  if (ending == ".png" || ending == ".PNG") return writePng(path, renderer.readDisplay(view, PixelType::U8), texts);

  std::vector<ImageLayer> layers(1);
  if (isExr(path))
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
  return (*module)->writeImage(path, layers, options);
}

/// The views in rows as square as they fit, each with its name below it.
Image sheetOf(const std::vector<QImage>& tiles, const std::vector<NamedView>& views, bool transparent) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(tiles.size()))));
  const int rows = (static_cast<int>(tiles.size()) + columns - 1) / columns;
  const QSize tile = tiles.front().size();
  const int band = std::max(tile.height() / 18, 12);
  QImage sheet(columns * tile.width(), rows * (tile.height() + band), QImage::Format_RGBA8888);
  sheet.fill(transparent ? QColor(0, 0, 0, 0) : QColor(30, 30, 30));
  QPainter painter(&sheet);
  QFont font = painter.font();
  font.setPixelSize(std::max(band * 6 / 10, 8));
  painter.setFont(font);
  painter.setPen(transparent ? QColor(128, 128, 128) : QColor(215, 215, 215));
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const int x = static_cast<int>(i) % columns * tile.width();
    const int y = static_cast<int>(i) / columns * (tile.height() + band);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(x, y, tiles[i]);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter.drawText(QRect(x, y + tile.height(), tile.width(), band), Qt::AlignCenter,
                     QString::fromStdString(views[i].name));
  }
  painter.end();
  Image image;
  image.width = sheet.width();
  image.height = sheet.height();
  image.channels = 4;
  image.pixels.resize(image.rowBytes() * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y)
    std::memcpy(image.pixels.data() + static_cast<std::size_t>(y) * image.rowBytes(), sheet.constScanLine(y),
                image.rowBytes());
  return image;
}

/// One run of the job: the renderer, the scene it draws, and how far it has come.
struct Work {
  Renderer& renderer;
  ResolvedScene seen;
  const PictureRequest& request;
  const PictureMetadata& metadata;
  const std::function<void(double)>& progress;
  std::stop_token stop;
  std::vector<Aov> aovs;
  double done = 0.3;  ///< of the whole; preparing comes first

  Result<void> draw(const Camera& camera, double share) {
    seen.camera = camera;
    seen.scene.camera = camera;  // so that the metadata say where this picture was taken from
    FrameRequest frame;
    frame.size = request.size;
    frame.camera = camera;
    frame.view = seen.scene.view;
    frame.targetSamples = request.samples;
    frame.exactDisplay = true;
    frame.eightBits = !isExr(request.path);
    frame.references = request.references;
    const auto partly = [&](double fraction) { progress(done + share * fraction); };
    Result<void> drawn = accumulate(renderer, frame, partly, stop);
    done += share;
    return drawn;
  }
};

constexpr double kDrawingShare = 0.65;

Result<DrawnPicture> drawStill(Work& work) {
  if (const Result<void> drawn = work.draw(work.seen.camera, kDrawingShare); !drawn)
    return tl::unexpected(drawn.error());
  DrawnPicture picture;
  if (work.request.path.empty()) {
    picture.image = work.renderer.readDisplay(work.seen.scene.view, PixelType::U8);
    return picture;
  }
  const Result<void> written =
      write(work.renderer, work.seen, work.request, work.request.path, work.aovs, work.metadata);
  if (!written) return tl::unexpected(written.error());
  picture.files.push_back(work.request.path);
  return picture;
}

Result<DrawnPicture> drawTurntable(Work& work) {
  DrawnPicture picture;
  const Camera start = work.seen.camera;
  const int frames = std::max(work.request.frames, 1);
  for (int i = 0; i < frames; ++i) {
    const Camera camera = turnedCamera(start, 360.0 * i / frames);
    if (const Result<void> drawn = work.draw(camera, kDrawingShare / frames); !drawn)
      return tl::unexpected(drawn.error());
    const std::filesystem::path path = framePath(work.request.path, i);
    const Result<void> written = write(work.renderer, work.seen, work.request, path, work.aovs, work.metadata);
    if (!written) return tl::unexpected(written.error());
    picture.files.push_back(path);
  }
  return picture;
}

Result<DrawnPicture> drawSheet(Work& work) {
  const std::vector<NamedView>& views = work.request.views;
  if (views.empty()) return runtimeError("a sheet needs at least one view");
  std::vector<QImage> tiles;
  for (const NamedView& view : views) {
    if (const Result<void> drawn = work.draw(view.camera, kDrawingShare / static_cast<double>(views.size())); !drawn)
      return tl::unexpected(drawn.error());
    const Image image = work.renderer.readDisplay(work.seen.scene.view, PixelType::U8);
    tiles.push_back(QImage(reinterpret_cast<const uchar*>(image.pixels.data()), image.width, image.height,
                           static_cast<qsizetype>(image.rowBytes()), QImage::Format_RGBA8888)
                        .copy());
  }
  DrawnPicture picture;
  picture.image = sheetOf(tiles, views, work.request.transparent);
  if (work.request.path.empty()) return picture;
  std::map<std::string, std::string> texts;
  if (work.metadata) texts = work.metadata(work.seen, work.request, work.renderer.glInfo().renderer);
  if (const Result<void> written = writePng(work.request.path, picture.image, texts); !written)
    return tl::unexpected(written.error());
  picture.files.push_back(work.request.path);
  return picture;
}

}  // namespace

std::filesystem::path framePath(const std::filesystem::path& path, int index) {
  std::string number = std::to_string(index + 1);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  std::filesystem::path name = path.stem();
  name += "_" + number;
  name += path.extension();
  return path.parent_path() / name;
}

Camera turnedCamera(const Camera& camera, double degrees) {
  const auto angle = static_cast<float>(glm::radians(degrees));
  const float c = std::cos(angle), s = std::sin(angle);
  const auto turn = [&](const glm::vec3& v) { return glm::vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x); };
  Camera next = camera;
  next.position = camera.target + turn(camera.position - camera.target);
  next.up = turn(camera.up);
  return next;
}

Result<DrawnPicture> drawPicture(QOffscreenSurface& surface, const std::shared_ptr<const ResolvedScene>& scene,
                                 const PictureRequest& request, const std::filesystem::path& cacheFolder,
                                 const PictureMetadata& metadata, const std::function<void(double)>& progress,
                                 const std::stop_token& stop) {
  QOpenGLContext context;
  context.setFormat(surface.requestedFormat());
  if (!context.create() || !context.makeCurrent(&surface))
    return runtimeError("no second OpenGL context could be made to draw the picture");
  Result<DrawnPicture> result;
  {
    RendererOptions options;
    options.cacheFolder = cacheFolder;
    options.bakeMeshes = true;
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create(options);
    if (!renderer) {
      result = tl::unexpected(renderer.error());
    } else {
      Work work{**renderer, *scene, request, metadata, progress, stop, {}};
      if (!request.view.empty()) work.seen.scene.view.transform = request.view;
      if (request.transparent)
        work.seen.scene.environment.background = Background{BackgroundKind::None, 0.0F, glm::vec3(0.0F)};
      if (request.allLayers)
        for (const Aov aov : allAovs())
          if (aov != Aov::Beauty) work.aovs.push_back(aov);
      (*renderer)->keepAovs(work.aovs);
      (*renderer)->setScene(std::make_shared<ResolvedScene>(work.seen));
      const Result<void> ready = prepare(
          **renderer, [&](double fraction) { progress(0.3 * fraction); }, stop);
      if (!ready)
        result = tl::unexpected(ready.error());
      else if (request.kind == PictureKind::Turntable)
        result = drawTurntable(work);
      else if (request.kind == PictureKind::Sheet)
        result = drawSheet(work);
      else
        result = drawStill(work);
    }
  }
  context.doneCurrent();
  return result;
}

}  // namespace dermis
