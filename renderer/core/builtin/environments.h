// Environments that the program carries, so that there is light without a file: the light rigs of resources/rigs.
#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/light_rig/light_rig.h"
#include "core/scene/resolved_scene.h"

namespace dermis {

struct BuiltinEnvironmentRow {
  std::string id;        ///< as in files: "studio"
  std::string label;     ///< for people
  std::string sentence;  ///< what it is
};
/// In the order in which people look through them.
[[nodiscard]] std::span<const BuiltinEnvironmentRow> builtinEnvironments();

/// Errors: Input, where there is none of that name.
[[nodiscard]] Result<LightRig> builtinRig(std::string_view id);

/// A rig as light; `width` 0: as wide as the rig says. Errors: Cancelled.
[[nodiscard]] Result<std::shared_ptr<const EnvironmentImages>> environmentOfRig(const LightRig& rig,
                                                                                const std::string& name, int width = 0,
                                                                                const std::stop_token& stop = {});

/// Null for an unknown name.
[[nodiscard]] std::shared_ptr<const EnvironmentImages> builtinEnvironment(std::string_view id, int width = 0);

}  // namespace dermis
