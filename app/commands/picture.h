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
  std::vector<Aov> aovs;  ///< besides the beauty: layers of an EXR, else files of their own
  bool metadata = true;
  ReferenceObjects references;
};

/// Endings that a picture may have.
inline constexpr std::array<std::string_view, 6> kPictureExtensions = {".png", ".jpg",  ".jpeg",
                                                                       ".tif", ".tiff", ".exr"};

/// The picture's layers in memory: display-encoded through the scene's view, or scene-linear where that is Raw and the
/// file an EXR.
[[nodiscard]] Outcome<std::vector<ImageLayer>> renderLayers(Renderer& renderer, const Look& look,
                                                            const PictureRequest& request, ProgressLine& progress);
/// Where the picture of an AOV goes beside an output that holds no layers: face.png → face.thickness.png.
[[nodiscard]] std::filesystem::path aovFile(const std::filesystem::path& output, std::string_view aov);
/// Writes the layers: an EXR with all of them, or the picture and a file for each AOV.
[[nodiscard]] Outcome<void> writePicture(Renderer& renderer, const Look& look, const PictureRequest& request,
                                         std::vector<ImageLayer> layers);

}  // namespace dermis::cli
