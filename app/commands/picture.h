// One still: rendered to convergence, read back, written.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/commands/headless.h"
#include "app/commands/look.h"
#include "renderer.h"

namespace dermis::cli {

struct PictureRequest {
  std::filesystem::path output;
  glm::ivec2 size{1280, 720};
  int samples = 64;
  std::vector<Aov> aovs;  ///< layers beside the beauty; EXR only
  bool metadata = true;
};

/// Endings that a picture may have.
inline constexpr std::array<std::string_view, 6> kPictureExtensions = {".png", ".jpg",  ".jpeg",
                                                                       ".tif", ".tiff", ".exr"};

/// The picture's layers in memory: display-encoded through the scene's view, or scene-linear where that is Raw and the
/// file an EXR.
[[nodiscard]] Outcome<std::vector<ImageLayer>> renderLayers(Renderer& renderer, const Look& look,
                                                            const PictureRequest& request, ProgressLine& progress);
[[nodiscard]] Outcome<void> writePicture(Renderer& renderer, const Look& look, const PictureRequest& request,
                                         std::vector<ImageLayer> layers);

}  // namespace dermis::cli
