// dermis bake thickness, dermis bake occlusion: maps in a model's texture layout.
#include <atomic>
#include <chrono>
#include <future>
#include <memory>

#include "app/commands/bake.h"
#include "app/commands/look.h"
#include "core/bake/texel_bake.h"
#include "core/io/importer.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

struct MeshOptions {
  BakedMap map = BakedMap::Thickness;
  std::string model, output;
  int size = 1024;
  float millimetresPerUnit = 0.0F;  ///< 0: the file's own
};

Outcome<int> bakeMesh(const MeshOptions& options) {
  if (const auto fine = checkOutputFile(options.output, kExrOnly); !fine) return tl::unexpected(fine.error());
  const auto model = readModel(options.model);
  if (!model) return tl::unexpected(model.error());

  ProgressLine progress;
  std::atomic<float> share = 0.0F;
  TexelBakeOptions texels;
  texels.size = options.size;
  texels.millimetresPerUnit =
      options.millimetresPerUnit > 0.0F ? options.millimetresPerUnit : (*model)->millimetresPerUnit;
  texels.progress = &share;
  const auto work = [&] { return bakeTexels(**model, options.model, options.map, texels); };
  std::future<Result<Image>> baking = std::async(std::launch::async, work);
  const char* what = options.map == BakedMap::Thickness ? "measuring thickness" : "measuring occlusion";
  while (baking.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) progress.show(what, share);
  progress.clear();
  const Result<Image> image = baking.get();
  if (!image) return failure(image.error());
  if (const auto done = writeExr(options.output, *image); !done) return tl::unexpected(done.error());
  return kDone;
}

void addMap(CLI::App& bake, Action& action, BakedMap map, const char* name, const char* description,
            const char* footer) {
  auto options = std::make_shared<MeshOptions>();
  options->map = map;
  CLI::App* command = bake.add_subcommand(name, description);
  command->add_option("MODEL", options->model, "A model's file, or builtin:NAME")->required();
  command->add_option("-o,--output", options->output, "The EXR to write")->type_name("F.exr")->required();
  command->add_option("--size", options->size, "Texels a side, 1024 by default")
      ->type_name("N")
      ->check(CLI::Range(8, 8192));
  if (map == BakedMap::Thickness)
    command->add_option("--millimetres-per-unit", options->millimetresPerUnit, "Instead of the file's own unit")
        ->type_name("MM")
        ->check(CLI::PositiveNumber);
  command->footer(footer);
  command->callback([options, &action] { action = [options] { return bakeMesh(*options); }; });
}

}  // namespace

Outcome<void> writeExr(const fs::path& path, const Image& image) {
  const Result<const Importer*> module = importer();
  if (!module) return failure(module.error());
  const std::vector<std::string> names = {"R", "G", "B", "A"};
  const ImageLayer layer{"", {names.begin(), names.begin() + image.channels}, image};
  const Result<void> written = (*module)->writeImage(path, {layer}, {});
  if (!written) return failure(written.error());
  return {};
}

void addBakeMesh(CLI::App& bake, Action& action) {
  addMap(bake, action, BakedMap::Thickness, "thickness", "How thick a model is under each texel, in millimetres", R"(
Writes one float a texel, R: millimetres of material behind the surface, 500 at most (which is also what an
open sheet has). Between the islands stands what the nearest one has.

Examples:
  dermis bake thickness head.glb -o thickness.exr
  dermis bake thickness head.obj --millimetres-per-unit 10 --size 2048 -o thickness.exr)");
  addMap(bake, action, BakedMap::Occlusion, "occlusion", "Ambient occlusion under each texel, 1 in the open", R"(
Writes one float a texel, R: the cosine-weighted share of the sky that the model itself leaves free.

Examples:
  dermis bake occlusion head.glb -o occlusion.exr)");
}

}  // namespace dermis::cli
