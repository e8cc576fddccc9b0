// A model as flat, checked buffers: what a loader returns and the renderer uploads.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/material/material.h"

namespace dermis {

struct Bounds {
  glm::vec3 min{std::numeric_limits<float>::max()};
  glm::vec3 max{std::numeric_limits<float>::lowest()};

  void grow(const glm::vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  [[nodiscard]] bool empty() const { return min.x > max.x; }
  [[nodiscard]] glm::vec3 centre() const { return empty() ? glm::vec3(0.0F) : 0.5F * (min + max); }
  [[nodiscard]] float radius() const { return empty() ? 1.0F : 0.5F * glm::length(max - min); }
};

/// A run of triangles that share a material slot.
struct ModelPart {
  std::uint32_t slot = 0;
  std::uint32_t firstIndex = 0;
  std::uint32_t indexCount = 0;
};

/// A material of the file, as a slot: its unique name, and the look its author gave it (`metallic_roughness`).
/// Texture paths of `imported` are absolute, or `embedded:N` for Model::embedded[N].
struct ModelSlot {
  std::string name;
  Material imported;
};

/// Bytes of an image that travelled inside the model's file.
struct EmbeddedImage {
  std::string name;
  std::vector<std::byte> bytes;
};

/// Invariants that a loader establishes: all vertex arrays have the same length, every index is below it, every
/// number is finite, normals are unit length, every part's slot exists, indexCount is a multiple of three. The vertices
/// of a part lie together, and no part of another slot uses them.
struct Model {
  std::vector<glm::vec3> positions;  ///< scene units, node transforms applied
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;  ///< xyz unit, w = ±1: bitangent = w · cross(normal, tangent), as glTF
  std::vector<glm::vec2> uvs;       ///< (0,0) at the lower left, as GL
  std::vector<std::uint32_t> indices;
  std::vector<ModelPart> parts;  ///< one a slot, in slot order
  std::vector<ModelSlot> slots;
  std::vector<EmbeddedImage> embedded;
  Bounds bounds;
  float millimetresPerUnit = 1000.0F;  ///< from the file's unit, or guessed
  std::string unitSource;              ///< how that was found, a phrase for people: "glTF: metres"
  bool hasUvs = true;                  ///< false: uvs are zeros
  Warnings warnings;
};

}  // namespace dermis
