#include "passes/geometry.h"

#include <span>

namespace dermis {

namespace {

struct Vertex {
  glm::vec4 positionU, normalV, tangent;
};

}  // namespace

Geometry Geometry::upload(const Model& model) {
  Geometry geometry;
  std::vector<Vertex> vertices(model.positions.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::vec2 uv = i < model.uvs.size() ? model.uvs[i] : glm::vec2(0.0F);
    vertices[i].positionU = {model.positions[i], uv.x};
    vertices[i].normalV = {i < model.normals.size() ? model.normals[i] : glm::vec3(0.0F, 0.0F, 1.0F), uv.y};
    vertices[i].tangent = i < model.tangents.size() ? model.tangents[i] : glm::vec4(0.0F);
  }
  geometry.m_vertices = gl::Buffer::fixed("vertices", std::as_bytes(std::span(vertices)));
  geometry.m_indices = gl::Buffer::fixed("indices", std::as_bytes(std::span(model.indices)));
  geometry.m_vertexArray = gl::VertexArray::create("model");
  const GLuint id = geometry.m_vertexArray.id();
  glVertexArrayVertexBuffer(id, 0, geometry.m_vertices.id(), 0, sizeof(Vertex));
  glVertexArrayElementBuffer(id, geometry.m_indices.id());
  for (GLuint attribute = 0; attribute < 3; ++attribute) {
    glEnableVertexArrayAttrib(id, attribute);
    glVertexArrayAttribFormat(id, attribute, 4, GL_FLOAT, GL_FALSE, static_cast<GLuint>(attribute * sizeof(glm::vec4)));
    glVertexArrayAttribBinding(id, attribute, 0);
  }
  for (const ModelPart& part : model.parts) {
    Bounds bounds;
    for (std::uint32_t i = 0; i < part.indexCount; ++i)
      bounds.grow(model.positions[model.indices[part.firstIndex + i]]);
    geometry.m_partCentres.push_back(bounds.centre());
  }
  return geometry;
}

void Geometry::draw(const ModelPart& part) const {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.indexCount), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(static_cast<std::uintptr_t>(part.firstIndex) * sizeof(std::uint32_t)));
}

}  // namespace dermis
