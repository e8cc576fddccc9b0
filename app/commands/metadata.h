// What a picture says about itself: enough to render it again.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "app/commands/look.h"
#include "core/base/json_text.h"
#include "renderer.h"

namespace dermis::cli {

/// Key of the picture's header under which the JSON stands.
inline constexpr const char* kMetadataKey = "dermis";

/// How the picture was made, beside its look.
struct PictureFacts {
  glm::ivec2 size{0};
  int samples = 0;
  std::string view;  ///< "Raw": scene-linear
  std::string glRenderer;
  std::string aov;  ///< where the file shows another image of the frame than the picture
  ReferenceObjects references;
};

/// {"program", "version", "gl_renderer", "size", "samples", "view", "aov", "references", "scene", "inputs": [{"path",
/// "xxh64"}]}: the scene with every preset inline, paths relative to its folder and only file names outside it.
[[nodiscard]] std::map<std::string, std::string> pictureMetadata(const Look& look, const PictureFacts& facts);

}  // namespace dermis::cli
