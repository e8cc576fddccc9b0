#include "ui/document/material_images.h"

#include <charconv>

#include "core/io/importer.h"

namespace dermis {
namespace {

Result<std::shared_ptr<const Image>> decodeEmbedded(const std::string& path, const std::shared_ptr<const Model>& model,
                                                    Warnings& warnings) {
  std::size_t number = 0;
  const std::string_view digits = std::string_view(path).substr(std::string_view("embedded:").size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || !model || number >= model->embedded.size())
    return inputError(path + " names an image inside a model, and the model open now has none of that number");
  const Result<const Importer*> door = importer();
  if (!door) return tl::unexpected(door.error());
  const EmbeddedImage& image = model->embedded[number];
  Result<Image> decoded = (*door)->loadImage(image.bytes, image.name, ImageReadOptions{}, warnings);
  if (!decoded) return tl::unexpected(decoded.error());
  return std::make_shared<const Image>(std::move(*decoded));
}

}  // namespace

Result<ResolvedMaterial> decodeMaps(const Material& material, const std::shared_ptr<const Model>& model,
                                    const ResolveOptions& options, Warnings& warnings) {
  ResolvedMaterial resolved;
  resolved.material = material;
  for (std::size_t i = 0; i < kTextureSlotCount; ++i) {
    const std::string& path = material.textures.at(i).path;
    if (path.empty()) continue;
    if (options.stop.stop_requested()) return cancelledError();
    Result<std::shared_ptr<const Image>> image =
        path.starts_with("embedded:") ? decodeEmbedded(path, model, warnings) : resolveTexture(path, options, warnings);
    if (!image) {
      if (!options.keepMissingMaps || image.error().kind != Error::Kind::Input) return tl::unexpected(image.error());
      warnings.push_back("the " + std::string(textureSlots().at(i).id) + " map is missing: " + image.error().message);
      continue;
    }
    resolved.images.at(i) = std::move(*image);
  }
  return resolved;
}

}  // namespace dermis
