// Fewer triangles for a picture of fewer pixels.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/scene/model.h"

namespace dermis {

/// A model's surface by fewer of its own vertices.
struct CoarseMesh {
  std::vector<std::uint32_t> indices;   ///< into the model's vertices
  std::vector<std::uint32_t> vertices;  ///< those that they use, each once, a part's together
  struct Part {                         ///< a first number and a count of both, parallel to Model::parts
    std::uint32_t firstIndex = 0, indexCount = 0;
    std::uint32_t firstVertex = 0, vertexCount = 0;
  };
  std::vector<Part> parts;
  float error = 0.0F;  ///< root mean square distance of its worst corner to the surface it replaces, scene units;
                       ///< its farthest place is some three times that away
};

/// Levels of `model`, each with about a quarter of the triangles of the one before, or fewer where `mostError` (scene
/// units) stops it; ends where that no longer halves them. Open borders stay as they are, and parts of many
/// small pieces (hairs, lashes), which are too thin to lose a vertex.
/// Collapses edges by quadric error (Garland & Heckbert 1997, "Surface Simplification Using Quadric Error Metrics").
[[nodiscard]] std::vector<CoarseMesh> coarseMeshes(const Model& model, float mostError);

}  // namespace dermis
