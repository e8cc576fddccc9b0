// The module's one exported symbol.
#include <OpenImageIO/imageio.h>

#include "core/io/importer.h"
#include "import/image_loader.h"
#include "import/image_writer.h"
#include "import/model_loader.h"
#include "import/model_writer.h"

namespace dermis {
namespace {

class ModuleImporter final : public Importer {
 public:
  ModuleImporter() {
    // Two threads a decode: several images load at once, and a decoder that takes every core starves the window.
    OIIO::attribute("threads", 2);
    OIIO::attribute("exr_threads", 2);
  }

  Result<Model> loadModel(const std::filesystem::path& path, const std::stop_token& stop) const override {
    return import::loadModel(path, stop);
  }
  Result<Image> loadImage(const std::filesystem::path& path, const ImageReadOptions& options, Warnings& warnings,
                          const std::stop_token& stop) const override {
    return import::loadImage(path, options, warnings, stop);
  }
  Result<Image> loadImage(std::span<const std::byte> bytes, const std::string& name, const ImageReadOptions& options,
                          Warnings& warnings) const override {
    return import::loadImage(bytes, name, options, warnings);
  }
  Result<ImageInfo> inspectImage(const std::filesystem::path& path) const override {
    return import::inspectImage(path);
  }
  Result<void> writeImage(const std::filesystem::path& path, const std::vector<ImageLayer>& layers,
                          const ImageWriteOptions& options) const override {
    return import::writeImage(path, layers, options);
  }
  Result<void> writeModel(const std::filesystem::path& path, const Model& model) const override {
    return import::writeModel(path, model);
  }
};

}  // namespace
}  // namespace dermis

extern "C" const dermis::Importer* dermis_importer() {
  static const dermis::ModuleImporter importer;
  return &importer;
}
