// dermis bake: light and tables, as the renderer samples them when it draws.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "app/commands/bake.h"
#include "app/commands/commands.h"
#include "app/commands/headless.h"
#include "core/base/file_io.h"
#include "core/base/file_reference.h"
#include "core/base/json_text.h"
#include "core/base/number_format.h"
#include "core/io/asset_loader.h"
#include "core/io/disk_cache.h"
#include "lighting/bake_readback.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

struct EnvironmentOptions {
  std::string environment, folder;
  std::vector<std::string> roughness;  ///< as given: they name the files
  bool cached = false, radiance = false;
};

Outcome<void> writeJson(const fs::path& path, const Json& json) {
  const Result<void> written = writeFileAtomically(path, json.dump(2) + "\n");
  if (!written) return failure(written.error());
  return {};
}

/// The radiance in the real SH basis, nine RGB triples in the order (l,m) 00, 1−1, 10, 11, 2−2 … 22.
Json harmonicsJson(const EnvironmentReadback& baked) {
  Json json = Json::array();
  for (const glm::dvec3& c : baked.sphericalHarmonics) json.push_back({c.x, c.y, c.z});
  return json;
}

Json figuresJson(const EnvironmentReadback& baked, const std::vector<std::string>& roughness, const GlInfo& gl) {
  const EnvironmentFigures& f = baked.figures;
  Json json;
  json["version"] = DERMIS_VERSION;
  json["gl_renderer"] = gl.renderer;
  json["latlong_size"] = {kReadbackWidth, kReadbackHeight};
  json["perceptual_roughness"] = roughness;
  json["cube_sizes"] = {
      {"sharp", f.sharpFaceSize}, {"prefiltered", f.prefilteredFaceSize}, {"irradiance", f.irradianceFaceSize}};
  json["storage"] = f.floatStorage ? "RGBA32F" : "RGB9_E5";
  json["from_cache"] = f.fromCache;
  json["cleaned"] = {{"negative", f.cleaned.negative}, {"not_finite", f.cleaned.nonFinite}};
  json["milliseconds"] = {{"clean", f.cleanMs},         {"sources", f.sourcesMs},       {"sharp", f.sharpMs},
                          {"prefilter", f.prefilterMs}, {"irradiance", f.irradianceMs}, {"cache", f.cacheMs},
                          {"total", f.totalMs},         {"read_back", baked.readbackMs}};
  return json;
}

Outcome<std::vector<float>> parseRoughness(const std::vector<std::string>& texts) {
  std::vector<float> values;
  for (const std::string& text : texts) {
    const auto value = parseFloat(text);
    if (!value || *value < 0.0F || *value > 1.0F)
      return wrongUsage(fmt::format("--roughness: \"{}\" is not a perceptual roughness from 0 to 1", text));
    values.push_back(*value);
  }
  return values;
}

Outcome<int> bakeEnvironment(const EnvironmentOptions& options) {
  const Outcome<std::vector<float>> roughness = parseRoughness(options.roughness);
  if (!roughness) return tl::unexpected(roughness.error());
  EnvironmentSource source;
  source.builtin.clear();
  if (const auto name = builtinName(options.environment))
    source.builtin = *name;
  else
    source.path = options.environment;
  Warnings warnings;
  auto images = resolveEnvironment(source, fs::current_path(), {}, warnings);
  printWarnings(warnings);
  if (!images) return failure(images.error());
  if (options.radiance && !(*images)->latLong) return wrongUsage("--radiance: the environment is no lat-long picture");
  if (const auto made = makeFolder(options.folder); !made) return tl::unexpected(made.error());

  const auto headless = HeadlessRenderer::create();
  if (!headless) return tl::unexpected(headless.error());
  EnvironmentBakeOptions bake;
  if (options.cached) bake.cacheFolder = userCacheFolder("bakes");
  const auto baked = readBackEnvironment(*images, *roughness, bake, warnings);
  printWarnings(warnings);
  if (!baked) return failure(baked.error());

  const fs::path folder = options.folder;
  if (options.radiance)
    if (const auto done = writeExr(folder / "radiance.exr", *(*images)->latLong); !done)
      return tl::unexpected(done.error());
  if (const auto done = writeExr(folder / "irradiance.exr", baked->irradiance); !done)
    return tl::unexpected(done.error());
  for (std::size_t i = 0; i < baked->prefiltered.size(); ++i)
    if (const auto done =
            writeExr(folder / fmt::format("prefiltered_{}.exr", options.roughness[i]), baked->prefiltered[i]);
        !done)
      return tl::unexpected(done.error());
  if (const auto done = writeJson(folder / "sh9.json", harmonicsJson(*baked)); !done)
    return tl::unexpected(done.error());
  if (const auto done = writeJson(folder / "bake.json", figuresJson(*baked, options.roughness, (*headless)->glInfo()));
      !done)
    return tl::unexpected(done.error());
  return kDone;
}

struct DfgOptions {
  std::string geometry = "smith", output;
  int size = 128;
};

Outcome<int> bakeDfg(const DfgOptions& options) {
  if (const auto fine = checkOutputFile(options.output, kExrOnly); !fine) return tl::unexpected(fine.error());
  const auto headless = HeadlessRenderer::create();
  if (!headless) return tl::unexpected(headless.error());
  const auto table =
      readBackDfg(options.geometry == "smith" ? DfgGeometry::Smith : DfgGeometry::SchlickIbl, options.size);
  if (!table) return failure(table.error());
  if (const auto done = writeExr(options.output, *table); !done) return tl::unexpected(done.error());
  return kDone;
}

void addBakeEnvironment(CLI::App& bake, Action& action) {
  auto options = std::make_shared<EnvironmentOptions>();
  CLI::App* command =
      bake.add_subcommand("environment", "Irradiance, prefiltered radiance and spherical harmonics of an environment");
  command->add_option("ENVIRONMENT", options->environment, "Lat-long image, light rig (.json), or builtin:NAME")
      ->required();
  command->add_option("-o,--output", options->folder, "Folder to write to; made where its parent exists")
      ->type_name("FOLDER")
      ->required();
  command
      ->add_option("--roughness", options->roughness,
                   "Perceptual roughness 0..1 to prefilter for; repeatable, names the file as given")
      ->type_name("R")
      ->allow_extra_args(false);
  command->add_flag("--cached", options->cached, "Take what the cache on disk holds instead of baking anew");
  command->add_flag("--radiance", options->radiance,
                    "Write radiance.exr too: the environment itself, as a light rig makes it");
  command->footer(R"(
Writes lat-long images of 512x256, floats: irradiance.exr (irradiance / pi), prefiltered_R.exr for each R;
sh9.json, nine RGB triples of the radiance in the real SH basis; bake.json, sizes and times.

Examples:
  dermis bake environment studio.hdr -o baked --roughness 0.25 --roughness 1.0
  dermis bake environment my_rig.json -o baked --radiance)");
  command->callback([options, &action] { action = [options] { return bakeEnvironment(*options); }; });
}

void addBakeDfg(CLI::App& bake, Action& action) {
  auto options = std::make_shared<DfgOptions>();
  CLI::App* command =
      bake.add_subcommand("dfg", "The split sum's table: x = N.V, y = perceptual roughness, R scale, G bias");
  command->add_option("--geometry", options->geometry, "smith (height-correlated) or schlick_ibl (k = roughness^2 / 2)")
      ->type_name("NAME")
      ->transform(CLI::IsMember({"smith", "schlick_ibl"}, CLI::ignore_case));
  command->add_option("-o,--output", options->output, "The EXR to write")->type_name("F.exr")->required();
  command->add_option("--size", options->size, "Texels a side, 128 by default")
      ->type_name("N")
      ->check(CLI::Range(2, 4096));
  command->footer(R"(
Examples:
  dermis bake dfg -o dfg.exr
  dermis bake dfg --geometry schlick_ibl --size 64 -o dfg_schlick.exr)");
  command->callback([options, &action] { action = [options] { return bakeDfg(*options); }; });
}

}  // namespace

Outcome<void> makeFolder(const fs::path& folder) {
  std::error_code error;
  const fs::path parent = fs::absolute(folder).lexically_normal().parent_path();
  if (!fs::is_directory(folder, error) && fs::is_directory(parent, error)) fs::create_directory(folder, error);
  if (fs::is_directory(folder, error)) return {};
  return failure(Error{
      Error::Kind::Runtime,
      fmt::format("the folder {} does not exist and cannot be made; check its path and permissions", folder.string())});
}

void addBake(CLI::App& root, Action& action) {
  CLI::App* command = root.add_subcommand(
      "bake", "What the renderer samples: environments, the DFG table, a model's thickness and occlusion");
  command->require_subcommand(1);
  addBakeEnvironment(*command, action);
  addBakeDfg(*command, action);
  addBakeMesh(*command, action);
  addBakeLook(*command, action);
  command->footer(R"(
Examples:
  dermis bake environment studio.hdr -o baked --roughness 0.5
  dermis bake dfg --geometry smith -o dfg.exr
  dermis bake thickness head.glb -o thickness.exr)");
}

}  // namespace dermis::cli
