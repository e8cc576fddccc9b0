// dermis bake look: what the embedded look is made of, for a package to bring along.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <future>
#include <memory>
#include <set>

#include "app/commands/bake.h"
#include "app/commands/look.h"
#include "core/bake/bake_cache.h"
#include "core/builtin/head/head_cache.h"
#include "core/io/disk_cache.h"
#include "lighting/environment_cache.h"
#include "passes/mesh_bake_job.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

/// Of the sharp cube where OpenGL is software and where it is not: two files for large environments, one for ours.
constexpr std::array kSharpFaces = {512, 1024};

/// Bakes the scene's model and light. The files that drawing it will ask for.
Outcome<std::vector<fs::path>> bakeScene(const ResolvedScene& scene, std::atomic<float>& share) {
  std::vector<fs::path> files;
  MeshBakeOptions mesh = meshBakeOptions(scene);
  mesh.cacheFolder = userCacheFolder("bakes");
  mesh.progress = &share;
  if (const auto baked = bakeMesh(*scene.model, mesh); !baked) return failure(baked.error());
  files.push_back(meshBakeFile(*scene.model, mesh));
  for (const int face : kSharpFaces) {
    EnvironmentBakeOptions options;
    options.cacheFolder = userCacheFolder("bakes");
    options.maximumSharpFace = face;
    if (const auto baked = bakeEnvironment(*scene.environment, options, {}, &share); !baked)
      return failure(baked.error());
    files.push_back(environmentCacheFile(options, *scene.environment));
  }
  return files;
}

/// What an earlier version of the look left there: nothing has read or written it since `start`.
void removeUnused(fs::file_time_type start) {
  for (const char* kind : {"heads", "maps", "bakes"}) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(userCacheFolder(kind), error))
      if (entry.last_write_time(error) < start && !error) fs::remove(entry.path(), error);
  }
}

Outcome<int> bakeLook(const fs::path& folder) {
  if (const auto made = makeFolder(folder); !made) return tl::unexpected(made.error());
  const auto start = fs::file_time_type::clock::now();
  keepCacheIn(fs::absolute(folder));

  ProgressLine progress;
  Warnings warnings;
  const Outcome<Look> look = resolveLook({}, progress, warnings);
  printWarnings(warnings);
  if (!look) return tl::unexpected(look.error());
  std::atomic<float> share = 0.0F;
  auto baking = std::async(std::launch::async, [&] { return bakeScene(look->resolved, share); });
  while (baking.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
    progress.show("measuring light and thickness", share);
  progress.clear();
  Outcome<std::vector<fs::path>> files = baking.get();
  if (!files) return tl::unexpected(files.error());

  files->push_back(headCacheFile(HeadLevel::Medium));
  // A cache that cannot be written is no fault anywhere else; here it is all there is to do.
  for (const fs::path& file : *files) {
    std::error_code error;
    if (!fs::exists(file, error))
      return failure(Error{Error::Kind::Runtime, fmt::format("{} could not be written; check the room on the disk and "
                                                             "the folder's permissions",
                                                             file.string())});
  }
  removeUnused(start);
  return kDone;
}

}  // namespace

void addBakeLook(CLI::App& bake, Action& action) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command =
      bake.add_subcommand("look", "What the embedded look is made of, so that a first start need not make it");
  command->add_option("-o,--output", *folder, "Folder to write to; made where its parent exists")
      ->type_name("FOLDER")
      ->required();
  command->footer(R"(
Head, maps, thickness and light. A program finds them in ../share/dermis/cache beside its own folder; what is
there and still right is kept, what no version of the look asks for any more is removed.

Examples:
  dermis bake look -o build/share/dermis/cache)");
  command->callback([folder, &action] { action = [folder] { return bakeLook(*folder); }; });
}

}  // namespace dermis::cli
