// dermis export: what the program carries or has read, as files for other programs.
#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/look.h"
#include "app/commands/picture.h"
#include "core/builtin/maps.h"
#include "core/io/importer.h"

namespace dermis::cli {
namespace {

constexpr std::array<std::string_view, 4> kModelExtensions = {".glb", ".obj", ".ply", ".stl"};

struct ExportOptions {
  std::string source, output;
};

Outcome<int> done(const Result<void>& written) {
  if (!written) return failure(written.error());
  return kDone;
}

Outcome<int> exportModel(const ExportOptions& options) {
  if (const auto fine = checkOutputFile(options.output, kModelExtensions); !fine) return tl::unexpected(fine.error());
  const auto model = readModel(options.source);
  if (!model) return tl::unexpected(model.error());
  const auto module = importer();
  if (!module) return failure(module.error());
  return done((*module)->writeModel(options.output, **model));
}

Outcome<int> exportMap(const ExportOptions& options) {
  if (const auto fine = checkOutputFile(options.output, kPictureExtensions); !fine) return tl::unexpected(fine.error());
  const auto id = builtinMapId(options.source);
  if (!id) return wrongUsage(options.source + " " + id.error().message);
  const std::shared_ptr<const Image> image = builtinMap(*id);
  const auto module = importer();
  if (!module) return failure(module.error());
  static const std::vector<std::string> kChannels = {"R", "G", "B", "A"};
  ImageLayer layer;
  layer.image = *image;
  layer.channels.assign(kChannels.begin(), kChannels.begin() + image->channels);
  if (image->channels == 1) layer.channels = {"Y"};
  return done((*module)->writeImage(options.output, {layer}, {}));
}

template <class Work>
void add(CLI::App& command, Action& action, const char* name, const char* description, const char* what,
         const char* placeholder, const char* footer, Work work) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* sub = command.add_subcommand(name, description);
  sub->add_option(placeholder, options->source, what)->required();
  sub->add_option("-o,--output", options->output, "The file to write; its ending chooses the format")
      ->type_name("FILE")
      ->required();
  sub->footer(footer);
  sub->callback([options, &action, work] { action = [options, work] { return work(*options); }; });
}

}  // namespace

void addExport(CLI::App& root, Action& action) {
  CLI::App* command = root.add_subcommand("export", "Write a model or a built-in map for other programs");
  command->require_subcommand(1);
  add(*command, action, "model", "A model as the program has read or made it, .glb, .obj, .ply or .stl",
      "Model file, or builtin:NAME", "MODEL", R"(
Positions, normals, UVs and the slots' names; a GLB is in metres, the others in millimetres. Looks are presets and
stay out.

Examples:
  dermis export model builtin:head -o head.glb
  dermis export model scan.fbx -o scan.obj)",
      exportModel);
  add(*command, action, "map", "A map that the program makes, .png, .tif, .jpg or .exr",
      "builtin:NAME, with its parameters", "MAP", R"(
Examples:
  dermis export map "builtin:head_albedo?tone=3&size=2048" -o head_albedo.png
  dermis export map builtin:head_normal -o head_normal.png)",
      exportMap);
  command->footer(R"(
Examples:
  dermis export model builtin:head -o head.glb
  dermis export map builtin:head_albedo -o head_albedo.png)");
}

}  // namespace dermis::cli
