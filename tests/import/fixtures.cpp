#include "fixtures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <random>

namespace dermis::fixtures {

Folder::Folder() {
  static std::atomic<int> counter = 0;
  m_path = std::filesystem::temp_directory_path() / fmt::format("dermis-import-test-{}-{}", ::getpid(), counter++);
  std::filesystem::create_directories(m_path);
}

Folder::~Folder() {
  std::error_code error;
  std::filesystem::remove_all(m_path, error);
}

std::filesystem::path Folder::put(const std::string& name, const std::string& bytes) const {
  const std::filesystem::path path = m_path / name;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

const Importer& module() {
  const auto loaded = importer();
  if (!loaded) throw std::runtime_error(loaded.error().message);
  return **loaded;
}

std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string objCube(const std::string& mtl) {
  std::string out = mtl.empty() ? "" : "mtllib " + mtl + "\n";
  for (const double z : {-0.1, 0.1})
    for (const double y : {-0.1, 0.1})
      for (const double x : {-0.1, 0.1}) out += fmt::format("v {} {} {}\n", x, y, z);
  out += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  const auto quad = [&](int a, int b, int c, int d) { out += fmt::format("f {}/1 {}/2 {}/3 {}/4\n", a, b, c, d); };
  out += "usemtl front\n";
  quad(5, 6, 8, 7);
  out += "usemtl rest\n";
  quad(2, 1, 3, 4);
  quad(1, 5, 7, 3);
  quad(6, 2, 4, 8);
  quad(1, 2, 6, 5);
  quad(7, 8, 4, 3);
  return out;
}

std::string objSphere(int bands, int sectors) {
  std::string out;
  const double pi = std::numbers::pi;
  for (int b = 0; b <= bands; ++b)
    for (int s = 0; s < sectors; ++s) {
      const double theta = pi * b / bands, phi = 2.0 * pi * s / sectors;
      out += fmt::format("v {:.9f} {:.9f} {:.9f}\n", 0.1 * std::sin(theta) * std::cos(phi), 0.1 * std::cos(theta),
                         0.1 * std::sin(theta) * std::sin(phi));
    }
  for (int b = 0; b <= bands; ++b)
    for (int s = 0; s <= sectors; ++s)
      out += fmt::format("vt {:.6f} {:.6f}\n", static_cast<double>(s) / sectors, 1.0 - static_cast<double>(b) / bands);
  out += "usemtl skin\n";
  for (int b = 0; b < bands; ++b) {
    out += fmt::format("g band{}\n", b);
    for (int s = 0; s < sectors; ++s) {
      const auto corner = [&](int band, int sector) {
        return fmt::format(" {}/{}", band * sectors + sector % sectors + 1, band * (sectors + 1) + sector + 1);
      };
      if (b == 0)
        out += "f" + corner(0, s) + corner(1, s + 1) + corner(1, s) + "\r\n";
      else if (b == bands - 1)
        out += "f" + corner(b, s) + corner(b, s + 1) + corner(b + 1, s) + "\n";
      else
        out += "f" + corner(b, s) + corner(b, s + 1) + corner(b + 1, s + 1) + corner(b + 1, s) + "\n";
    }
  }
  return out;
}

namespace {

const std::vector<glm::vec3> kTetrahedron = {{0, 0, 0}, {0.2F, 0, 0}, {0, 0.3F, 0}, {0, 0, 0.2F}};
const std::vector<glm::ivec3> kTetrahedronFaces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

template <class T>
void append(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

}  // namespace

std::string plyTetrahedron(bool binary) {
  std::string out = fmt::format(
      "ply\nformat {} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n",
      binary ? "binary_little_endian" : "ascii");
  for (const glm::vec3& p : kTetrahedron)
    if (binary)
      append(out, p);
    else
      out += fmt::format("{} {} {}\n", p.x, p.y, p.z);
  for (const glm::ivec3& f : kTetrahedronFaces)
    if (binary) {
      append(out, std::uint8_t{3});
      append(out, f);
    } else {
      out += fmt::format("3 {} {} {}\n", f.x, f.y, f.z);
    }
  return out;
}

namespace {

std::string stlOf(const std::vector<glm::vec3>& positions, const std::vector<glm::ivec3>& faces, bool binary) {
  std::string out = binary ? std::string(80, ' ') : "solid t\n";
  if (binary) append(out, static_cast<std::uint32_t>(faces.size()));
  for (const glm::ivec3& f : faces) {
    const auto corner = [&](int i) { return positions[static_cast<std::size_t>(f[i])]; };
    const glm::vec3 normal = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    if (binary) {
      append(out, normal);
      for (int i = 0; i < 3; ++i) append(out, corner(i));
      append(out, std::uint16_t{0});
    } else {
      out += fmt::format("facet normal {} {} {}\n outer loop\n", normal.x, normal.y, normal.z);
      for (int i = 0; i < 3; ++i) out += fmt::format("  vertex {} {} {}\n", corner(i).x, corner(i).y, corner(i).z);
      out += " endloop\nendfacet\n";
    }
  }
  return binary ? out : out + "endsolid t\n";
}

}  // namespace

std::string stlTetrahedron(bool binary) { return stlOf(kTetrahedron, kTetrahedronFaces, binary); }

std::string stlOctahedron(bool binary) {
  return stlOf({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
               {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}, binary);
}

std::string daeTriangle(double metresAUnit, const std::string& upAxis) {
  return fmt::format(R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit name="own" meter="{}"/><up_axis>{}</up_axis></asset>
 <library_effects><effect id="e"><profile_COMMON><technique sid="common"><phong>
  <diffuse><color>1 0 0 1</color></diffuse></phong></technique></profile_COMMON></effect></library_effects>
 <library_materials><material id="m" name="red"><instance_effect url="#e"/></material></library_materials>
 <library_geometries><geometry id="g" name="g"><mesh>
  <source id="p"><float_array id="pa" count="9">0 0 0 10 0 0 0 0 30</float_array><technique_common>
   <accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
   <param name="Z" type="float"/></accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="1" material="mm"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
  <instance_material symbol="mm" target="#m"/></technique_common></bind_material></instance_geometry></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)",
                     metresAUnit, upAxis);
}

std::string fbxTriangle(double centimetresAUnit, bool zUp) {
  std::string out = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}
GlobalSettings:  {
	Version: 1000
	Properties70:  {
)";
  const auto axis = [&](const char* name, int value, int sign) {
    out += fmt::format(
        "\t\tP: \"{0}\", \"int\", \"Integer\", \"\",{1}\n\t\tP: \"{0}Sign\", \"int\", \"Integer\", \"\",{2}\n", name,
        value, sign);
  };
  axis("UpAxis", zUp ? 2 : 1, 1);
  axis("FrontAxis", zUp ? 1 : 2, zUp ? -1 : 1);
  axis("CoordAxis", 0, 1);
  out += fmt::format("\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\",{}\n\t}}\n}}\n", centimetresAUnit);
  out += R"(Objects:  {
	Geometry: 1001, "Geometry::g", "Mesh" {
		Vertices: *9 {
			a: 0,0,0,10,0,0,0,0,30
		}
		PolygonVertexIndex: *3 {
			a: 0,1,-3
		}
		GeometryVersion: 124
		LayerElementMaterial: 0 {
			Version: 101
			Name: ""
			MappingInformationType: "AllSame"
			ReferenceInformationType: "IndexToDirect"
			Materials: *1 {
				a: 0
			}
		}
		Layer: 0 {
			Version: 100
			LayerElement:  {
				Type: "LayerElementMaterial"
				TypedIndex: 0
			}
		}
	}
	Model: 1002, "Model::n", "Mesh" {
		Version: 232
	}
	Material: 1003, "Material::red", "" {
		Version: 102
		ShadingModel: "phong"
		Properties70:  {
			P: "DiffuseColor", "Color", "", "A",1,0,0
		}
	}
}
Connections:  {
	C: "OO",1002,0
	C: "OO",1001,1002
	C: "OO",1003,1002
}
)";
  return out;
}

Gltf::Gltf() : json({{"asset", {{"version", "2.0"}}}}) {}

std::size_t Gltf::view(const std::string& bytes) {
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
  binary += bytes;
  binary.append((4 - binary.size() % 4) % 4, '\0');
  return json["bufferViews"].size() - 1;
}

std::size_t Gltf::floats(const std::vector<float>& values, const char* type) {
  const std::size_t components = std::strcmp(type, "SCALAR") == 0 ? 1
                                 : std::strcmp(type, "MAT4") == 0 ? 16
                                                                  : static_cast<std::size_t>(type[3] - '0');
  const std::size_t data = view({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)});
  json["accessors"].push_back(
      {{"bufferView", data}, {"componentType", 5126}, {"count", values.size() / components}, {"type", type}});
  return json["accessors"].size() - 1;
}

std::size_t Gltf::shorts(const std::vector<std::uint16_t>& values, const char* type) {
  const std::size_t components = std::strcmp(type, "SCALAR") == 0 ? 1 : static_cast<std::size_t>(type[3] - '0');
  const std::size_t data = view({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(std::uint16_t)});
  json["accessors"].push_back(
      {{"bufferView", data}, {"componentType", 5123}, {"count", values.size() / components}, {"type", type}});
  return json["accessors"].size() - 1;
}

std::string Gltf::glb() const {
  nlohmann::json document = json;
  document["buffers"] = {{{"byteLength", binary.size()}}};
  std::string chunk = document.dump();
  chunk.append((4 - chunk.size() % 4) % 4, ' ');
  std::string out;
  append(out, std::uint32_t{0x46546C67});
  append(out, std::uint32_t{2});
  append(out, static_cast<std::uint32_t>(28 + chunk.size() + binary.size()));
  append(out, static_cast<std::uint32_t>(chunk.size()));
  append(out, std::uint32_t{0x4E4F534A});
  out += chunk;
  append(out, static_cast<std::uint32_t>(binary.size()));
  append(out, std::uint32_t{0x004E4942});
  return out + binary;
}

std::string Gltf::text() const {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string encoded;
  for (std::size_t i = 0; i < binary.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (i + k < binary.size() ? static_cast<std::uint8_t>(binary[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) encoded += i + k > binary.size() ? '=' : kDigits[(bits >> (18 - 6 * k)) & 63U];
  }
  nlohmann::json document = json;
  document["buffers"] = {{{"byteLength", binary.size()}, {"uri", "data:application/octet-stream;base64," + encoded}}};
  return document.dump();
}

Gltf gltfQuad() {
  Gltf gltf;
  const std::size_t position = gltf.floats({-0.1F, -0.1F, 0, 0.1F, -0.1F, 0, 0.1F, 0.1F, 0, -0.1F, 0.1F, 0}, "VEC3");
  const std::size_t normal = gltf.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const std::size_t uv = gltf.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
  const std::size_t indices = gltf.shorts({0, 1, 2, 0, 2, 3});
  gltf.json["materials"] = {
      {{"name", "skin"}, {"pbrMetallicRoughness", {{"metallicFactor", 0.25}, {"roughnessFactor", 0.75}}}}};
  gltf.json["meshes"] = {{{"primitives",
                           {{{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}},
                             {"indices", indices},
                             {"material", 0}}}}}};
  gltf.json["nodes"] = {{{"mesh", 0}, {"name", "quad"}}};
  gltf.json["scenes"] = {{{"nodes", {0}}}};
  gltf.json["scene"] = 0;
  return gltf;
}

Image makeImage(int width, int height, int channels, PixelType type, unsigned seed) {
  Image image{width, height, channels, type, {}, "made"};
  image.pixels.resize(image.rowBytes() * static_cast<std::size_t>(height));
  std::mt19937 random(seed);
  const std::size_t count = image.pixels.size() / bytesPerChannel(type);
  for (std::size_t i = 0; i < count; ++i) {
    std::byte* at = image.pixels.data() + i * bytesPerChannel(type);
    const auto bits = static_cast<std::uint16_t>(random());
    const auto half = static_cast<std::uint16_t>(0x2000U + bits % 0x2400U);  // finite halves from 0.008 to 2.0
    const float single = static_cast<float>(bits) / 4096.0F - 2.0F;
    switch (type) {
      case PixelType::U8:
        *at = static_cast<std::byte>(bits);
        break;
      case PixelType::U16:
        std::memcpy(at, &bits, 2);
        break;
      case PixelType::Half:
        std::memcpy(at, &half, 2);
        break;
      case PixelType::Float:
        std::memcpy(at, &single, 4);
        break;
    }
  }
  return image;
}

ImageLayer layerOf(Image image, const std::string& name) {
  static const std::vector<std::vector<std::string>> kNames = {
      {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
  ImageLayer layer{name, kNames.at(static_cast<std::size_t>(image.channels - 1)), std::move(image)};
  return layer;
}

float valueAt(const Image& image, int x, int y, int channel) {
  const std::byte* at = image.pixels.data() + static_cast<std::size_t>(y) * image.rowBytes() +
                        static_cast<std::size_t>(x * image.channels + channel) * bytesPerChannel(image.type);
  std::uint16_t bits = 0;
  float single = 0.0F;
  switch (image.type) {
    case PixelType::U8:
      return static_cast<float>(*at) / 255.0F;
    case PixelType::U16:
      std::memcpy(&bits, at, 2);
      return static_cast<float>(bits) / 65535.0F;
    case PixelType::Half: {
      std::memcpy(&bits, at, 2);
      const int exponent = (bits >> 10) & 31;
      const double mantissa = bits & 1023;
      const double size = exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024.0 + mantissa, exponent - 25);
      return static_cast<float>((bits & 0x8000) != 0 ? -size : size);
    }
    case PixelType::Float:
      std::memcpy(&single, at, 4);
      return single;
  }
  return 0.0F;
}

std::string pngBytes(int width, int height) {
  const Folder folder;
  const auto written = module().writeImage(folder / "a.png", {layerOf(makeImage(width, height, 3, PixelType::U8))}, {});
  return written ? bytesOf(folder / "a.png") : std::string();
}

bool isOneSentence(const std::string& message, const std::string& file) {
  return !message.empty() && message.size() <= 400 && message.find('\n') == std::string::npos &&
         message.find(file) != std::string::npos;
}

std::string brokenPromise(const Model& model) {
  const std::size_t count = model.positions.size();
  if (count == 0 || model.indices.empty() || model.slots.empty()) return "is empty";
  if (model.normals.size() != count || model.tangents.size() != count || model.uvs.size() != count)
    return "has arrays of different lengths";
  for (const std::uint32_t index : model.indices)
    if (index >= count) return "has an index out of range";
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 p = model.positions[i], n = model.normals[i], t = model.tangents[i];
    const float sum = p.x + p.y + p.z + n.x + n.y + n.z + t.x + t.y + t.z + model.uvs[i].x + model.uvs[i].y;
    if (!std::isfinite(sum)) return "has a number that is not finite";
    if (std::abs(glm::length(n) - 1.0F) > 1e-4F) return "has a normal that is not unit";
    if (std::abs(glm::length(t) - 1.0F) > 1e-4F) return "has a tangent that is not unit";
    if (std::abs(glm::dot(n, t)) > 1e-3F) return "has a tangent that is not perpendicular";
    if (std::abs(model.tangents[i].w) != 1.0F) return "has a tangent without a side";
  }
  std::size_t next = 0;
  for (const ModelPart& part : model.parts) {
    if (part.slot >= model.slots.size()) return "has a part of no slot";
    if (part.indexCount % 3 != 0 || part.firstIndex != next) return "has parts that leave gaps";
    next += part.indexCount;
  }
  if (next != model.indices.size()) return "has triangles of no part";
  if (!(model.millimetresPerUnit > 0.0F) || !std::isfinite(model.millimetresPerUnit)) return "has no unit";
  return {};
}

std::string brokenPromise(const Image& image) {
  if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4) return "has no size";
  if (image.pixels.size() != image.rowBytes() * static_cast<std::size_t>(image.height))
    return "has the wrong number of bytes";
  return {};
}

}  // namespace dermis::fixtures
