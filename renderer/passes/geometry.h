// A model on the GPU.
#pragma once

#include <memory>
#include <vector>

#include "core/bake/mesh_bake.h"
#include "core/scene/displacement_frames.h"
#include "core/scene/model.h"
#include "gl/gl_objects.h"

namespace dermis {

/// One vertex array for the whole model. A vertex is three vec4: position with u, normal with v, tangent with its sign.
class Geometry {
 public:
  [[nodiscard]] static Geometry upload(const Model& model);

  /// What was baked of the model's vertices, or null: then they know nothing.
  void setBake(const MeshBake* bake);
  [[nodiscard]] bool hasBake() const { return static_cast<bool>(m_baked); }
  /// Vertices, their light and what was baked of them, as vertex_light.comp takes them.
  void bindForLight() const;
  /// The vertices that a part's triangles use: first and count.
  [[nodiscard]] glm::uvec2 vertexRange(std::size_t part) const { return m_vertexRanges.at(part); }

  void bind() const;
  void draw(const ModelPart& part) const;

  /// What displaced parts need beside the vertices: attributes 8 to 10 and the seams. Does nothing a second time.
  void prepareDisplacement(const Model& model);
  /// A part as patches, for a tessellated program in use; `seamUniform` is where its u_displace_seam is.
  void drawPatches(std::size_t part, GLint seamUniform) const;
  [[nodiscard]] const DisplacementDensity& displacementDensity(std::size_t part) const { return m_densities.at(part); }
  /// Of each part without displacement, parallel to Model::parts.
  [[nodiscard]] const std::vector<Bounds>& partBounds() const { return m_partBounds; }

 private:
  gl::VertexArray m_vertexArray;
  gl::Buffer m_vertices, m_indices, m_baked, m_light;
  std::vector<Bounds> m_partBounds;
  std::vector<glm::uvec2> m_vertexRanges;
  /// A part's triangles that lie on no seam, then those that do, whose seams have consecutive numbers.
  struct Patches {
    std::uint32_t firstIndex = 0, plainIndices = 0, seamIndices = 0;
    int firstSeam = 0;
  };
  gl::Buffer m_displacementFrames, m_patchIndices, m_seams;
  std::vector<DisplacementDensity> m_densities;
  std::vector<Patches> m_patches;
};

}  // namespace dermis
