#include "app/commands/metadata.h"

#include "core/base/file_reference.h"
#include "core/io/content_hash.h"
#include "core/scene/scene_io.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

/// A path inside the scene's folder stays relative to it; of any other only the file's name is told.
std::string discreet(const std::string& path, const fs::path& folder) {
  if (path.empty() || namesNoFile(path)) return path;
  fs::path p(path);
  if (p.is_absolute() && !folder.empty()) p = p.lexically_relative(folder);
  p = p.lexically_normal();
  const bool outside = p.is_absolute() || p.empty() || *p.begin() == ".." || folder.empty();
  return outside ? p.filename().string() : p.generic_string();
}

/// A copy of the scene whose paths give nothing away and whose presets stand inline.
Scene discreetScene(const Look& look) {
  Scene scene = look.resolved.scene;
  scene.model.path = discreet(scene.model.path, look.folder);
  for (ModelFilePart& part : scene.model.parts) part.path = discreet(part.path, look.folder);
  scene.environment.path = discreet(scene.environment.path, look.folder);
  for (std::string& face : scene.environment.faces) face = discreet(face, look.folder);
  // Each slot by its own name: what the model's file said is inline too, so that nothing depends on how it is read.
  scene.materials.clear();
  for (std::size_t i = 0; i < look.resolved.slots.size(); ++i) {
    MaterialBinding& binding = scene.materials[look.resolved.model->slots[i].name];
    binding.material = look.resolved.slots[i].material;
    for (TextureBinding& texture : binding.material.textures) texture.path = discreet(texture.path, look.folder);
  }
  return scene;
}

}  // namespace

std::map<std::string, std::string> pictureMetadata(const Look& look, const PictureFacts& facts) {
  Json json;
  json["program"] = "dermis";
  json["version"] = DERMIS_VERSION;
  json["gl_renderer"] = facts.glRenderer;
  json["size"] = {facts.size.x, facts.size.y};
  json["samples"] = facts.samples;
  json["view"] = facts.view;
  if (!facts.aov.empty()) json["aov"] = facts.aov;
  if (facts.references != ReferenceObjects{})
    json["references"] = {{"balls", facts.references.balls}, {"chart", facts.references.chart}};
  Json inputs = Json::array();
  for (const fs::path& input : look.inputs) {
    const Result<std::uint64_t> hash = contentHashOfFile(input);
    if (hash) inputs.push_back({{"path", discreet(input.string(), look.folder)}, {"xxh64", hexadecimal(*hash)}});
  }
  json["inputs"] = std::move(inputs);
  // With an empty folder the paths are written as they are: they have been made discreet already.
  const std::string scene = writeScene(discreetScene(look), {});
  json["scene"] = Json::parse(scene);
  return {{kMetadataKey, json.dump(-1, ' ', false, Json::error_handler_t::replace)}};
}

}  // namespace dermis::cli
