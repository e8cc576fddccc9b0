// A model on the GPU.
#pragma once

#include <memory>
#include <vector>

#include "core/bake/mesh_bake.h"
#include "core/scene/model.h"
#include "gl/gl_objects.h"

namespace dermis {

/// One vertex array for the whole model. A vertex is three vec4: position with u, normal with v, tangent with its sign.
class Geometry {
 public:
  [[nodiscard]] static Geometry upload(const Model& model);

  /// What was baked of the model's vertices, or null: then they know nothing.
  void setBake(const MeshBake* bake);

  void bind() const;
  void draw(const ModelPart& part) const;
  /// Middle of each part's bounds, parallel to Model::parts: blended parts are sorted by it.
  [[nodiscard]] const std::vector<glm::vec3>& partCentres() const { return m_partCentres; }

 private:
  gl::VertexArray m_vertexArray;
  gl::Buffer m_vertices, m_indices, m_baked;
  std::vector<glm::vec3> m_partCentres;
};

}  // namespace dermis
