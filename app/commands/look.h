// The look that a command line describes: a scene file or the embedded one, and the options that change it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/support.h"
#include "core/scene/resolved_scene.h"

namespace CLI {
class App;
}

namespace dermis::cli {

struct LookOptions {
  std::string scene, model, environment, camera, view;
  std::vector<std::string> materials;  ///< "[SLOT=]PRESET"
  std::vector<std::string> values;     ///< "[SLOT/]ID=VALUE"
};
void addLookOptions(CLI::App& command, LookOptions& options);

struct Look {
  ResolvedScene resolved;
  std::filesystem::path folder;               ///< of the scene file; empty without one
  std::vector<std::filesystem::path> inputs;  ///< every file that was read
  bool viewGiven = false;                     ///< --view was
};

/// Reads everything the look needs. Fails with 2 for unknown names, ids, slots and types on the command line, 3 for
/// unusable files.
[[nodiscard]] Outcome<Look> resolveLook(const LookOptions& options, ProgressLine& progress, Warnings& warnings);

/// Where every material is of a shader that encodes by itself the view becomes Raw: another would encode twice.
void takeViewOfShaders(ResolvedScene& resolved);

/// A model by itself: a file or "builtin:NAME". Prints its warnings.
[[nodiscard]] Outcome<std::shared_ptr<const Model>> readModel(const std::string& reference);

}  // namespace dermis::cli
