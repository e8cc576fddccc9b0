// Pictures drawn beside the editor, by a Renderer of its own in a context of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer.h"

class QOffscreenSurface;

namespace dermis {

enum class PictureKind {
  Still,
  Turntable,  ///< numbered frames: the camera goes once round its target
  Sheet       ///< several views in one picture, each with its name
};

struct NamedView {
  std::string name;
  Camera camera;
};

struct PictureRequest {
  PictureKind kind = PictureKind::Still;
  /// .png, .exr (scene-linear where the view is Raw, else as displayed), .jpg, .tif; of a turntable the name that the
  /// numbers follow; empty: nothing is written, the picture is given back.
  std::filesystem::path path;
  glm::ivec2 size{1920, 1080};  ///< of a sheet: of each of its views
  int samples = 64;
  bool transparent = false;           ///< no background: alpha is the model's coverage
  bool allLayers = false;             ///< EXR: every image of the frame beside the beauty
  std::filesystem::path sceneFolder;  ///< what paths in the metadata are relative to
  std::string view;                   ///< view transform; empty: the scene's
  ReferenceObjects references;
  int frames = 36;               ///< of a turntable
  std::vector<NamedView> views;  ///< of a sheet
};

/// What came out.
struct DrawnPicture {
  std::vector<std::filesystem::path> files;
  Image image;  ///< U8 RGBA; where no path was given
};

/// The file of frame `index` of a turntable: NAME_0001.png for the first.
[[nodiscard]] std::filesystem::path framePath(const std::filesystem::path& path, int index);
/// `camera` turned about +Y through its target.
[[nodiscard]] Camera turnedCamera(const Camera& camera, double degrees);

/// Header texts for a picture of a scene: how it was made. Given by the application.
using PictureMetadata = std::function<std::map<std::string, std::string>(
    const ResolvedScene& scene, const PictureRequest& request, const std::string& glRenderer)>;

/// Draws and writes; to be called on a worker, with a surface made on the GUI thread. `progress` gets 0..1 from the
/// worker. Errors: Runtime, Input, Cancelled.
[[nodiscard]] Result<DrawnPicture> drawPicture(QOffscreenSurface& surface,
                                               const std::shared_ptr<const ResolvedScene>& scene,
                                               const PictureRequest& request, const std::filesystem::path& cacheFolder,
                                               const PictureMetadata& metadata,
                                               const std::function<void(double)>& progress,
                                               const std::stop_token& stop);

}  // namespace dermis
