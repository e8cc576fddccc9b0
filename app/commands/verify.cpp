// dermis verify: renders a picture again from what it says about itself, and compares.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/metadata.h"
#include "app/commands/picture.h"
#include "core/base/file_reference.h"
#include "core/image/comparison.h"
#include "core/io/asset_loader.h"
#include "core/io/content_hash.h"
#include "core/io/importer.h"
#include "core/io/udim.h"
#include "core/scene/scene_io.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
  std::string image;
  std::vector<std::string> folders;
  double tolerance = 0.02;
};

/// What the picture's header says, checked.
struct Recipe {
  Scene scene;
  std::string view, glRenderer;
  glm::ivec2 size{0};
  int samples = 0;
  Aov aov = Aov::Beauty;
  ReferenceObjects references;
  Json inputs;
};

Outcome<Recipe> readRecipe(const std::string& image, const ImageInfo& info, Warnings& warnings) {
  const auto found = info.metadata.find(kMetadataKey);
  if (found == info.metadata.end())
    return failure(Error{
        Error::Kind::Input,
        fmt::format(
            "{} does not say how it was made; only pictures that dermis wrote without --no-metadata can be verified",
            image)});
  const Json json = Json::parse(found->second, nullptr, false);
  const auto broken = [&](std::string_view what) {
    return failure(Error{Error::Kind::Input, fmt::format("{}: its metadata is damaged ({})", image, what)});
  };
  if (!json.is_object() || !json.contains("scene")) return broken("no scene");
  const Json size = json.value("size", Json());
  if (!size.is_array() || size.size() != 2 || !size[0].is_number_integer() || !size[1].is_number_integer())
    return broken("no size");
  Recipe recipe;
  recipe.size = {size[0].get<int>(), size[1].get<int>()};
  const Json samples = json.value("samples", Json());
  if (!samples.is_number_integer() || samples.get<int>() < 1) return broken("no samples");
  recipe.samples = samples.get<int>();
  const Json aov = json.value("aov", Json("beauty"));
  const std::vector<Aov> all = allAovs();
  const auto named = std::find_if(all.begin(), all.end(), [&](Aov one) { return aov == Json(toString(one)); });
  if (named == all.end()) return broken("an AOV that this version does not have");
  recipe.aov = *named;
  if (const Json shown = json.value("references", Json()); shown.is_object())
    recipe.references = {shown.value("balls", Json()) == Json(true), shown.value("chart", Json()) == Json(true)};
  recipe.glRenderer = json.value("gl_renderer", Json("")).is_string() ? json.value("gl_renderer", std::string()) : "";
  recipe.inputs = json.value("inputs", Json::array());
  Result<Scene> scene = readScene(json["scene"].dump(), image, {}, warnings);
  if (!scene) return failure(scene.error());
  recipe.scene = std::move(*scene);
  return recipe;
}

/// The file that a path of the picture meant, looked for in the folders, with its hash checked.
class InputFinder {
 public:
  InputFinder(const Recipe& recipe, std::vector<fs::path> folders)
      : m_inputs(recipe.inputs), m_folders(std::move(folders)) {}

  Outcome<void> resolve(std::string& path, Warnings& warnings) const {
    if (path.empty() || namesNoFile(path)) return {};
    for (const fs::path& folder : m_folders)
      for (const fs::path& candidate : {folder / path, folder / fs::path(path).filename()}) {
        if (const std::vector<UdimTile> tiles = udimTiles(candidate); !tiles.empty()) {
          for (const UdimTile& tile : tiles)
            checkHash((fs::path(path).parent_path() / tile.file.filename()).string(), tile.file, warnings);
          path = fs::absolute(candidate).lexically_normal().string();
          return {};
        }
        std::error_code error;
        if (!fs::is_regular_file(candidate, error)) continue;
        checkHash(path, candidate, warnings);
        path = fs::absolute(candidate).lexically_normal().string();
        return {};
      }
    return failure(Error{
        Error::Kind::Input,
        fmt::format("{}, which the picture was made from, is not beside it; name its folder with --inputs", path)});
  }

 private:
  void checkHash(const std::string& path, const fs::path& file, Warnings& warnings) const {
    for (const Json& input : m_inputs)
      if (input.is_object() && input.value("path", Json()) == Json(path))
        if (const auto hash = contentHashOfFile(file); hash && input.value("xxh64", Json()) != Json(hexadecimal(*hash)))
          warnings.push_back(
              fmt::format("{} is not the file the picture was made from: its content has changed", file.string()));
  }

  Json m_inputs;
  std::vector<fs::path> m_folders;
};

Outcome<void> findInputs(Scene& scene, const InputFinder& finder, Warnings& warnings) {
  std::vector<std::string*> paths = {&scene.model.path, &scene.environment.path};
  for (ModelFilePart& part : scene.model.parts) paths.push_back(&part.path);
  for (std::string& face : scene.environment.faces) paths.push_back(&face);
  for (auto& [slot, binding] : scene.materials)
    for (TextureBinding& texture : binding.material.textures) paths.push_back(&texture.path);
  for (std::string* path : paths)
    if (auto found = finder.resolve(*path, warnings); !found) return found;
  return {};
}

Outcome<int> verify(const VerifyOptions& options) {
  const Result<const Importer*> module = importer();
  if (!module) return failure(module.error());
  Warnings warnings;
  const Result<ImageInfo> info = (*module)->inspectImage(options.image);
  if (!info) return failure(info.error());
  const Result<Image> before = (*module)->loadImage(options.image, {}, warnings);
  if (!before) return failure(before.error());
  Outcome<Recipe> recipe = readRecipe(options.image, *info, warnings);
  if (!recipe) return tl::unexpected(recipe.error());

  std::vector<fs::path> folders(options.folders.begin(), options.folders.end());
  folders.push_back(fs::absolute(options.image).parent_path());
  if (const auto found = findInputs(recipe->scene, InputFinder(*recipe, folders), warnings); !found)
    return tl::unexpected(found.error());
  ProgressLine progress;
  Result<ResolvedScene> resolved = resolveScene(recipe->scene, {}, {}, warnings);
  printWarnings(warnings);
  if (!resolved) return failure(resolved.error());

  const auto headless = HeadlessRenderer::create();
  if (!headless) return tl::unexpected(headless.error());
  Renderer& renderer = **headless;
  Look look;
  look.resolved = std::move(*resolved);
  PictureRequest request;
  request.output = options.image;
  request.size = recipe->size;
  request.samples = recipe->samples;
  request.references = recipe->references;
  if (recipe->aov != Aov::Beauty) request.aovs = {recipe->aov};
  auto layers = renderLayers(renderer, look, request, progress);
  if (!layers) return tl::unexpected(layers.error());
  Image& after = layers->back().image;
  after.name = "the picture rendered again";
  const Result<Comparison> result = compareImages(*before, after, options.tolerance);
  if (!result) return failure(result.error());
  const bool alike = result->maximum <= options.tolerance;
  fmt::print("{}  mean {:.6g}, maximum {:.6g}, {:.4f} % of the pixels past {:g}, FLIP {:.6g}\n",
             alike ? "same" : "different", result->mean, result->maximum, 100.0 * result->failing, options.tolerance,
             result->flip);
  if (recipe->glRenderer != renderer.glInfo().renderer)
    fmt::print("drawn then by {}, now by {}\n", recipe->glRenderer, renderer.glInfo().renderer);
  return alike ? kDone : kDifferent;
}

}  // namespace

void addVerify(CLI::App& root, Action& action) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = root.add_subcommand("verify", "Render a picture again from its metadata, and compare");
  command->add_option("IMAGE", options->image, "A picture written by dermis render")->required();
  command
      ->add_option("--inputs", options->folders, "Folder with the files it was made from, beside its own; repeatable")
      ->type_name("FOLDER")
      ->allow_extra_args(false);
  command
      ->add_option("--tolerance", options->tolerance,
                   "Largest channel difference allowed, 0.02 by default; exit code 4 past it")
      ->type_name("T")
      ->check(CLI::NonNegativeNumber);
  command->footer(R"(
Examples:
  dermis verify face.png
  dermis verify delivered/face.exr --inputs assets --tolerance 0.001)");
  command->callback([options, &action] { action = [options] { return verify(*options); }; });
}

}  // namespace dermis::cli
