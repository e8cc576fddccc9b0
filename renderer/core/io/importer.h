// The one narrow door to strangers' files: the import module, loaded at first use.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/scene/model.h"

namespace dermis {

/// What a header says of an image, without decoding it.
struct ImageInfo {
  int width = 0;
  int height = 0;
  int channels = 0;
  PixelType type = PixelType::U8;
  std::string format;  ///< "openexr", "png", …
  std::vector<std::string> channelNames;
  std::map<std::string, std::string> metadata;  ///< as text, among it "dermis" (see writeImage)
};

/// Limits a reader keeps; past them a file is refused (or reduced, where that is said) with a sentence.
struct ImageReadOptions {
  int maximumSize = 16384;  ///< pixels a side: larger ones are reduced to this by area averaging, with a warning
  bool asFloat = false;     ///< convert to 32-bit float (environments)
  bool tellReduced = true;  ///< the warning; without it the caller says it
};

struct ImageWriteOptions {
  std::map<std::string, std::string> metadata;  ///< keys and texts put in the file's header; empty: none
  int jpegQuality = 95;
};

/// Pure functions from bytes to checked buffers and back: no OpenGL, no globals, callable from any thread.
class Importer {
 public:
  virtual ~Importer() = default;

  /// Model in any format that Assimp reads. `path` gives the extension, the folder for side files and the name for
  /// messages. Errors: Input (missing, truncated, lying, empty, non-finite), Cancelled.
  [[nodiscard]] virtual Result<Model> loadModel(const std::filesystem::path& path,
                                                const std::stop_token& stop = {}) const = 0;

  /// Image in any format that OpenImageIO reads; more than four channels are cut to the first RGBA with a warning.
  [[nodiscard]] virtual Result<Image> loadImage(const std::filesystem::path& path, const ImageReadOptions& options,
                                                Warnings& warnings, const std::stop_token& stop = {}) const = 0;
  /// The same from memory; `name` gives the format's extension and the name for messages.
  [[nodiscard]] virtual Result<Image> loadImage(std::span<const std::byte> bytes, const std::string& name,
                                                const ImageReadOptions& options, Warnings& warnings) const = 0;
  [[nodiscard]] virtual Result<ImageInfo> inspectImage(const std::filesystem::path& path) const = 0;

  /// Writes PNG, JPEG, TIFF or EXR by the extension, beside the target and renamed. The first layer is the beauty;
  /// further ones need EXR (channels `name.R`, …). Errors: Runtime.
  [[nodiscard]] virtual Result<void> writeImage(const std::filesystem::path& path,
                                                const std::vector<ImageLayer>& layers,
                                                const ImageWriteOptions& options) const = 0;

  /// Writes .glb (metres), .obj with its .mtl, .ply or .stl (millimetres) by the extension: geometry, UVs and the
  /// slots' names. Errors: Runtime.
  [[nodiscard]] virtual Result<void> writeModel(const std::filesystem::path& path, const Model& model) const = 0;
};

/// The import module; loads it on the first call (thread-safe). Looks beside the executable, then in
/// `../lib/dermis/`. Errors: Runtime, where the module is missing or doesn't load.
[[nodiscard]] Result<const Importer*> importer();
/// Whether importer() has been called: start-up figures say so.
[[nodiscard]] bool importerLoaded();

/// Name of the one symbol that the module exports: `const dermis::Importer* dermis_importer()`.
inline constexpr const char* kImporterSymbol = "dermis_importer";

}  // namespace dermis
