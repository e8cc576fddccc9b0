// What the program shows without a file: its own head in the studio.
#pragma once

#include <span>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/model.h"
#include "core/scene/scene.h"

namespace dermis {

/// Names that a scene's `model.builtin` takes, for messages and help: "head", "sphere", …
[[nodiscard]] std::span<const std::string_view> builtinModels();

/// A model made in code. "default" has the slots `skin`, `eye`, `gold`, each with its own material as the imported
/// one. "head" is the embedded head (head/head.h), "head-low" and "head-high" its other levels of detail.
/// Errors: Input, an unknown name.
[[nodiscard]] Result<Model> builtinModel(std::string_view name);

/// The embedded default look, complete: model, a material for each slot, camera, environment, view.
[[nodiscard]] Scene defaultLook();

}  // namespace dermis
