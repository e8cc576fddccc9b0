#include "import/gltf_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/file_io.h"
#include "import/model_io.h"
#include "import/text.h"

namespace dermis::import {
namespace {

using json = nlohmann::json;

enum Component { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt = 5125, kFloat };

constexpr std::size_t kMostElements = 300'000'000;
constexpr std::size_t kMostElementsFromNothing = 10'000'000;  // sparse over zeros: costs no bytes in the file
constexpr std::size_t kLargestOutput = 0xF0000000;

std::size_t componentBytes(int type) {
  switch (type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

template <class T>
T load(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));
  return value;
}

/// One component as a number; integers scaled where the accessor says `normalized` (glTF 2.0, §3.6.2.2).
double component(const char* at, int type, bool normalized) {
  switch (type) {
    case kByte:
      return normalized ? std::max(load<std::int8_t>(at) / 127.0, -1.0) : load<std::int8_t>(at);
    case kUnsignedByte:
      return load<std::uint8_t>(at) / (normalized ? 255.0 : 1.0);
    case kShort:
      return normalized ? std::max(load<std::int16_t>(at) / 32767.0, -1.0) : load<std::int16_t>(at);
    case kUnsignedShort:
      return load<std::uint16_t>(at) / (normalized ? 65535.0 : 1.0);
    case kUnsignedInt:
      return load<std::uint32_t>(at);
    default:
      return static_cast<double>(load<float>(at));
  }
}

/// A whole number of an object; `otherwise` where the key is absent.
std::size_t whole(const json& object, const char* key, const std::string& at, std::size_t otherwise) {
  if (!object.contains(key)) return otherwise;
  const json& value = object[key];
  if (!value.is_number_unsigned()) throw GltfError(fmt::format("{}/{} is not a whole number", at, key));
  return static_cast<std::size_t>(value.get<std::uint64_t>());
}

const json& element(const json& document, const char* array, std::size_t index) {
  static const json kNone;
  const json& list = document.contains(array) ? document[array] : kNone;
  if (!list.is_array() || index >= list.size() || !list[index].is_object())
    throw GltfError(fmt::format("/{}/{} is not there", array, index));
  return list[index];
}

constexpr std::array<std::pair<const char*, std::size_t>, 7> kTypes = {
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};

}  // namespace

std::string decodeDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || uri.substr(0, comma).find(";base64") == std::string_view::npos)
    throw GltfError("a data URI is not base64");
  std::string out;
  out.reserve((uri.size() - comma) / 4 * 3);
  unsigned bits = 0;
  int held = 0;
  for (const char c : uri.substr(comma + 1)) {
    if (c == '=') break;
    const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+' || c == '-' ? 62
                      : c == '/' || c == '_' ? 63
                                             : -1;
    if (value < 0) throw GltfError("a data URI holds characters that are not base64");
    bits = (bits << 6U) | static_cast<unsigned>(value);
    held += 6;
    if (held >= 8) {
      held -= 8;
      out += static_cast<char>((bits >> static_cast<unsigned>(held)) & 0xFFU);
    }
  }
  return out;
}

GltfData::GltfData(const json& document, std::string_view glbBinary, const std::filesystem::path& path)
    : m_in(document) {
  readBuffers(glbBinary, path);
}

void GltfData::readBuffers(std::string_view glbBinary, const std::filesystem::path& path) {
  if (!m_in.contains("buffers")) return;
  if (!m_in["buffers"].is_array()) throw GltfError("/buffers is not an array");
  const ModelFolder folder(path);
  m_owned.reserve(m_in["buffers"].size());
  for (std::size_t i = 0; i < m_in["buffers"].size(); ++i) {
    const json& buffer = element(m_in, "buffers", i);
    const std::string at = fmt::format("/buffers/{}", i);
    std::string_view bytes = glbBinary;
    if (buffer.contains("uri")) {
      if (!buffer["uri"].is_string()) throw GltfError(at + "/uri is not a text");
      const auto& uri = buffer["uri"].get_ref<const std::string&>();
      if (uri.starts_with("data:")) {
        m_owned.push_back(decodeDataUri(uri));
      } else {
        const std::filesystem::path file = folder.find(uri);
        if (file.empty()) throw GltfError(fmt::format("its data file \"{}\" is not beside it", phrase(uri, 80)));
        auto read = readFile(file, kLargestModelBytes);
        if (!read) throw GltfError(phrase(read.error().message, 300));
        m_owned.push_back(std::move(*read));
      }
      bytes = m_owned.back();
    } else if (i != 0) {
      throw GltfError(at + " has no data");
    }
    const std::size_t promised = whole(buffer, "byteLength", at, 0);
    if (promised > bytes.size())
      throw GltfError(fmt::format("{} promises {} bytes, but there are only {}", at, promised, bytes.size()));
    m_buffers.push_back(bytes.substr(0, promised));
  }
}

std::string_view GltfData::view(std::size_t index) const {
  const json& view = element(m_in, "bufferViews", index);
  const std::string at = fmt::format("/bufferViews/{}", index);
  if (view.contains("extensions") && view["extensions"].is_object() &&
      view["extensions"].contains("EXT_meshopt_compression"))
    throw GltfError("its mesh is compressed with meshopt, which cannot be read; export it without compression");
  const std::size_t buffer = whole(view, "buffer", at, m_buffers.size());
  if (buffer >= m_buffers.size()) throw GltfError(fmt::format("{}/buffer refers to a buffer that is not there", at));
  const std::size_t offset = whole(view, "byteOffset", at, 0);
  const std::size_t length = whole(view, "byteLength", at, 0);
  const std::string_view bytes = m_buffers[buffer];
  if (offset > bytes.size() || length > bytes.size() - offset)
    throw GltfError(
        fmt::format("{} reaches to byte {}, but its buffer holds only {}", at, offset + length, bytes.size()));
  return bytes.substr(offset, length);
}

GltfData::Accessor GltfData::describe(std::size_t index) const {
  const json& in = element(m_in, "accessors", index);
  const std::string at = fmt::format("/accessors/{}", index);
  Accessor out;
  out.count = whole(in, "count", at, 0);
  out.componentType = static_cast<int>(std::min<std::size_t>(whole(in, "componentType", at, 0), 10000));
  out.normalized = in.contains("normalized") && in["normalized"] == true;
  for (const auto& [name, components] : kTypes)
    if (in.contains("type") && in["type"] == name) out.components = components;
  if (out.components == 0 || componentBytes(out.componentType) == 0) throw GltfError(at + " has an unknown type");
  if (out.count > (in.contains("bufferView") ? kMostElements : kMostElementsFromNothing))
    throw GltfError(fmt::format("{} promises {} elements, past the limit", at, out.count));
  return out;
}

std::size_t GltfData::accessorCount(std::size_t accessor) const { return describe(accessor).count; }

std::vector<double> GltfData::values(std::size_t index) const {
  const Accessor accessor = describe(index);
  const json& in = element(m_in, "accessors", index);
  const std::string at = fmt::format("/accessors/{}", index);
  const std::size_t bytes = componentBytes(accessor.componentType);
  const std::size_t elementBytes = bytes * accessor.components;

  std::vector<double> out;
  if (in.contains("bufferView") && accessor.count > 0) {
    const std::size_t viewIndex = whole(in, "bufferView", at, 0);
    const std::string_view source = view(viewIndex);
    const std::size_t stride = whole(element(m_in, "bufferViews", viewIndex), "byteStride",
                                     fmt::format("/bufferViews/{}", viewIndex), elementBytes);
    const std::size_t offset = whole(in, "byteOffset", at, 0);
    if (stride < elementBytes || stride > 4096)
      throw GltfError(fmt::format("/bufferViews/{}/byteStride does not fit {}", viewIndex, at));
    // count and stride are bounded, so this doesn't overflow.
    if (offset > source.size() || stride * (accessor.count - 1) + elementBytes > source.size() - offset)
      throw GltfError(fmt::format("{} needs {} bytes, but its buffer view holds only {}", at,
                                  offset + stride * (accessor.count - 1) + elementBytes, source.size()));
    out.resize(accessor.count * accessor.components);
    for (std::size_t i = 0; i < accessor.count; ++i)
      for (std::size_t c = 0; c < accessor.components; ++c)
        out[i * accessor.components + c] =
            component(source.data() + offset + i * stride + c * bytes, accessor.componentType, accessor.normalized);
  } else {
    out.assign(accessor.count * accessor.components, 0.0);
  }
  if (in.contains("sparse")) applySparse(in["sparse"], accessor, out, at + "/sparse");
  return out;
}

void GltfData::applySparse(const json& sparse, const Accessor& accessor, std::vector<double>& values,
                           const std::string& at) const {
  if (!sparse.is_object() || !sparse.contains("indices") || !sparse["indices"].is_object() ||
      !sparse.contains("values") || !sparse["values"].is_object())
    throw GltfError(at + " is incomplete");
  const std::size_t count = whole(sparse, "count", at, 0);
  const std::size_t bytes = componentBytes(accessor.componentType);
  const auto slice = [&](const char* key, std::size_t elementBytes) {
    const json& part = sparse[key];
    const std::string_view source = view(whole(part, "bufferView", at, kMostElements));
    const std::size_t offset = whole(part, "byteOffset", at, 0);
    if (count > accessor.count || offset > source.size() || count * elementBytes > source.size() - offset)
      throw GltfError(fmt::format("{}/{} reaches past its buffer view", at, key));
    return source.substr(offset, count * elementBytes);
  };
  const auto indexType =
      static_cast<int>(std::min<std::size_t>(whole(sparse["indices"], "componentType", at, 0), 10000));
  const std::size_t indexBytes = componentBytes(indexType);
  if (indexBytes == 0 || indexType == kFloat) throw GltfError(at + "/indices has an unknown type");
  const std::string_view indices = slice("indices", indexBytes);
  const std::string_view overlay = slice("values", bytes * accessor.components);
  for (std::size_t i = 0; i < count; ++i) {
    const double index = component(indices.data() + i * indexBytes, indexType, false);
    if (!(index >= 0.0 && index < static_cast<double>(accessor.count)))
      throw GltfError(at + "/indices refers past the accessor");
    for (std::size_t c = 0; c < accessor.components; ++c)
      values[static_cast<std::size_t>(index) * accessor.components + c] = component(
          overlay.data() + (i * accessor.components + c) * bytes, accessor.componentType, accessor.normalized);
  }
}

template <class T>
std::size_t GltfData::addAccessor(const std::vector<T>& values, int componentType, const char* type,
                                  std::size_t components) {
  const std::size_t view = addView({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  m_accessors.push_back(
      {{"bufferView", view}, {"componentType", componentType}, {"count", values.size() / components}, {"type", type}});
  return m_accessors.size() - 1;
}

std::size_t GltfData::addView(std::string_view bytes) {
  if (bytes.size() > kLargestOutput - m_out.size()) throw GltfError("it holds more data than fits into 4 GB");
  m_views.push_back({{"buffer", 0}, {"byteOffset", m_out.size()}, {"byteLength", bytes.size()}});
  m_out += bytes;
  m_out.append((4 - m_out.size() % 4) % 4, '\0');
  return m_views.size() - 1;
}

std::size_t GltfData::keepView(std::size_t index) {
  const auto [entry, isNew] = m_kept.try_emplace(fmt::format("view {}", index), 0);
  if (isNew) entry->second = addView(view(index));
  return entry->second;
}

std::size_t GltfData::keepAttribute(std::size_t accessor, const std::string& name) {
  const bool joints = name == "JOINTS_0";
  const std::size_t components = name == "POSITION" || name == "NORMAL" ? 3 : name == "TEXCOORD_0" ? 2 : 4;
  if (describe(accessor).components != components)
    throw GltfError(fmt::format("/accessors/{} has the wrong type for {}", accessor, name));
  const auto [entry, isNew] = m_kept.try_emplace(fmt::format("{} {}", joints ? "joints" : "floats", accessor), 0);
  if (!isNew) return entry->second;
  const char* type = components == 2 ? "VEC2" : components == 3 ? "VEC3" : "VEC4";
  const std::vector<double> source = values(accessor);
  if (joints) {
    std::vector<std::uint16_t> out;
    out.reserve(source.size());
    for (const double value : source) out.push_back(static_cast<std::uint16_t>(std::clamp(value, 0.0, 65535.0)));
    return entry->second = addAccessor(out, kUnsignedShort, type, components);
  }
  std::vector<float> out;
  out.reserve(source.size());
  for (const double value : source) out.push_back(static_cast<float>(value));
  return entry->second = addAccessor(out, kFloat, type, components);
}

std::size_t GltfData::keepIndices(std::size_t accessor, std::size_t vertices, const std::string& at) {
  const Accessor shape = describe(accessor);
  if (shape.components != 1 || shape.componentType == kFloat || shape.componentType == kByte ||
      shape.componentType == kShort)
    throw GltfError(fmt::format("/accessors/{} has the wrong type for indices", accessor));
  const auto [entry, isNew] = m_kept.try_emplace(fmt::format("indices {}", accessor), 0);
  if (isNew) {
    std::vector<std::uint32_t> out;
    std::uint32_t largest = 0;
    for (const double value : values(accessor)) {
      out.push_back(static_cast<std::uint32_t>(value));
      largest = std::max(largest, out.back());
    }
    entry->second = addAccessor(out, kUnsignedInt, "SCALAR", 1);
    m_largestIndex[entry->second] = largest;
  }
  if (shape.count > 0 && m_largestIndex[entry->second] >= vertices)
    throw GltfError(
        fmt::format("{}/indices refers to vertex {}, but there are {}", at, m_largestIndex[entry->second], vertices));
  return entry->second;
}

std::size_t GltfData::keepMatrices(std::size_t accessor) {
  if (describe(accessor).components != 16)
    throw GltfError(fmt::format("/accessors/{} holds no 4 x 4 matrices", accessor));
  std::vector<float> out;
  for (const double value : values(accessor)) out.push_back(static_cast<float>(value));
  return addAccessor(out, kFloat, "MAT4", 16);
}

void GltfData::checkJoints(std::size_t kept, std::size_t joints, const std::string& at) const {
  const json& view = m_views[m_accessors[kept]["bufferView"].get<std::size_t>()];
  const char* data = m_out.data() + view["byteOffset"].get<std::size_t>();
  for (std::size_t i = 0; i < view["byteLength"].get<std::size_t>() / 2; ++i)
    if (load<std::uint16_t>(data + i * 2) >= joints)
      throw GltfError(fmt::format("{}: its mesh refers to joint {}, but the skin has {}", at,
                                  load<std::uint16_t>(data + i * 2), joints));
}

void GltfData::writeTo(json& document) const {
  if (m_out.empty()) return;
  document["buffers"] = json::array({{{"byteLength", m_out.size()}}});
  document["bufferViews"] = m_views;
  document["accessors"] = m_accessors;
}

}  // namespace dermis::import
