// From a scene's paths to decoded buffers: models, maps, environments. No OpenGL; callable from any thread.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/resolved_scene.h"
#include "core/scene/scene.h"

namespace dermis {

/// Remembers what has been decoded, for as long as somebody holds it, so that resolving an edited scene again decodes
/// only what is new. A file is the same while its absolute path, modification time and size are. Thread-safe.
class AssetCache {
 public:
  /// Path, modification time and size of a file as one text; empty where there is no such file.
  [[nodiscard]] static std::string fileKey(const std::filesystem::path& path);
  /// The same of a map, which may be a set of UDIM tiles: of all of them.
  [[nodiscard]] static std::string mapKey(const std::filesystem::path& path);

  template <class T>
  [[nodiscard]] std::shared_ptr<const T> find(const std::string& key) const {
    return std::static_pointer_cast<const T>(findAny(key));
  }
  void put(const std::string& key, const std::shared_ptr<const void>& value);

 private:
  [[nodiscard]] std::shared_ptr<const void> findAny(const std::string& key) const;

  mutable std::mutex m_mutex;
  std::map<std::string, std::weak_ptr<const void>> m_entries;
};

struct ResolveOptions {
  std::stop_token stop;
  /// What is being done and 0..1; may be called from any thread, never from two at once.
  std::function<void(std::string_view what, double fraction)> progress;
  /// Kept by the caller between calls; null: everything is decoded anew.
  std::shared_ptr<AssetCache> cache;
  /// Slots that the scene binds nothing to wear what the model's own file says, rather than `skin` with its defaults.
  bool importedMaterials = false;
  /// A map that is missing or can't be read stays bound, without a picture, and is a warning: an editor can ask where
  /// it went. Else it is an error.
  bool keepMissingMaps = false;
};

/// Everything that `scene` points to, decoded. Relative paths count from `baseFolder`. Maps are decoded concurrently.
/// Never loads the import module where all is built in. Errors: Input (a missing or unusable file, named with the slot
/// it was meant for), Runtime (the import module), Cancelled. A map that only a model's own file names and that is
/// missing is a warning. Warnings of a model that came from the cache are not repeated.
[[nodiscard]] Result<ResolvedScene> resolveScene(const Scene& scene, const std::filesystem::path& baseFolder,
                                                 const ResolveOptions& options, Warnings& warnings);

/// The three steps of it, for those who need one alone.
[[nodiscard]] Result<std::shared_ptr<const Model>> resolveModel(const ModelSource& source,
                                                                const std::filesystem::path& baseFolder,
                                                                const ResolveOptions& options, Warnings& warnings);
[[nodiscard]] Result<std::shared_ptr<const EnvironmentImages>> resolveEnvironment(
    const EnvironmentSource& source, const std::filesystem::path& baseFolder, const ResolveOptions& options,
    Warnings& warnings);
/// One image file as the GPU takes it (8-bit, 16-bit, half or float as stored).
[[nodiscard]] Result<std::shared_ptr<const Image>> resolveTexture(const std::filesystem::path& path,
                                                                  const ResolveOptions& options, Warnings& warnings);

}  // namespace dermis
