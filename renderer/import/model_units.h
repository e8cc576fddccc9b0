// How long a model's unit is, and which way is up.
#pragma once

#include <assimp/scene.h>

#include <string>
#include <string_view>

#include "core/scene/model.h"

namespace dermis::import {

/// What must be done to a parsed scene for +Y to be up and its numbers to be the file's own: FBX's axes, which Assimp
/// leaves as they are, and COLLADA's unit, which Assimp turns into metres.
[[nodiscard]] glm::dmat4 correction(const aiScene& scene, const std::string& format, std::string_view text);

/// Sets Model::millimetresPerUnit and unitSource: glTF's metre, FBX's and COLLADA's own unit, else a guess from the
/// model's extent, which is taken for that of a head or bust. `format` is the file's lower-case extension; `text` the
/// file's bytes (COLLADA states its unit there).
void findUnit(Model& model, const aiScene& scene, const std::string& format, std::string_view text);

}  // namespace dermis::import
