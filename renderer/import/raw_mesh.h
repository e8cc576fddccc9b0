// The file's triangles before welding: one vertex and index buffer for all slots.
#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace dermis::import {

/// Vertices are as in the file (one a corner in many formats), placed by their nodes. Arrays have the same length;
/// `normals` hold zeros where the file has none, `tangents` w = 0; every index is below that length.
struct RawMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;  ///< empty where no mesh of the file has any
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> indices;  ///< triangles, slot after slot

  struct Run {
    unsigned material = 0;  ///< index in aiScene::mMaterials
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    std::uint32_t firstVertex = 0;  ///< its indices stay within its own vertices
    std::uint32_t vertexCount = 0;
  };
  std::vector<Run> runs;  ///< one a material that is used, in the file's order
  bool anyUvs = false;
  bool normalsMissing = false;
};

/// What the file's format lets us believe.
struct FormatTraits {
  bool trustNormals = true;    ///< false for STL, whose normals are those of the facets
  bool trustTangents = false;  ///< true for glTF, whose convention is ours
  glm::dmat4 correction{1.0};  ///< applied to the whole scene (see model_units.h)
};

/// Flattens the node tree. Errors: Input (non-finite or absurd coordinates, indices out of range, nothing to show,
/// too much), Cancelled.
[[nodiscard]] Result<RawMesh> flattenScene(const aiScene& scene, const FormatTraits& traits, const std::string& name,
                                           Warnings& warnings, const std::stop_token& stop);

}  // namespace dermis::import
