#include "core/material/preset_io.h"

#include <algorithm>
#include <vector>

#include "core/base/file_io.h"
#include "core/base/file_reference.h"
#include "core/builtin/maps.h"
#include "core/material/builtin_presets.h"
#include "core/material/parameter_table.h"
#include "core/material/value_json.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

const Json& emptyObject() {
  static const Json kEmpty = Json::object();
  return kEmpty;
}

/// Adds members whose keys are new.
void append(Json& object, const Json& more) {
  for (const auto& [key, value] : more.items()) appendMember(object, key, value);
}

// ---- reading

ShadingModel readModel(JsonFields& root, PresetPlace place) {
  const Json* value = root.find("model");
  const std::string pointer = root.pointerTo("model");
  if (value == nullptr) {
    if (place == PresetPlace::File) root.report().warn(pointer, "is missing; it is taken to be skin");
    return ShadingModel::Skin;
  }
  std::vector<std::string_view> ids;
  for (const ShadingModelRow& row : shadingModels()) ids.push_back(row.id);
  const auto refuse = [&](const std::string& found) {
    root.report().refuse(pointer, "must be " + listed(ids) + ", not " + found);
    return ShadingModel::Skin;
  };
  if (!value->is_string()) return refuse(std::string(typeName(*value)));
  const auto& id = value->get_ref<const std::string&>();
  const auto model = shadingModelFromId(id);
  return model ? *model : refuse(inQuotes(id));
}

/// One map; returns the keys that we don't know.
Json readTexture(const Json& json, const std::string& pointer, const fs::path& folder, TextureBinding& binding,
                 JsonReport& report) {
  JsonFields fields(json, pointer, report);
  if (fields.find("path") == nullptr) report.refuse(fields.pointerTo("path"), "is missing; it names the map's file");
  fields.read("path", binding.path);
  if (json.is_object() && binding.path.empty())
    report.refuse(fields.pointerTo("path"), "is empty; leave out the whole map instead");
  if (namesNoFile(binding.path) && !embeddedIndex(binding.path))
    if (const auto map = builtinMapId(binding.path); !map)
      report.refuse(fields.pointerTo("path"), "must name a file, embedded:N with a number, or one of " +
                                                  builtinMapNames() + "; " + inQuotes(binding.path) + " " +
                                                  map.error().message);
  binding.path = absoluteReference(binding.path, folder);
  if (std::string space; fields.find("color_space") != nullptr) {
    fields.read("color_space", space);
    binding.colorSpace = space;
  }
  int channel = static_cast<int>(binding.channel);
  fields.readWord("channel", {"r", "g", "b", "a", "luminance"}, channel);
  binding.channel = static_cast<TextureChannel>(channel);
  fields.read("invert", binding.invert);
  fields.read("flip_green", binding.flipGreen);
  fields.read("scale", binding.scale);
  glm::vec2 uvScale(binding.uvScale[0], binding.uvScale[1]);
  fields.read("uv_scale", uvScale);
  binding.uvScale = {uvScale.x, uvScale.y};
  return fields.unknown();
}

void readTextures(JsonFields& root, const fs::path& folder, Material& material) {
  const Json* value = root.find("textures");
  if (value == nullptr) return;
  const std::string pointer = root.pointerTo("textures");
  JsonFields fields(*value, pointer, root.report());
  for (const TextureSlotRow& row : textureSlots()) {
    const Json* texture = fields.find(row.id);
    if (texture == nullptr) continue;
    Json unknown =
        readTexture(*texture, pointerStep(pointer, row.id), folder, material.texture(row.slot), root.report());
    if (!unknown.empty()) material.unknownTextures[std::string(row.id)] = std::move(unknown);
  }
  append(material.unknownTextures, fields.unknown());
}

/// The neutral factor of a map.
ParameterValue one(const ParameterRow& row) {
  if (row.type == ParameterType::Colour) return Colour{glm::vec3(1.0F)};
  return 1.0F;
}

std::string joined(const std::vector<std::string_view>& ids) {
  std::string text;
  for (const std::string_view id : ids) text += (text.empty() ? "" : ", ") + std::string(id);
  return text;
}

/// Every row of the table is looked for; those of other shading models are kept too, so that switching loses nothing.
void readParameters(JsonFields& root, PresetPlace place, Material& material) {
  JsonReport& report = root.report();
  const Json* value = root.find("parameters");
  const std::string pointer = root.pointerTo("parameters");
  JsonFields fields(value != nullptr ? *value : emptyObject(), pointer, report);

  std::vector<std::string_view> defaulted;
  std::vector<std::string_view> neutral;
  for (const ParameterRow& row : parameterTable()) {
    const bool used = row.usedBy(material.model);
    const Json* json = fields.find(row.id);
    const std::string where = fields.pointerTo(row.id);
    if (json == nullptr) {
      // An untouched factor must not tint the map that it multiplies.
      const bool besideMap = row.map && material.texture(*row.map).present();
      if (besideMap) row.set(material.parameters, one(row));
      if (used) (besideMap ? neutral : defaulted).push_back(row.id);
      continue;
    }
    if (const auto read = readParameterValue(row, *json, where, report))
      row.set(material.parameters, clampWithWarning(row, *read, report.file + ": " + where, report.warnings));
    if (used) continue;
    material.unknownParameters[std::string(row.id)] = *json;
    report.warn(where, "is not used by the model " + std::string(shadingModelRow(material.model).id) + " and is kept");
  }
  append(material.unknownParameters, fields.unknown());

  if (place == PresetPlace::Inline) return;
  if (!defaulted.empty()) report.warn(pointer, "lacks " + joined(defaulted) + ", which take their defaults");
  if (!neutral.empty()) report.warn(pointer, "lacks " + joined(neutral) + ", which count as 1 beside their maps");
}

void readMetadata(JsonFields& root, Material& material) {
  const Json* value = root.find("metadata");
  if (value == nullptr) return;
  JsonFields fields(*value, root.pointerTo("metadata"), root.report());
  std::string text;
  for (const std::string_view key : {"author", "notes", "created_with"}) fields.read(key, text);
  if (value->is_object()) material.metadata = *value;
}

// ---- writing

Json parametersToJson(const Material& material) {
  Json json = Json::object();
  const auto write = [&](const ParameterRow& row) {
    json[std::string(row.id)] = parameterToJson(row, clampToHardRange(row, row.get(material.parameters)));
  };
  for (const ParameterRow& row : parameterTable())
    if (row.usedBy(material.model)) write(row);
  for (const auto& [id, value] : material.unknownParameters.items()) {
    const ParameterRow* row = findParameter(id);
    if (row == nullptr)
      appendMember(json, id, value);
    else if (!row->usedBy(material.model))
      write(*row);
  }
  return json;
}

Json textureToJson(const TextureBinding& binding, const fs::path& folder) {
  const TextureBinding plain;
  Json json = {{"path", relativeReference(binding.path, folder)}};
  if (binding.colorSpace) json["color_space"] = *binding.colorSpace;
  if (binding.channel != plain.channel) json["channel"] = std::string(toString(binding.channel));
  if (binding.invert != plain.invert) json["invert"] = binding.invert;
  if (binding.flipGreen != plain.flipGreen) json["flip_green"] = binding.flipGreen;
  if (binding.scale != plain.scale) json["scale"] = jsonNumber(binding.scale);
  if (binding.uvScale != plain.uvScale)
    json["uv_scale"] = Json::array({jsonNumber(binding.uvScale[0]), jsonNumber(binding.uvScale[1])});
  return json;
}

Json texturesToJson(const Material& material, const fs::path& folder) {
  Json json = Json::object();
  for (const TextureSlotRow& row : textureSlots()) {
    if (!material.texture(row.slot).present()) continue;
    Json texture = textureToJson(material.texture(row.slot), folder);
    if (const auto unknown = material.unknownTextures.find(row.id); unknown != material.unknownTextures.end())
      append(texture, *unknown);
    json[std::string(row.id)] = std::move(texture);
  }
  for (const auto& [id, value] : material.unknownTextures.items())
    if (!textureSlotFromId(id)) appendMember(json, id, value);
  return json;
}

}  // namespace

Material readMaterial(const Json& json, const std::string& pointer, PresetPlace place, const fs::path& folder,
                      JsonReport& report) {
  Material material;
  JsonFields root(json, pointer, report);
  checkFormat(root, kPresetFormat, kPresetVersion, place == PresetPlace::File);
  root.read("name", material.name);
  material.model = readModel(root, place);
  readTextures(root, folder, material);
  readParameters(root, place, material);
  readMetadata(root, material);
  material.unknown = root.unknown();
  return material;
}

Json materialToJson(const Material& material, const fs::path& folder) {
  Json json = {{"format", kPresetFormat}, {"version", kPresetVersion}};
  if (!material.name.empty()) json["name"] = material.name;
  json["model"] = std::string(shadingModelRow(material.model).id);
  json["parameters"] = parametersToJson(material);
  if (Json textures = texturesToJson(material, folder); !textures.empty()) json["textures"] = std::move(textures);
  if (!material.metadata.empty()) json["metadata"] = material.metadata;
  append(json, material.unknown);
  return json;
}

namespace {

/// A preset on its own also says who wrote it first.
Json presetToJson(const Material& material, const fs::path& folder) {
  Material complete = material;
  if (!complete.metadata.contains("created_with")) complete.metadata["created_with"] = "dermis " DERMIS_VERSION;
  return materialToJson(complete, folder);
}

}  // namespace

Result<Material> readPreset(std::string_view text, const std::string& name, const fs::path& folder,
                            Warnings& warnings) {
  const auto json = parseJson(text, name);
  if (!json) return tl::unexpected(json.error());
  Warnings found;
  JsonReport report{name, found};
  Material material = readMaterial(*json, "", PresetPlace::File, folder, report);
  if (report.error) return tl::unexpected(std::move(*report.error));
  warnings.insert(warnings.end(), found.begin(), found.end());
  return material;
}

Result<Material> loadPreset(const fs::path& path, Warnings& warnings) {
  if (const auto name = builtinName(path.native())) return loadBuiltinPreset(*name, warnings);
  const auto text = readFile(path, kMaxJsonBytes);
  if (!text) return tl::unexpected(text.error());
  return readPreset(*text, path.string(), fs::absolute(path).parent_path(), warnings);
}

std::string writePreset(const Material& material, const fs::path& presetFolder) {
  return writeJson(presetToJson(material, presetFolder));
}

Result<void> savePreset(const fs::path& path, const Material& material) {
  return saveJson(path, presetToJson(material, fs::absolute(path).parent_path()));
}

}  // namespace dermis
