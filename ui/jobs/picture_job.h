// A still picture drawn beside the editor, by a Renderer of its own in a context of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>

#include "renderer.h"

class QOffscreenSurface;

namespace dermis {

struct PictureRequest {
  std::filesystem::path path;  ///< .png, .exr (scene-linear where the view is Raw, else as displayed), .jpg, .tif
  glm::ivec2 size{1920, 1080};
  int samples = 64;
  bool transparent = false;           ///< no background: alpha is the model's coverage
  bool allLayers = false;             ///< EXR: every image of the frame beside the beauty
  std::filesystem::path sceneFolder;  ///< what paths in the metadata are relative to
};

/// Header texts for a picture of a scene: how it was made. Given by the application.
using PictureMetadata = std::function<std::map<std::string, std::string>(
    const ResolvedScene& scene, const PictureRequest& request, const std::string& glRenderer)>;

/// Draws and writes; to be called on a worker, with a surface made on the GUI thread. `progress` gets 0..1 from the
/// worker. Errors: Runtime, Input, Cancelled.
[[nodiscard]] Result<void> drawPicture(QOffscreenSurface& surface, const std::shared_ptr<const ResolvedScene>& scene,
                                       const PictureRequest& request, const std::filesystem::path& cacheFolder,
                                       const PictureMetadata& metadata, const std::function<void(double)>& progress,
                                       std::stop_token stop);

}  // namespace dermis
