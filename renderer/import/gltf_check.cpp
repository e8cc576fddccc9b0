#include "import/gltf_check.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/lower_case.h"
#include "import/gltf_data.h"
#include "import/text.h"

namespace dermis::import {
namespace {

using json = nlohmann::json;

constexpr std::uint32_t kGlbMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

void putWord(std::string& out, std::uint32_t value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

struct Chunks {
  std::string_view json;
  std::string_view binary;
  bool isGlb = false;
};

/// GLB container (glTF 2.0, chapter 4).
Chunks split(std::string_view bytes) {
  Chunks chunks{bytes, {}, false};
  if (bytes.size() < 4 || word(bytes, 0) != kGlbMagic) return chunks;
  chunks.isGlb = true;
  if (bytes.size() < 20) throw GltfError("the GLB header is cut off");
  if (word(bytes, 4) != 2)
    throw GltfError(fmt::format("the GLB container has version {}, and only 2 can be read", word(bytes, 4)));
  if (word(bytes, 8) > bytes.size())
    throw GltfError(
        fmt::format("the GLB header promises {} bytes, but the file holds only {}", word(bytes, 8), bytes.size()));
  const std::size_t jsonBytes = word(bytes, 12);
  if (word(bytes, 16) != kJsonChunk || jsonBytes > bytes.size() - 20)
    throw GltfError("the GLB file's JSON chunk is cut off or missing");
  chunks.json = bytes.substr(20, jsonBytes);
  const std::size_t next = 20 + ((jsonBytes + 3) & ~std::size_t{3});
  if (next + 8 > bytes.size()) return chunks;
  const std::size_t binaryBytes = word(bytes, next);
  if (word(bytes, next + 4) != kBinaryChunk) return chunks;
  if (binaryBytes > bytes.size() - next - 8)
    throw GltfError(fmt::format("the GLB file's binary chunk promises {} bytes, but only {} follow", binaryBytes,
                                bytes.size() - next - 8));
  chunks.binary = bytes.substr(next + 8, binaryBytes);
  return chunks;
}

std::string joinGlb(const json& root, std::string_view binary) {
  std::string text = root.dump(-1, ' ', false, json::error_handler_t::replace);
  while (text.size() % 4 != 0) text += ' ';
  const std::size_t padding = (4 - binary.size() % 4) % 4;
  const std::size_t total = 12 + 8 + text.size() + (binary.empty() ? 0 : 8 + binary.size() + padding);
  std::string out;
  out.reserve(total);
  for (const auto value :
       {kGlbMagic, 2U, static_cast<std::uint32_t>(total), static_cast<std::uint32_t>(text.size()), kJsonChunk})
    putWord(out, value);
  out += text;
  if (binary.empty()) return out;
  putWord(out, static_cast<std::uint32_t>(binary.size() + padding));
  putWord(out, kBinaryChunk);
  out += binary;
  out.append(padding, '\0');
  return out;
}

/// Parses, refusing keys that come twice: two parsers would see two different files.
json parseJson(std::string_view text) {
  std::vector<std::set<std::string>> keys;
  const auto watch = [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw GltfError(
          fmt::format("its JSON has the key \"{}\" twice in one object", phrase(parsed.get<std::string>(), 40)));
    return true;
  };
  while (!text.empty() && text.back() == '\0') text.remove_suffix(1);
  try {
    return json::parse(text, watch);
  } catch (const json::parse_error& error) {
    throw GltfError(fmt::format("its JSON is damaged at byte {}", error.byte));
  }
}

/// Builds the rewritten document from the given one.
class Rewriter {
 public:
  Rewriter(const json& in, GltfData& data) : m_in(in), m_data(data) {}

  json run() {
    checkVersion();
    m_out["asset"] = {{"version", "2.0"}};
    m_out["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_transmission",
                               "KHR_materials_pbrSpecularGlossiness"};
    images();
    materials();
    meshes();
    skins();
    nodes();
    scenes();
    m_data.writeTo(m_out);
    return std::move(m_out);
  }

 private:
  void checkVersion() {
    const json& asset = member(m_in, "asset", "");
    const std::string version = asset.is_object() && asset.contains("version") && asset["version"].is_string()
                                    ? asset["version"].get<std::string>()
                                    : "";
    if (!version.starts_with("2."))
      throw GltfError(version.empty() ? "it has no /asset/version, so it isn't glTF"
                                      : fmt::format("it is glTF {}, and only 2.0 can be read", phrase(version, 20)));
    static const std::set<std::string> kKnown = {
        "KHR_texture_transform",    "KHR_materials_transmission", "KHR_materials_pbrSpecularGlossiness",
        "KHR_mesh_quantization",    "KHR_materials_ior",          "KHR_materials_emissive_strength",
        "KHR_materials_unlit",      "KHR_materials_clearcoat",    "KHR_materials_sheen",
        "KHR_materials_specular",   "KHR_materials_volume",       "KHR_materials_iridescence",
        "KHR_materials_anisotropy", "KHR_materials_variants",     "KHR_lights_punctual",
        "EXT_texture_webp"};
    for (const json& required : list(m_in, "extensionsRequired", ""))
      if (required.is_string() && kKnown.count(required.get<std::string>()) == 0)
        throw GltfError(fmt::format("it requires {}, which cannot be read; export it without",
                                    phrase(required.get<std::string>(), 60)));
  }

  void images() {
    for (const auto& [i, image] : enumerate(m_in, "images")) {
      json out = json::object();
      copyText(image, out, "mimeType");
      copyText(image, out, "name");
      const std::string uri = image.contains("uri") && image["uri"].is_string() ? image["uri"].get<std::string>() : "";
      if (uri.starts_with("data:")) {
        out["bufferView"] = m_data.addView(decodeDataUri(uri));
        if (!out.contains("mimeType")) out["mimeType"] = uri.substr(5, uri.find_first_of(";,") - 5);
      } else if (!uri.empty()) {
        out["uri"] = uri;
      } else if (image.contains("bufferView"))
        out["bufferView"] = m_data.keepView(index(image, "bufferView", "bufferViews", fmt::format("/images/{}", i)));
      m_out["images"].push_back(out);
    }
    for (const auto& [i, texture] : enumerate(m_in, "textures")) {
      const std::string at = fmt::format("/textures/{}", i);
      json out = json::object();
      if (texture.contains("source")) out["source"] = index(texture, "source", "images", at);
      const json& extensions = objectOrEmpty(texture, "extensions");
      if (!out.contains("source") && objectOrEmpty(extensions, "EXT_texture_webp").contains("source"))
        out["source"] = index(extensions["EXT_texture_webp"], "source", "images", at);
      m_out["textures"].push_back(out);
    }
  }

  /// A reference to a texture, with the numbers that go with it.
  void copyTexture(const json& from, json& to, const char* key, const std::string& at, const char* factor = nullptr) {
    if (!from.contains(key)) return;
    const json& info = member(from, key, at);
    if (!info.is_object()) throw GltfError(fmt::format("{}/{} is not an object", at, key));
    json out = {{"index", index(info, "index", "textures", at + "/" + key)}};
    if (info.contains("texCoord")) out["texCoord"] = count(info, "texCoord", at + "/" + key, 7);
    if (factor != nullptr) copyNumber(info, out, factor, at);
    const json& transform = objectOrEmpty(objectOrEmpty(info, "extensions"), "KHR_texture_transform");
    if (!transform.empty()) {
      json copy = json::object();
      copyNumbers(transform, copy, "offset", 2, at);
      copyNumbers(transform, copy, "scale", 2, at);
      copyNumber(transform, copy, "rotation", at);
      out["extensions"]["KHR_texture_transform"] = copy;
    }
    to[key] = out;
  }

  void materials() {
    for (const auto& [i, material] : enumerate(m_in, "materials")) {
      const std::string at = fmt::format("/materials/{}", i);
      json out = json::object();
      copyText(material, out, "name");
      copyText(material, out, "alphaMode");
      copyNumber(material, out, "alphaCutoff", at);
      if (material.contains("doubleSided") && material["doubleSided"].is_boolean())
        out["doubleSided"] = material["doubleSided"];
      const json& pbr = objectOrEmpty(material, "pbrMetallicRoughness");
      json pbrOut = json::object();
      copyNumbers(pbr, pbrOut, "baseColorFactor", 4, at);
      copyNumber(pbr, pbrOut, "metallicFactor", at);
      copyNumber(pbr, pbrOut, "roughnessFactor", at);
      copyTexture(pbr, pbrOut, "baseColorTexture", at);
      copyTexture(pbr, pbrOut, "metallicRoughnessTexture", at);
      out["pbrMetallicRoughness"] = pbrOut;
      copyTexture(material, out, "normalTexture", at, "scale");
      copyTexture(material, out, "occlusionTexture", at, "strength");
      copyTexture(material, out, "emissiveTexture", at);
      copyNumbers(material, out, "emissiveFactor", 3, at);
      materialExtensions(objectOrEmpty(material, "extensions"), out, at);
      m_out["materials"].push_back(out);
    }
  }

  void materialExtensions(const json& extensions, json& out, const std::string& at) {
    // Strength goes into the factor: this Assimp doesn't know the extension, and our loader takes it apart again.
    json strength = json::object();
    copyNumber(objectOrEmpty(extensions, "KHR_materials_emissive_strength"), strength, "emissiveStrength", at);
    if (strength.contains("emissiveStrength") && out.contains("emissiveFactor"))
      for (json& value : out["emissiveFactor"])
        value = value.get<double>() * strength["emissiveStrength"].get<double>();
    json transmission = json::object();
    copyNumber(objectOrEmpty(extensions, "KHR_materials_transmission"), transmission, "transmissionFactor", at);
    if (!transmission.empty()) out["extensions"]["KHR_materials_transmission"] = transmission;
    const json& glossy = objectOrEmpty(extensions, "KHR_materials_pbrSpecularGlossiness");
    if (glossy.empty()) return;
    json copy = json::object();
    copyNumbers(glossy, copy, "diffuseFactor", 4, at);
    copyNumbers(glossy, copy, "specularFactor", 3, at);
    copyNumber(glossy, copy, "glossinessFactor", at);
    copyTexture(glossy, copy, "diffuseTexture", at);
    out["extensions"]["KHR_materials_pbrSpecularGlossiness"] = copy;
  }

  void meshes() {
    for (const auto& [i, mesh] : enumerate(m_in, "meshes")) {
      json out = json::object();
      copyText(mesh, out, "name");
      out["primitives"] = json::array();
      std::size_t p = 0;
      for (const json& primitive : list(mesh, "primitives", fmt::format("/meshes/{}", i)))
        out["primitives"].push_back(primitiveOf(primitive, fmt::format("/meshes/{}/primitives/{}", i, p++)));
      m_out["meshes"].push_back(out);
    }
  }

  json primitiveOf(const json& primitive, const std::string& at) {
    if (!primitive.is_object()) throw GltfError(at + " is not an object");
    if (objectOrEmpty(primitive, "extensions").contains("KHR_draco_mesh_compression"))
      throw GltfError("its mesh is compressed with Draco, which cannot be read; export it without compression");
    const json& attributes = objectOrEmpty(primitive, "attributes");
    json out = json::object();
    out["attributes"] = json::object();
    out["mode"] = primitive.contains("mode") ? count(primitive, "mode", at, 6) : 4;
    std::size_t vertices = 0;
    for (const char* name : {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0", "JOINTS_0", "WEIGHTS_0"}) {
      if (!attributes.contains(name)) continue;
      const std::size_t accessor = index(attributes, name, "accessors", at + "/attributes");
      const std::size_t length = m_data.accessorCount(accessor);
      if (std::strcmp(name, "POSITION") == 0) vertices = length;
      if (length != vertices)
        throw GltfError(fmt::format("{}/attributes/{} has {} elements for {} vertices", at, name, length, vertices));
      out["attributes"][name] = m_data.keepAttribute(accessor, name);
    }
    if (out["attributes"].contains("JOINTS_0") != out["attributes"].contains("WEIGHTS_0")) {
      out["attributes"].erase("JOINTS_0");
      out["attributes"].erase("WEIGHTS_0");
    }
    if (primitive.contains("indices"))
      out["indices"] = m_data.keepIndices(index(primitive, "indices", "accessors", at), vertices, at);
    if (primitive.contains("material")) out["material"] = index(primitive, "material", "materials", at);
    return out;
  }

  void skins() {
    for (const auto& [i, skin] : enumerate(m_in, "skins")) {
      const std::string at = fmt::format("/skins/{}", i);
      json out = {{"joints", json::array()}};
      const json& joints = list(skin, "joints", at);
      for (const json& joint : joints) out["joints"].push_back(asIndex(joint, "nodes", at + "/joints"));
      if (joints.empty()) throw GltfError(at + " has no joints");
      if (skin.contains("inverseBindMatrices")) {
        const std::size_t accessor = index(skin, "inverseBindMatrices", "accessors", at);
        if (m_data.accessorCount(accessor) < joints.size())
          throw GltfError(at + " has fewer inverse bind matrices than joints");
        out["inverseBindMatrices"] = m_data.keepMatrices(accessor);
      }
      m_out["skins"].push_back(out);
    }
  }

  void nodes() {
    std::vector<int> parents(list(m_in, "nodes", "").size(), -1);
    for (const auto& [i, node] : enumerate(m_in, "nodes")) {
      const std::string at = fmt::format("/nodes/{}", i);
      json out = json::object();
      // Names tell joints apart, so they are made unique.
      out["name"] = fmt::format("node {}", i);
      copyNumbers(node, out, "matrix", 16, at);
      copyNumbers(node, out, "translation", 3, at);
      copyNumbers(node, out, "rotation", 4, at);
      copyNumbers(node, out, "scale", 3, at);
      if (node.contains("mesh")) out["mesh"] = index(node, "mesh", "meshes", at);
      if (node.contains("skin") && node.contains("mesh")) skinOf(node, out, at);
      for (const json& child : list(node, "children", at)) {
        const std::size_t c = asIndex(child, "nodes", at + "/children");
        if (parents[c] >= 0 || c == i) throw GltfError(fmt::format("/nodes/{} has two parents", c));
        parents[c] = static_cast<int>(i);
        out["children"].push_back(c);
      }
      m_out["nodes"].push_back(out);
    }
    // With one parent each, a cycle is a chain that comes back.
    for (std::size_t i = 0; i < parents.size(); ++i) {
      std::size_t depth = 0;
      for (int at = parents[i]; at >= 0; at = parents[static_cast<std::size_t>(at)])
        if (++depth > kDeepestTree)
          throw GltfError(fmt::format("/nodes/{} lies in a cycle or more than {} levels deep", i, kDeepestTree));
    }
  }

  void skinOf(const json& node, json& out, const std::string& at) {
    const std::size_t skin = index(node, "skin", "skins", at);
    const std::size_t joints = m_out["skins"][skin]["joints"].size();
    for (const json& primitive : m_out["meshes"][out["mesh"].get<std::size_t>()]["primitives"])
      if (primitive["attributes"].contains("JOINTS_0"))
        m_data.checkJoints(primitive["attributes"]["JOINTS_0"].get<std::size_t>(), joints, at);
    out["skin"] = skin;
  }

  void scenes() {
    const json& scenes = list(m_in, "scenes", "");
    const std::size_t chosen = m_in.contains("scene") ? index(m_in, "scene", "scenes", "") : 0;
    json roots = json::array();
    if (!scenes.empty()) {
      std::set<std::size_t> seen;
      for (const json& root : list(scenes[chosen], "nodes", fmt::format("/scenes/{}", chosen)))
        if (const std::size_t node = asIndex(root, "nodes", fmt::format("/scenes/{}/nodes", chosen));
            seen.insert(node).second)
          roots.push_back(node);
    } else {
      std::set<std::size_t> children;
      for (const json& node : m_out.value("nodes", json::array()))
        for (const json& child : node.value("children", json::array())) children.insert(child.get<std::size_t>());
      for (std::size_t i = 0; i < m_out.value("nodes", json::array()).size(); ++i)
        if (children.count(i) == 0) roots.push_back(i);
    }
    m_out["scene"] = 0;
    m_out["scenes"] = json::array({{{"nodes", roots}}});
  }

  // Reading with checks.

  static const json& member(const json& object, const char* key, const std::string& at) {
    if (!object.is_object() || !object.contains(key)) throw GltfError(fmt::format("{}/{} is missing", at, key));
    return object[key];
  }
  static const json& objectOrEmpty(const json& object, const char* key) {
    static const json kEmpty = json::object();
    return object.is_object() && object.contains(key) && object[key].is_object() ? object[key] : kEmpty;
  }
  static const json& list(const json& object, const char* key, const std::string& at) {
    static const json kEmpty = json::array();
    if (!object.is_object() || !object.contains(key)) return kEmpty;
    if (!object[key].is_array()) throw GltfError(fmt::format("{}/{} is not an array", at, key));
    return object[key];
  }
  static std::vector<std::pair<std::size_t, const json&>> enumerate(const json& object, const char* key) {
    std::vector<std::pair<std::size_t, const json&>> out;
    for (const json& element : list(object, key, "")) {
      if (!element.is_object()) throw GltfError(fmt::format("/{}/{} is not an object", key, out.size()));
      out.emplace_back(out.size(), element);
    }
    return out;
  }
  std::size_t asIndex(const json& value, const char* what, const std::string& at) const {
    const std::size_t size = list(m_in, what, "").size();
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= size)
      throw GltfError(fmt::format("{} refers to {} {}, but there are {}", at, what,
                                  phrase(value.dump(-1, ' ', true, json::error_handler_t::replace), 30), size));
    return value.get<std::size_t>();
  }
  std::size_t index(const json& object, const char* key, const char* what, const std::string& at) const {
    return asIndex(member(object, key, at), what, at + "/" + key);
  }
  static std::size_t count(const json& object, const char* key, const std::string& at, std::size_t most) {
    const json& value = member(object, key, at);
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most)
      throw GltfError(fmt::format("{}/{} is not a whole number up to {}", at, key, most));
    return value.get<std::size_t>();
  }
  static void copyText(const json& from, json& to, const char* key) {
    if (from.contains(key) && from[key].is_string()) to[key] = from[key];
  }
  static double finiteNumber(const json& value, const std::string& at) {
    if (!value.is_number() || !(std::abs(value.get<double>()) < 1e30)) throw GltfError(at + " is not a usable number");
    return value.get<double>();
  }
  static void copyNumber(const json& from, json& to, const char* key, const std::string& at) {
    if (from.contains(key)) to[key] = finiteNumber(from[key], at + "/" + key);
  }
  static void copyNumbers(const json& from, json& to, const char* key, std::size_t length, const std::string& at) {
    if (!from.contains(key)) return;
    const json& values = from[key];
    if (!values.is_array() || values.size() != length)
      throw GltfError(fmt::format("{}/{} is not an array of {} numbers", at, key, length));
    json copy = json::array();
    for (const json& value : values) copy.push_back(finiteNumber(value, at + "/" + key));
    to[key] = copy;
  }

  static constexpr std::size_t kDeepestTree = 512;
  const json& m_in;
  json m_out = json::object();
  GltfData& m_data;
};

}  // namespace

Result<std::string> checkedGltf(std::string_view bytes, const std::filesystem::path& path) try {
  const Chunks chunks = split(bytes);
  if (!chunks.isGlb && lowerCase(path.extension().string()) != ".gltf")
    throw GltfError("it does not begin as a GLB file does");
  const json in = parseJson(chunks.json);
  if (!in.is_object()) throw GltfError("its JSON is not an object");
  GltfData data(in, chunks.binary, path);
  const json out = Rewriter(in, data).run();
  return joinGlb(out, data.binary());
} catch (const GltfError& error) {
  return inputError(fmt::format("{}: not usable glTF: {}", path.filename().string(), error.what()));
}

}  // namespace dermis::import
