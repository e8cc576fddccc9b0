// Environments made in code, so that there is light without a file. Deterministic, linear Rec.709.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/scene/resolved_scene.h"

namespace dermis {

struct BuiltinEnvironmentRow {
  std::string_view id;        ///< as in files: "studio"
  std::string_view label;     ///< for people
  std::string_view sentence;  ///< what it is
};
[[nodiscard]] std::span<const BuiltinEnvironmentRow> builtinEnvironments();

/// The environment as a 512×256 float lat-long image; null for an unknown name. Takes a few milliseconds.
[[nodiscard]] std::shared_ptr<const EnvironmentImages> builtinEnvironment(std::string_view id);

}  // namespace dermis
