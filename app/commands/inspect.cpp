// dermis inspect: what a model, image, preset or scene holds.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/commands/commands.h"
#include "core/base/file_io.h"
#include "core/base/json_text.h"
#include "core/image/comparison.h"
#include "core/image/image_tiles.h"
#include "core/io/content_hash.h"
#include "core/io/importer.h"
#include "core/io/udim.h"
#include "core/light_rig/light_colour.h"
#include "core/light_rig/rig_io.h"
#include "core/light_rig/rig_picture.h"
#include "core/material/parameter_table.h"
#include "core/material/preset_io.h"
#include "core/material/value_json.h"
#include "core/scene/scene_io.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 14> kImageExtensions = {
    ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr", ".tga", ".bmp", ".webp", ".psd", ".dds", ".pfm", ".ppm"};

Json vectorJson(const glm::vec3& v) { return {jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.z)}; }

Json texturesJson(const Material& material) {
  Json json = Json::object();
  for (const TextureSlotRow& row : textureSlots())
    if (const TextureBinding& binding = material.texture(row.slot); binding.present())
      json[std::string(row.id)] = binding.path;
  return json;
}

Json materialJson(const Material& material) {
  Json json;
  if (!material.name.empty()) json["name"] = material.name;
  json["model"] = shadingModelRow(material.model).id;
  Json parameters = Json::object();
  for (const ParameterRow& row : parameterTable())
    if (row.usedBy(material.model))
      parameters[std::string(row.id)] = parameterToJson(row, row.get(material.parameters));
  json["parameters"] = std::move(parameters);
  json["textures"] = texturesJson(material);
  return json;
}

Outcome<Json> inspectModel(const fs::path& path, Warnings& warnings) {
  const Result<const Importer*> module = importer();
  if (!module) return failure(module.error());
  const Result<Model> model = (*module)->loadModel(path);
  if (!model) return failure(model.error());
  warnings.insert(warnings.end(), model->warnings.begin(), model->warnings.end());
  const glm::vec3 extent = model->bounds.empty() ? glm::vec3(0.0F) : model->bounds.max - model->bounds.min;
  Json json;
  json["kind"] = "model";
  json["vertices"] = model->positions.size();
  json["triangles"] = model->indices.size() / 3;
  json["bounds"] = {{"min", vectorJson(model->bounds.min)}, {"max", vectorJson(model->bounds.max)}};
  json["millimetres_per_unit"] = jsonNumber(model->millimetresPerUnit);
  json["unit"] = model->unitSource;
  json["height_mm"] = jsonNumber(extent.y * model->millimetresPerUnit);
  json["uvs"] = model->hasUvs;
  Json slots = Json::array();
  for (std::size_t i = 0; i < model->slots.size(); ++i) {
    std::size_t triangles = 0;
    for (const ModelPart& part : model->parts)
      if (part.slot == i) triangles += part.indexCount / 3;
    slots.push_back({{"name", model->slots[i].name},
                     {"triangles", triangles},
                     {"textures", texturesJson(model->slots[i].imported)}});
  }
  json["slots"] = std::move(slots);
  Json embedded = Json::array();
  for (const EmbeddedImage& image : model->embedded)
    embedded.push_back({{"name", image.name}, {"bytes", image.bytes.size()}});
  json["embedded_images"] = std::move(embedded);
  return json;
}

/// Least, mean and largest of the finite values of a channel, and how many are not finite or negative.
Json channelStatistics(const Image& image) {
  Json json = Json::array();
  const int channels = image.channels;
  static constexpr std::array<const char*, 4> kNames = {"R", "G", "B", "A"};
  for (int c = 0; c < channels; ++c) {
    const bool alpha = channels % 2 == 0 && c == channels - 1;
    const std::vector<float> values = channelValues(image, alpha ? 3 : c);
    double sum = 0.0;
    float least = INFINITY, largest = -INFINITY;
    std::size_t finite = 0, negative = 0;
    for (const float v : values) {
      if (!std::isfinite(v)) continue;
      ++finite;
      sum += static_cast<double>(v);
      least = std::min(least, v);
      largest = std::max(largest, v);
      if (v < 0.0F) ++negative;
    }
    Json row = {{"name", alpha ? "A" : channels < 3 ? "Y" : kNames.at(static_cast<std::size_t>(c))}};
    if (finite > 0) {
      row["min"] = jsonNumber(least);
      row["mean"] = sum / static_cast<double>(finite);
      row["max"] = jsonNumber(largest);
    }
    row["negative"] = negative;
    row["not_finite"] = values.size() - finite;
    json.push_back(std::move(row));
  }
  return json;
}

constexpr std::array<const char*, 4> kPixelTypes = {"8-bit", "16-bit", "half", "float"};

Outcome<Json> inspectImage(const fs::path& path, Warnings& warnings) {
  const Result<const Importer*> module = importer();
  if (!module) return failure(module.error());
  const Result<ImageInfo> info = (*module)->inspectImage(path);
  if (!info) return failure(info.error());
  // Decoding it whole is what tells a truncated file from a good one.
  const Result<Image> image = (*module)->loadImage(path, {}, warnings);
  if (!image) return failure(image.error());
  Json json;
  json["kind"] = "image";
  json["format"] = info->format;
  json["width"] = info->width;
  json["height"] = info->height;
  json["type"] = kPixelTypes.at(static_cast<std::size_t>(info->type));
  json["channels"] = info->channelNames;
  json["statistics"] = channelStatistics(*image);
  Json metadata = Json::object();
  for (const auto& [key, text] : info->metadata) {
    Json parsed = key == "dermis" ? Json::parse(text, nullptr, false) : Json(text);
    metadata[key] = parsed.is_discarded() ? Json(text) : std::move(parsed);
  }
  json["metadata"] = std::move(metadata);
  if (const auto set = udimSetOf(path)) json["udim_set"] = set->filename().string();
  return json;
}

/// The tiles of a set, each by its header; decoded together for what they hold.
Outcome<Json> inspectUdimSet(const fs::path& path, Warnings& warnings) {
  const Result<const Importer*> module = importer();
  if (!module) return failure(module.error());
  const Result<Image> set = readUdimSet(path, **module, kMostUdimBytes, warnings, {});
  if (!set) return failure(set.error());
  Json json = {{"kind", "udim set"}, {"width", set->width}, {"height", tileHeight(*set)}};
  json["statistics"] = channelStatistics(*set);
  json["tiles"] = Json::array();
  for (const UdimTile& tile : udimTiles(path)) {
    const Result<ImageInfo> info = (*module)->inspectImage(tile.file);
    if (!info) return failure(info.error());
    json["tiles"].push_back({{"number", tile.number},
                             {"file", tile.file.filename().string()},
                             {"width", info->width},
                             {"height", info->height},
                             {"type", kPixelTypes.at(static_cast<std::size_t>(info->type))},
                             {"channels", info->channelNames}});
  }
  return json;
}

Outcome<Json> inspectPreset(const fs::path& path, Warnings& warnings) {
  const Result<Material> material = loadPreset(path, warnings);
  if (!material) return failure(material.error());
  Json json = {{"kind", "preset"}};
  json.update(materialJson(*material));
  return json;
}

Outcome<Json> inspectScene(const fs::path& path, Warnings& warnings) {
  const Result<Scene> scene = loadScene(path, warnings);
  if (!scene) return failure(scene.error());
  Json json = {{"kind", "scene"}};
  // As it would be saved beside itself: every default that is in force is then readable.
  json["scene"] = Json::parse(writeScene(*scene, fs::absolute(path).parent_path()));
  Json materials = Json::object();
  for (const auto& [slot, binding] : scene->materials) {
    materials[slot] = materialJson(binding.material);
    if (!binding.presetPath.empty()) materials[slot]["preset"] = binding.presetPath;
  }
  json["materials"] = std::move(materials);
  json["lights"] = scene->lights.size();
  return json;
}

Outcome<Json> inspectRig(const fs::path& path, Warnings& warnings) {
  const Result<LightRig> rig = loadRig(path, warnings);
  if (!rig) return failure(rig.error());
  const auto picture = rigPicture(*rig);
  if (!picture) return failure(picture.error());
  Json json = {{"kind", "rig"}};
  json["rig"] = Json::parse(writeRig(*rig));
  // Where a light meter would be held: towards the camera, and towards the sky.
  for (const auto& [name, normal] : {std::pair("front", glm::dvec3(0, 0, 1)), std::pair("up", glm::dvec3(0, 1, 0))}) {
    const glm::dvec3 e = irradianceOf(**picture, normal);
    json["irradiance"][name] = {e.r, e.g, e.b};
    json["illuminance_lux"][name] = luminance(e) * static_cast<double>(rig->whiteLuminance);
  }
  return json;
}

Outcome<Json> inspect(const fs::path& path, Warnings& warnings) {
  if (hasUdimToken(path)) return inspectUdimSet(path, warnings);
  const std::string extension = extensionOf(path);
  if (extension == ".dermis") return inspectScene(path, warnings);
  if (extension == ".json") {
    // Presets, rigs and sometimes scenes are called .json; the format says what a file is.
    const Result<std::string> text = readFile(path, kMaxJsonBytes);
    if (!text) return failure(text.error());
    const Json json = Json::parse(*text, nullptr, false);
    const Json format = json.is_object() ? json.value("format", Json()) : Json();
    if (format == Json(kRigFormat)) return inspectRig(path, warnings);
    return format == Json(kSceneFormat) ? inspectScene(path, warnings) : inspectPreset(path, warnings);
  }
  if (std::find(kImageExtensions.begin(), kImageExtensions.end(), extension) != kImageExtensions.end())
    return inspectImage(path, warnings);
  return inspectModel(path, warnings);
}

/// Indented "key: value" lines; lists of numbers stand on one line.
void printText(const Json& json, int indent) {
  const auto scalar = [](const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); };
  const auto flat = [](const Json& value) {
    return std::none_of(value.begin(), value.end(), [](const Json& v) { return v.is_structured(); });
  };
  for (const auto& [key, value] : json.items()) {
    const std::string label = json.is_array() ? "-" : key + ":";
    if (!value.is_structured()) {
      fmt::print("{:{}}{} {}\n", "", indent, label, scalar(value));
    } else if (value.empty() || (value.is_array() && flat(value))) {
      std::string line;
      for (const Json& v : value) line += (line.empty() ? "" : ", ") + scalar(v);
      fmt::print("{:{}}{} {}\n", "", indent, label, line.empty() ? "none" : line);
    } else {
      fmt::print("{:{}}{}\n", "", indent, label);
      printText(value, indent + 2);
    }
  }
}

}  // namespace

void addInspect(CLI::App& root, Action& action) {
  struct Options {
    std::string file;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = root.add_subcommand("inspect", "Say what a model, image, preset or scene holds");
  command->add_option("FILE", options->file, "The file; its ending says what it is")->required();
  command->add_flag("--json", options->json, "As JSON");
  command->footer(R"(
Examples:
  dermis inspect head.glb
  dermis inspect studio.hdr
  dermis inspect 'maps/skin.<UDIM>.png'
  dermis inspect look.png --json | jq .metadata.dermis.scene

Files are read whole, so exit code 3 tells a damaged one. Images show the least, mean and largest value of each
channel and what is not finite; pictures of this program show the scene they were made from.)");
  command->callback([options, &action] {
    action = [options]() -> Outcome<int> {
      Warnings warnings;
      Outcome<Json> json = inspect(options->file, warnings);
      printWarnings(warnings);
      if (!json) return tl::unexpected(json.error());
      Json whole = {{"file", fs::path(options->file).filename().string()}};
      if (const Result<std::uint64_t> hash = contentHashOfFile(options->file)) whole["xxh64"] = hexadecimal(*hash);
      whole.update(*json);
      if (options->json)
        fmt::print("{}\n", whole.dump(2, ' ', false, Json::error_handler_t::replace));
      else
        printText(whole, 0);
      return kDone;
    };
  });
}

}  // namespace dermis::cli
