#include "passes/geometry.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/base/half.h"

namespace dermis {

namespace {

struct Vertex {
  glm::vec4 positionU, normalV, tangent;
};

/// A VertexBake in half floats, as resources/shaders/mesh_bake.glsl takes it.
using BakedVertex = std::array<std::uint16_t, 28>;
/// Of three vec4 each: Vertex, and what vertex_light.comp leaves of its light.
constexpr GLuint kFirstLightAttribute = 3, kLightBinding = 1;
constexpr std::size_t kThicknessAt = 9, kFarAt = 10, kBounceAt = 19;

BakedVertex packed(const VertexBake& bake) {
  BakedVertex halves{};
  for (std::size_t i = 0; i < 9; ++i) {
    halves[i] = halfOf(bake.hiddenSky[i]);
    halves[kFarAt + i] = halfOf(bake.farSky[i]);
    halves[kBounceAt + i] = halfOf(bake.bounce[i]);
  }
  halves[kThicknessAt] = halfOf(bake.thicknessMm);
  return halves;
}

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
  geometry.m_light = gl::Buffer::writable("light at vertices", vertices.size() * sizeof(Vertex));
  glVertexArrayVertexBuffer(id, kLightBinding, geometry.m_light.id(), 0, sizeof(Vertex));
  for (GLuint attribute = 0; attribute < 6; ++attribute) {
    const GLuint within = attribute % kFirstLightAttribute;
    glEnableVertexArrayAttrib(id, attribute);
    glVertexArrayAttribFormat(id, attribute, 4, GL_FLOAT, GL_FALSE, static_cast<GLuint>(within * sizeof(glm::vec4)));
    glVertexArrayAttribBinding(id, attribute, attribute < kFirstLightAttribute ? 0 : kLightBinding);
  }
  for (const ModelPart& part : model.parts) {
    Bounds bounds;
    std::uint32_t first = part.indexCount > 0 ? ~0U : 0U, end = 0;
    for (std::uint32_t i = 0; i < part.indexCount; ++i) {
      const std::uint32_t vertex = model.indices[part.firstIndex + i];
      bounds.grow(model.positions[vertex]);
      first = std::min(first, vertex);
      end = std::max(end, vertex + 1);
    }
    geometry.m_partBounds.push_back(bounds);
    geometry.m_vertexRanges.emplace_back(first, end - first);
  }
  return geometry;
}

void Geometry::setBake(const MeshBake* bake) {
  m_baked = gl::Buffer();
  m_solids.clear();
  if (bake == nullptr) return;
  m_solids = bake->solids;
  std::vector<BakedVertex> vertices;
  vertices.reserve(bake->vertices.size());
  for (const VertexBake& vertex : bake->vertices) vertices.push_back(packed(vertex));
  m_baked = gl::Buffer::fixed("mesh bake", std::as_bytes(std::span(vertices)));
}

void Geometry::bindForLight() const {
  m_vertices.bindStorage(0);
  m_light.bindStorage(1);
  (m_baked ? m_baked : m_vertices).bindStorage(2);  // never read where nothing is baked
}

void Geometry::bind() const { m_vertexArray.bind(); }

glm::uvec2 Geometry::vertexRange(std::size_t part, int level) const {
  if (level == 0) return m_vertexRanges.at(part);
  const CoarseMesh::Part& coarse = m_coarse.at(static_cast<std::size_t>(level) - 1).parts.at(part);
  return {coarse.firstVertex, coarse.vertexCount};
}

void Geometry::setCoarse(const std::vector<CoarseMesh>& levels) {
  m_coarse.clear();
  std::vector<std::uint32_t> indices, vertices;
  for (const CoarseMesh& level : levels) {
    CoarseLevel made{level.parts, level.error};
    for (CoarseMesh::Part& part : made.parts) {
      part.firstIndex += static_cast<std::uint32_t>(indices.size());
      part.firstVertex += static_cast<std::uint32_t>(vertices.size());
    }
    indices.insert(indices.end(), level.indices.begin(), level.indices.end());
    vertices.insert(vertices.end(), level.vertices.begin(), level.vertices.end());
    m_coarse.push_back(std::move(made));
  }
  m_coarseIndices = gl::Buffer::fixed("coarse indices", std::as_bytes(std::span(indices)));
  m_coarseVertices = gl::Buffer::fixed("coarse vertices", std::as_bytes(std::span(vertices)));
}

int Geometry::levelWithin(float sceneUnits) const {
  int level = 0;
  for (const CoarseLevel& coarse : m_coarse) level += coarse.error <= sceneUnits ? 1 : 0;
  return level;
}

float Geometry::errorOf(int level) const {
  return level == 0 ? 0.0F : m_coarse.at(static_cast<std::size_t>(level) - 1).error;
}

void Geometry::bindCoarseVertices() const {
  constexpr GLuint kCoarseBinding = 3;
  m_coarseVertices.bindStorage(kCoarseBinding);
}

void Geometry::draw(const ModelPart& part) const {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.indexCount), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(static_cast<std::uintptr_t>(part.firstIndex) * sizeof(std::uint32_t)));
}

void Geometry::drawPart(std::size_t part, int level, const Model& model) const {
  if (level == 0) {
    draw(model.parts[part]);
    return;
  }
  const CoarseMesh::Part& coarse = m_coarse.at(static_cast<std::size_t>(level) - 1).parts.at(part);
  glVertexArrayElementBuffer(m_vertexArray.id(), m_coarseIndices.id());
  draw({0, coarse.firstIndex, coarse.indexCount});
  glVertexArrayElementBuffer(m_vertexArray.id(), m_indices.id());
}

void Geometry::prepareDisplacement(const Model& model) {
  if (m_displacementFrames) return;
  DisplacementFrames frames = displacementFrames(model);
  m_displacementFrames = gl::Buffer::fixed("displacement frames", std::as_bytes(std::span(frames.vertices)));
  m_densities = std::move(frames.parts);
  std::vector<std::uint32_t> indices;
  std::vector<DisplacementSeam> seams;
  indices.reserve(model.indices.size());
  for (const ModelPart& part : model.parts) {
    Patches patches{static_cast<std::uint32_t>(indices.size()), 0, 0, static_cast<int>(seams.size())};
    for (const bool onSeam : {false, true})
      for (std::uint32_t k = part.firstIndex; k + 2 < part.firstIndex + part.indexCount; k += 3) {
        const std::uint32_t seam = frames.seamOfTriangle.empty() ? 0 : frames.seamOfTriangle[k / 3];
        if ((seam != 0) != onSeam) continue;
        indices.insert(indices.end(), &model.indices[k], &model.indices[k] + 3);
        (onSeam ? patches.seamIndices : patches.plainIndices) += 3;
        if (onSeam) seams.push_back(frames.seams[seam - 1]);
      }
    m_patches.push_back(patches);
  }
  m_patchIndices = gl::Buffer::fixed("patch indices", std::as_bytes(std::span(indices)));
  if (!seams.empty()) m_seams = gl::Buffer::fixed("displacement seams", std::as_bytes(std::span(seams)));
  const GLuint id = m_vertexArray.id();
  constexpr GLuint kFirstAttribute = 8;
  constexpr GLuint kBufferBinding = 2;
  glVertexArrayVertexBuffer(id, kBufferBinding, m_displacementFrames.id(), 0, sizeof(DisplacementFrame));
  for (GLuint i = 0; i < 3; ++i) {
    glEnableVertexArrayAttrib(id, kFirstAttribute + i);
    glVertexArrayAttribFormat(id, kFirstAttribute + i, 4, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(i * sizeof(glm::vec4)));
    glVertexArrayAttribBinding(id, kFirstAttribute + i, kBufferBinding);
  }
}

void Geometry::drawPatches(std::size_t part, GLint seamUniform) const {
  const Patches& patches = m_patches.at(part);
  const auto draw = [](std::uint32_t first, std::uint32_t count) {
    glDrawElements(GL_PATCHES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first) * sizeof(std::uint32_t)));
  };
  glPatchParameteri(GL_PATCH_VERTICES, 3);
  glVertexArrayElementBuffer(m_vertexArray.id(), m_patchIndices.id());
  glUniform1i(seamUniform, -1);
  draw(patches.firstIndex, patches.plainIndices);
  if (patches.seamIndices > 0) {
    constexpr GLuint kSeamBinding = 7;
    // Mesa's software GL counts gl_PrimitiveID from zero again somewhere in a long draw.
    constexpr std::uint32_t kIndicesAtOnce = 3 * 64;
    m_seams.bindStorage(kSeamBinding);
    for (std::uint32_t done = 0; done < patches.seamIndices; done += kIndicesAtOnce) {
      glUniform1i(seamUniform, patches.firstSeam + static_cast<GLint>(done / 3));
      draw(patches.firstIndex + patches.plainIndices + done, std::min(kIndicesAtOnce, patches.seamIndices - done));
    }
  }
  glVertexArrayElementBuffer(m_vertexArray.id(), m_indices.id());
}

}  // namespace dermis
