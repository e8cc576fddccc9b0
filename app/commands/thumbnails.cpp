// dermis thumbnails: a small picture of each preset, on what shows it best.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/bake.h"
#include "app/commands/commands.h"
#include "app/commands/picture.h"
#include "core/base/file_reference.h"
#include "core/builtin/default_look.h"
#include "core/builtin/head/head_look.h"
#include "core/io/asset_loader.h"
#include "core/material/preset_io.h"
#include "core/material/preset_tags.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

/// The head's own maps are made as large as a thumbnail can show.
constexpr std::string_view kMapSize = "size=512";

struct ThumbnailOptions {
  std::vector<std::string> presets;  ///< "[NAME=]PRESET"
  std::string folder, size = "128x128";
  int samples = 8;
};

struct Order {
  std::string preset;
  fs::path file;
};

/// Where on the embedded head a preset is shown, and from where it is looked at.
struct Place {
  std::string_view slot;
  glm::vec3 position, target;
  float verticalFovDegrees;
};
constexpr std::array<Place, 4> kPlaces = {{
    {"face", {0.17F, 0.02F, 0.62F}, {0.0F, -0.04F, 0.0F}, 24.0F},
    {"eye", {0.034F, 0.0F, 0.16F}, {0.032F, 0.0F, 0.0F}, 22.0F},
    {"lens", {0.034F, 0.0F, 0.16F}, {0.032F, 0.0F, 0.0F}, 22.0F},
    {"hair", {0.036F, 0.014F, 0.2F}, {0.032F, 0.012F, 0.0F}, 22.0F},
}};

/// What a tag names, else what the model is for; null: a ball shows it best.
const Place* placeOf(const Material& material) {
  for (const std::string& tag : presetTags(material))
    if (const auto found = std::ranges::find(kPlaces, tag, &Place::slot); found != kPlaces.end()) return &*found;
  switch (material.model) {
    case ShadingModel::Skin:
    case ShadingModel::Thesis:
      return &kPlaces[0];
    case ShadingModel::Eye:
      return &kPlaces[1];
    case ShadingModel::Lens:
      return &kPlaces[2];
    default:
      return nullptr;
  }
}

Scene sceneFor(const Material& material) {
  Scene scene;
  if (const Place* place = placeOf(material)) {
    scene = defaultLook();
    Camera camera;
    camera.position = place->position;
    camera.target = place->target;
    camera.verticalFovDegrees = place->verticalFovDegrees;
    scene.camera = camera;
    scene.materials[std::string(place->slot)].material = material;
  } else {
    scene.model.builtin = "sphere";
    scene.materials["*"].material = material;
  }
  return scene;
}

Outcome<Look> lookOf(const std::string& preset, const std::shared_ptr<AssetCache>& cache, Warnings& warnings) {
  const std::string path = absoluteReference(preset, fs::current_path());
  Result<Material> material = loadPreset(path, warnings);
  if (!material) return failure(material.error());
  for (TextureBinding& map : material->textures)
    if (isHeadMap(map.path)) map.path += (map.path.find('?') == std::string::npos ? "?" : "&") + std::string(kMapSize);
  ResolveOptions resolve;
  resolve.cache = cache;
  resolve.importedMaterials = true;
  Result<ResolvedScene> resolved = resolveScene(sceneFor(*material), fs::path(path).parent_path(), resolve, warnings);
  if (!resolved) return failure(resolved.error());
  Look look;
  look.resolved = std::move(*resolved);
  takeViewOfShaders(look.resolved);
  return look;
}

Outcome<Order> orderOf(const std::string& text, const fs::path& folder) {
  std::error_code error;
  const std::size_t equals = fs::exists(text, error) ? std::string::npos : text.find('=');
  Order order{equals == std::string::npos ? text : text.substr(equals + 1), {}};
  const auto builtin = builtinName(order.preset);
  const std::string name = equals != std::string::npos ? text.substr(0, equals)
                           : builtin                   ? std::string(*builtin)
                                                       : fs::path(order.preset).stem().string();
  if (name.empty() || order.preset.empty() || fs::path(name).has_parent_path())
    return wrongUsage(fmt::format("\"{}\" is not [NAME=]PRESET with the name of a file", text));
  order.file = folder / (name + ".png");
  return order;
}

Outcome<int> thumbnails(const ThumbnailOptions& options) {
  PictureRequest request;
  const Outcome<glm::ivec2> size = parseSize(options.size);
  if (!size) return tl::unexpected(size.error());
  request.size = *size;
  request.samples = options.samples;
  request.metadata = false;
  std::vector<Order> orders;
  for (const std::string& text : options.presets) {
    Outcome<Order> order = orderOf(text, options.folder);
    if (!order) return tl::unexpected(order.error());
    if (std::ranges::find(orders, order->file, &Order::file) != orders.end())
      return wrongUsage(fmt::format("two presets would be drawn into {}; name one of them, as in other={}",
                                    order->file.string(), order->preset));
    orders.push_back(std::move(*order));
  }
  if (const auto made = makeFolder(options.folder); !made) return tl::unexpected(made.error());
  const auto headless = HeadlessRenderer::create();
  if (!headless) return tl::unexpected(headless.error());
  Renderer& renderer = **headless;

  ProgressLine progress;
  const auto cache = std::make_shared<AssetCache>();
  std::optional<Look> drawn;  // keeps what the next one may share
  const auto draw = [&](const Order& order) -> Outcome<void> {
    Warnings warnings;
    Outcome<Look> look = lookOf(order.preset, cache, warnings);
    printWarnings(warnings);
    if (!look) return tl::unexpected(look.error());
    request.output = order.file;
    auto layers = renderLayers(renderer, *look, request, progress);
    warnings = renderer.takeMessages();
    printWarnings(warnings);
    drawn = std::move(*look);
    if (!layers) return tl::unexpected(layers.error());
    return writePicture(renderer, *drawn, request, std::move(*layers));
  };
  // One that can't be drawn keeps none of the others from it.
  int exitCode = kDone;
  for (const Order& order : orders) {
    if (const Outcome<void> done = draw(order); !done) {
      const int code = report(done.error());
      if (exitCode == kDone) exitCode = code;
      continue;
    }
    fmt::print("{}\n", order.file.string());
    std::fflush(stdout);
  }
  return exitCode;
}

}  // namespace

void addThumbnails(CLI::App& root, Action& action) {
  auto options = std::make_shared<ThumbnailOptions>();
  CLI::App* command = root.add_subcommand("thumbnails", "Draw a small picture of each preset");
  command->add_option("PRESETS", options->presets, "Preset files or builtin:NAME; NAME= before one names its picture")
      ->type_name("[NAME=]PRESET")
      ->required();
  command->add_option("-o,--output", options->folder, "Folder to write to; made where its parent exists")
      ->type_name("FOLDER")
      ->required();
  command->add_option("--size", options->size, "Pixels, 128x128 by default")->type_name("WxH");
  command->add_option("--samples", options->samples, "Samples a pixel, 8 by default")
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20));
  command->footer(R"(
Skin is drawn on the embedded head, an eye and a lens from near, anything else on a ball; a tag that names a slot of
the head, such as hair, puts a preset there. Each picture is a PNG named like its preset, and its file name goes to
stdout as soon as it is there. One preset that cannot be drawn is an error; the others are drawn all the same.

Examples:
  dermis thumbnails builtin:jade builtin:face_tone_iv -o thumbnails
  dermis thumbnails *.json --size 256x256 --samples 32 -o thumbnails)");
  command->callback([options, &action] { action = [options] { return thumbnails(*options); }; });
}

}  // namespace dermis::cli
