#include "core/light_rig/rig_io.h"

#include <array>
#include <cmath>

#include "core/base/file_io.h"
#include "core/light_rig/rig_fields.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

constexpr Range kWhite{1e-6F, 1e9F};
constexpr Range kWidth{64.0F, 4096.0F};

// ---- reading

/// What the row's key says. An optional member becomes set by its key alone.
void readField(JsonFields& fields, const RigField& field, RigElement& element) {
  const auto readTo = [&](auto& target) {
    using Value = std::remove_cvref_t<decltype(target)>;
    if constexpr (std::is_same_v<Value, bool>)
      fields.read(field.key, target);
    else if constexpr (std::is_same_v<Value, glm::vec3>)
      fields.readColour(field.key, target, field.range);
    else
      fields.read(field.key, target, field.range);
  };
  const auto readOptional = [&]<class Value>(std::optional<Value>& target) {
    if (fields.find(field.key) == nullptr) return;
    Value value{};
    readTo(value);
    target = value;
  };
  std::visit(
      [&](auto member) {
        auto& target = element.*member;
        if constexpr (requires { target.has_value(); })
          readOptional(target);
        else
          readTo(target);
      },
      field.member);
}

/// Two keys of a group would leave open which of them counts.
void refuseTwoOfAGroup(JsonFields& fields, RigElementType type) {
  std::array<std::string_view, 4> first{};
  for (const RigField& field : rigFields()) {
    if (field.group == RigGroup::None || !field.usedBy(type) || fields.find(field.key) == nullptr) continue;
    std::string_view& before = first.at(static_cast<std::size_t>(field.group));
    if (!before.empty())
      fields.report().refuse(fields.pointerTo(field.key),
                             "says the same thing as " + std::string(before) + "; leave one of them out");
    before = field.key;
  }
}

RigElementType readType(JsonFields& fields) {
  std::vector<std::string_view> ids;
  for (const RigTypeRow& row : rigTypes()) ids.push_back(row.id);
  const std::string pointer = fields.pointerTo("type");
  const auto refuse = [&](const std::string& why) {
    fields.report().refuse(pointer, why);
    return RigElementType::Softbox;
  };
  const Json* value = fields.find("type");
  if (value == nullptr) return refuse("is missing; it must be " + listed(ids));
  if (!value->is_string()) return refuse("must be " + listed(ids) + ", not " + std::string(typeName(*value)));
  const auto& text = value->get_ref<const std::string&>();
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (ids[i] == text) return static_cast<RigElementType>(i);
  return refuse("must be " + listed(ids) + ", not " + inQuotes(text));
}

RigElement readElement(const Json& json, const std::string& pointer, JsonReport& report) {
  RigElement element;
  JsonFields fields(json, pointer, report);
  element.type = readType(fields);
  fields.read("name", element.name);
  fields.read("enabled", element.enabled);
  refuseTwoOfAGroup(fields, element.type);
  for (const RigField& field : rigFields())
    if (field.usedBy(element.type)) readField(fields, field, element);
  element.panes = glm::round(element.panes);
  const glm::vec3 centre = rigDirection(element.azimuthDegrees, element.elevationDegrees) * element.distanceM;
  if (!hasDirection(element.aimM - centre))
    report.refuse(fields.pointerTo("aim_m"), "is the element's own place; it must be a point that it can face");
  element.unknown = fields.unknown();
  return element;
}

void readElements(JsonFields& root, LightRig& rig) {
  JsonReport& report = root.report();
  const std::string pointer = root.pointerTo("elements");
  const Json* json = root.find("elements");
  if (json == nullptr) return report.refuse(pointer, "is missing; it holds the rig's lights");
  if (!json->is_array()) return report.refuse(pointer, "must be an array, not " + std::string(typeName(*json)));
  if (json->size() > kMaxRigElements)
    return report.refuse(pointer, "has " + std::to_string(json->size()) + " elements; at most " +
                                      std::to_string(kMaxRigElements) + " are possible");
  for (std::size_t i = 0; i < json->size(); ++i)
    rig.elements.push_back(readElement((*json)[i], pointerStep(pointer, i), report));
}

// ---- writing

Json toJson(bool value) { return value; }
Json toJson(float value) { return jsonNumber(value); }
template <glm::length_t N>
Json toJson(const glm::vec<N, float>& value) {
  Json array = Json::array();
  for (glm::length_t i = 0; i < N; ++i) array.push_back(jsonNumber(value[i]));
  return array;
}

/// Every member that the type uses; optional ones where they are set.
Json elementToJson(const RigElement& element) {
  Json json = {{"type", rigTypes()[static_cast<std::size_t>(element.type)].id}};
  if (!element.name.empty()) json["name"] = element.name;
  if (!element.enabled) json["enabled"] = false;
  for (const RigField& field : rigFields()) {
    if (!field.usedBy(element.type)) continue;
    std::visit(
        [&](auto member) {
          const auto& value = element.*member;
          if constexpr (requires { value.has_value(); }) {
            if (value) json[std::string(field.key)] = toJson(*value);
          } else {
            json[std::string(field.key)] = toJson(value);
          }
        },
        field.member);
  }
  for (const auto& [key, value] : element.unknown.items()) appendMember(json, key, value);
  return json;
}

}  // namespace

glm::vec3 rigDirection(float azimuthDegrees, float elevationDegrees) {
  const float a = glm::radians(azimuthDegrees);
  const float e = glm::radians(elevationDegrees);
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

LightRig readRig(const Json& json, const std::string& pointer, JsonReport& report) {
  LightRig rig;
  JsonFields root(json, pointer, report);
  checkFormat(root, kRigFormat, kRigVersion, true);
  root.read("name", rig.name);
  root.read("description", rig.description);
  root.read("white_luminance_cd_m2", rig.whiteLuminance, kWhite);
  auto width = static_cast<float>(rig.width);
  root.read("width", width, kWidth);
  // Even, so that the horizon lies between two rows.
  rig.width = 4 * static_cast<int>(std::lround(width / 4.0F));
  readElements(root, rig);
  if (const Json* metadata = root.find("metadata"); metadata != nullptr) {
    if (metadata->is_object())
      rig.metadata = *metadata;
    else
      report.refuse(root.pointerTo("metadata"), "must be an object, not " + std::string(typeName(*metadata)));
  }
  rig.unknown = root.unknown();
  return rig;
}

Result<LightRig> readRig(std::string_view text, const std::string& name, Warnings& warnings) {
  const auto json = parseJson(text, name);
  if (!json) return tl::unexpected(json.error());
  Warnings found;
  JsonReport report{name, found};
  LightRig rig = readRig(*json, "", report);
  if (report.error) return tl::unexpected(std::move(*report.error));
  warnings.insert(warnings.end(), found.begin(), found.end());
  return rig;
}

Result<LightRig> loadRig(const fs::path& path, Warnings& warnings) {
  const auto text = readFile(path, kMaxJsonBytes);
  if (!text) return tl::unexpected(text.error());
  return readRig(*text, path.string(), warnings);
}

bool isRigFile(const fs::path& path) {
  const auto text = readFile(path, kMaxJsonBytes);
  if (!text) return false;
  const auto json = parseJson(*text, path.string());
  return json && json->is_object() && json->value("format", Json()) == Json(kRigFormat);
}

Json rigToJson(const LightRig& rig) {
  Json json = {{"format", kRigFormat}, {"version", kRigVersion}};
  if (!rig.name.empty()) json["name"] = rig.name;
  if (!rig.description.empty()) json["description"] = rig.description;
  json["white_luminance_cd_m2"] = jsonNumber(rig.whiteLuminance);
  json["width"] = rig.width;
  json["elements"] = Json::array();
  for (const RigElement& element : rig.elements) json["elements"].push_back(elementToJson(element));
  if (!rig.metadata.empty()) json["metadata"] = rig.metadata;
  for (const auto& [key, value] : rig.unknown.items()) appendMember(json, key, value);
  return json;
}

std::string writeRig(const LightRig& rig) { return writeJson(rigToJson(rig)); }

Result<void> saveRig(const fs::path& path, const LightRig& rig) { return saveJson(path, rigToJson(rig)); }

}  // namespace dermis
