// A model on the GPU.
#pragma once

#include <memory>
#include <vector>

#include "core/bake/mesh_bake.h"
#include "core/scene/coarse_mesh.h"
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
  /// Whether a part bounds solids, as far as that was baked: from outside none of its back faces is seen.
  [[nodiscard]] bool boundsSolids(std::size_t part) const { return part < m_solids.size() && m_solids[part] != 0; }
  /// Vertices, their light and what was baked of them, as vertex_light.comp takes them.
  void bindForLight() const;
  /// The vertices that a part's triangles of a level use: first and count, of all vertices or of coarseVertices().
  [[nodiscard]] glm::uvec2 vertexRange(std::size_t part, int level = 0) const;

  void bind() const;
  void draw(const ModelPart& part) const;

  /// Levels of fewer triangles for drawPart(), each of vertices of the one before.
  void setCoarse(const std::vector<CoarseMesh>& levels);
  /// Whether they were set, were it to none.
  [[nodiscard]] bool hasCoarse() const { return static_cast<bool>(m_coarseIndices); }
  /// The one with the fewest triangles whose surface is no farther than this from the model's; 0 is the model itself.
  [[nodiscard]] int levelWithin(float sceneUnits) const;
  /// How far a level's surface is from the model's, scene units.
  [[nodiscard]] float errorOf(int level) const;
  /// Draws a part of a level; the geometry is bound.
  void drawPart(std::size_t part, int level, const Model& model) const;
  /// Numbers of the vertices that coarse levels use, for vertex_light.comp.
  void bindCoarseVertices() const;

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
  std::vector<std::uint8_t> m_solids;
  std::vector<glm::uvec2> m_vertexRanges;
  /// A part's triangles that lie on no seam, then those that do, whose seams have consecutive numbers.
  struct Patches {
    std::uint32_t firstIndex = 0, plainIndices = 0, seamIndices = 0;
    int firstSeam = 0;
  };
  /// As CoarseMesh has them; first indices and vertices count from the beginning of the buffers.
  struct CoarseLevel {
    std::vector<CoarseMesh::Part> parts;
    float error = 0.0F;
  };
  std::vector<CoarseLevel> m_coarse;
  gl::Buffer m_coarseIndices, m_coarseVertices;
  gl::Buffer m_displacementFrames, m_patchIndices, m_seams;
  std::vector<DisplacementDensity> m_densities;
  std::vector<Patches> m_patches;
};

}  // namespace dermis
