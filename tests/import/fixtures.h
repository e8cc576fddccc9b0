// Small model and image files that the tests write for themselves.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/io/importer.h"

namespace dermis::fixtures {

/// A folder of its own for one test, removed afterwards.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
  /// Writes a file and returns its path.
  std::filesystem::path put(const std::string& name, const std::string& bytes) const;

 private:
  std::filesystem::path m_path;
};

/// The module, or a failed test.
const Importer& module();

[[nodiscard]] std::string bytesOf(const std::filesystem::path& path);

// Models.

/// A cube from −0.1 to 0.1 of quads with UVs and two materials (`front` has the +Z side, `rest` the others); no
/// normals.
[[nodiscard]] std::string objCube(const std::string& mtl = "");
/// A UV sphere of radius 0.1: a group a latitude band, quads and triangles, no normals; as scans come from sculpting.
[[nodiscard]] std::string objSphere(int bands = 12, int sectors = 24);
[[nodiscard]] std::string plyTetrahedron(bool binary);
[[nodiscard]] std::string stlTetrahedron(bool binary);
[[nodiscard]] std::string stlOctahedron(bool binary);
[[nodiscard]] std::string daeTriangle(double metresAUnit, const std::string& upAxis);
[[nodiscard]] std::string fbxTriangle(double centimetresAUnit, bool zUp);

/// A glTF document under construction, written as GLB, or as text with its data in a data URI.
struct Gltf {
  Gltf();
  /// Adds an accessor over new data and returns its index.
  std::size_t floats(const std::vector<float>& values, const char* type);
  std::size_t shorts(const std::vector<std::uint16_t>& values, const char* type = "SCALAR");
  std::size_t view(const std::string& bytes);
  [[nodiscard]] std::string glb() const;
  [[nodiscard]] std::string text() const;

  nlohmann::json json;
  std::string binary;
};

/// One quad in the XY plane from −0.1 to 0.1 with normals and UVs whose V runs down, as glTF's do.
[[nodiscard]] Gltf gltfQuad();

// Images.

[[nodiscard]] Image makeImage(int width, int height, int channels, PixelType type, unsigned seed = 1);
[[nodiscard]] ImageLayer layerOf(Image image, const std::string& name = "");
[[nodiscard]] float valueAt(const Image& image, int x, int y, int channel);
/// Bytes of a small PNG.
[[nodiscard]] std::string pngBytes(int width = 4, int height = 4);

// Judging.

/// Whether a message is one sentence for a person: one line, no more than 400 bytes, naming `file`.
[[nodiscard]] bool isOneSentence(const std::string& message, const std::string& file);
/// What a Model promises (see model.h); empty where it holds, else what doesn't.
[[nodiscard]] std::string brokenPromise(const Model& model);
[[nodiscard]] std::string brokenPromise(const Image& image);

}  // namespace dermis::fixtures
