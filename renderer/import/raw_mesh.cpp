#include "import/raw_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

#include "import/text.h"

namespace dermis::import {
namespace {

/// Past this, sums over a mesh lose their meaning in 32-bit floats; no unit of length needs it.
constexpr float kLargestCoordinate = 1e12F;
constexpr std::size_t kMostVertices = 300'000'000;

glm::dmat4 toGlm(const aiMatrix4x4& m) {
  // Assimp's are row-major.
  return glm::transpose(
      glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

bool finite(const aiVector3D& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

struct Instance {
  unsigned mesh = 0;
  glm::dmat4 world{1.0};
};

/// Every mesh at every place the node tree has it, and where each node is (for skins).
struct Placement {
  std::vector<Instance> instances;
  std::unordered_map<std::string, glm::dmat4> nodes;
};

Placement placeMeshes(const aiScene& scene, const glm::dmat4& correction) {
  Placement placement;
  std::vector<std::pair<const aiNode*, glm::dmat4>> open = {{scene.mRootNode, correction}};
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    const glm::dmat4 world = parent * toGlm(node->mTransformation);
    placement.nodes.try_emplace(node->mName.C_Str(), world);
    for (unsigned i = 0; i < node->mNumMeshes; ++i)
      if (node->mMeshes[i] < scene.mNumMeshes) placement.instances.push_back({node->mMeshes[i], world});
    for (unsigned i = node->mNumChildren; i-- > 0;)
      if (node->mChildren[i] != nullptr) open.emplace_back(node->mChildren[i], world);
  }
  // Meshes of one material next to each other, otherwise in the file's order.
  std::stable_sort(placement.instances.begin(), placement.instances.end(), [&](const Instance& a, const Instance& b) {
    return scene.mMeshes[a.mesh]->mMaterialIndex < scene.mMeshes[b.mesh]->mMaterialIndex;
  });
  return placement;
}

std::string meshName(const aiScene& scene, unsigned index) {
  const std::string name = phrase(scene.mMeshes[index]->mName.C_Str(), 60);
  return name.empty() ? fmt::format("mesh {}", index) : fmt::format("mesh \"{}\"", name);
}

/// A skinned vertex is placed by its bones: Σ weight · bone · offset (glTF 2.0, §3.7.3.3), not by its node.
/// Empty for a mesh without usable bones.
std::vector<glm::dmat4> skinMatrices(const aiMesh& mesh, const Placement& placement) {
  std::vector<glm::dmat4> matrices;
  if (mesh.mNumBones == 0 || mesh.mBones == nullptr) return matrices;
  matrices.assign(mesh.mNumVertices, glm::dmat4(0.0));
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone* bone = mesh.mBones[b];
    if (bone == nullptr || bone->mWeights == nullptr) continue;
    const auto node = placement.nodes.find(bone->mName.C_Str());
    if (node == placement.nodes.end()) return {};
    const glm::dmat4 matrix = node->second * toGlm(bone->mOffsetMatrix);
    for (unsigned w = 0; w < bone->mNumWeights; ++w) {
      const aiVertexWeight& weight = bone->mWeights[w];
      if (weight.mVertexId < mesh.mNumVertices && std::isfinite(weight.mWeight))
        matrices[weight.mVertexId] += static_cast<double>(weight.mWeight) * matrix;
    }
  }
  for (glm::dmat4& m : matrices) {
    if (!(m[3][3] > 1e-6)) return {};  // a vertex that no bone holds: not a skin we understand
    m /= m[3][3];
  }
  return matrices;
}

/// Linear parts of a placement, for points, normals and tangents.
struct Transform {
  explicit Transform(const glm::dmat4& m) : world(m), linear(glm::dmat3(m)) {
    const double determinant = glm::determinant(linear);
    mirrors = determinant < 0.0;
    // Cofactors: the inverse transpose without its scale, so that a flat matrix is harmless.
    cofactor = glm::dmat3(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                          glm::cross(linear[0], linear[1]));
    if (mirrors) cofactor = -cofactor;
  }
  glm::dmat4 world;
  glm::dmat3 linear;
  glm::dmat3 cofactor;
  bool mirrors = false;
};

glm::vec3 unitOrZero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0F);
}

/// Which corner of a quad to cut from so that both halves lie inside it.
unsigned quadStart(const aiMesh& mesh, const aiFace& face) {
  const auto point = [&](unsigned i) {
    const aiVector3D& v = mesh.mVertices[face.mIndices[i & 3U]];
    return glm::dvec3(v.x, v.y, v.z);
  };
  const glm::dvec3 normal = glm::cross(point(2) - point(0), point(3) - point(1));
  for (unsigned i = 0; i < 4; ++i)
    if (glm::dot(glm::cross(point(i) - point(i + 3), point(i + 1) - point(i)), normal) < 0.0) return i;  // the dent
  return 0;
}

class Flattener {
 public:
  Flattener(const aiScene& scene, const FormatTraits& traits, std::string name)
      : m_scene(scene), m_traits(traits), m_name(std::move(name)), m_placement(placeMeshes(scene, traits.correction)) {}

  Result<RawMesh> run(Warnings& warnings, const std::stop_token& stop) {
    if (auto sized = reserve(); !sized) return tl::unexpected(sized.error());
    for (const Instance& instance : m_placement.instances) {
      if (stop.stop_requested()) return cancelledError();
      if (auto added = add(instance); !added) return tl::unexpected(added.error());
    }
    std::erase_if(m_out.runs, [](const RawMesh::Run& run) { return run.indexCount == 0; });
    if (m_out.runs.empty())
      return inputError(m_loose > 0
                            ? fmt::format("{}: the model holds only points and lines, and no surface to shade", m_name)
                            : fmt::format("{}: the model holds no triangles; export its mesh again", m_name));
    if (m_loose > 0)
      warnings.push_back(fmt::format("{}: {} points and lines are left out; only surfaces are shown", m_name, m_loose));
    if (m_repairedUvs > 0)
      warnings.push_back(
          fmt::format("{}: {} texture coordinates that are not finite numbers were set to 0", m_name, m_repairedUvs));
    if (m_repairedNormals > 0)
      warnings.push_back(
          fmt::format("{}: {} normals without a direction were computed anew", m_name, m_repairedNormals));
    return std::move(m_out);
  }

 private:
  Result<void> reserve() {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    bool tangents = false;
    for (const Instance& instance : m_placement.instances) {
      const aiMesh& mesh = *m_scene.mMeshes[instance.mesh];
      vertices += mesh.mNumVertices;
      triangles += mesh.mNumFaces;
      tangents = tangents || (m_traits.trustTangents && mesh.HasTangentsAndBitangents());
      if (vertices > kMostVertices || triangles > kMostVertices)
        return inputError(fmt::format("{}: the model has more than {} million vertices; reduce it first", m_name,
                                      kMostVertices / 1'000'000));
    }
    m_out.positions.reserve(vertices);
    m_out.normals.reserve(vertices);
    m_out.uvs.reserve(vertices);
    if (tangents) m_out.tangents.reserve(vertices);
    m_out.indices.reserve(triangles * 3);
    m_tangents = tangents;
    return {};
  }

  Result<void> add(const Instance& instance) {
    const aiMesh& mesh = *m_scene.mMeshes[instance.mesh];
    if (mesh.mVertices == nullptr || mesh.mNumVertices == 0 || mesh.mFaces == nullptr) return {};
    if (m_out.runs.empty() || m_out.runs.back().material != mesh.mMaterialIndex)
      m_out.runs.push_back({mesh.mMaterialIndex, static_cast<std::uint32_t>(m_out.indices.size()), 0,
                            static_cast<std::uint32_t>(m_out.positions.size()), 0});
    RawMesh::Run& run = m_out.runs.back();
    const Transform transform(instance.world);
    const auto base = static_cast<std::uint32_t>(m_out.positions.size());
    const std::vector<glm::dmat4> skin = skinMatrices(mesh, m_placement);

    if (auto placed = addVertices(mesh, instance.mesh, transform, skin); !placed) return placed;
    const bool mirrors = skin.empty() ? transform.mirrors : glm::determinant(glm::dmat3(skin.front())) < 0.0;
    if (auto faced = addFaces(mesh, instance.mesh, base, mirrors); !faced) return faced;
    run.indexCount = static_cast<std::uint32_t>(m_out.indices.size()) - run.firstIndex;
    run.vertexCount = static_cast<std::uint32_t>(m_out.positions.size()) - run.firstVertex;
    return {};
  }

  Result<void> addVertices(const aiMesh& mesh, unsigned index, const Transform& place,
                           const std::vector<glm::dmat4>& skin) {
    const bool identity = skin.empty() && place.world == glm::dmat4(1.0);
    const bool normals = m_traits.trustNormals && mesh.mNormals != nullptr;
    const aiVector3D* uvs = mesh.mTextureCoords[0];
    const bool tangents = m_tangents && mesh.HasTangentsAndBitangents();
    if (uvs != nullptr) m_out.anyUvs = true;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const Transform& transform = skin.empty() ? place : m_skinTransform.emplace(skin[i]);

      const aiVector3D& p = mesh.mVertices[i];
      glm::vec3 position(p.x, p.y, p.z);
      if (!identity) position = glm::vec3(transform.world * glm::dvec4(p.x, p.y, p.z, 1.0));
      // One comparison refuses NaN and infinity too.
      if (!(std::abs(position.x) <= kLargestCoordinate && std::abs(position.y) <= kLargestCoordinate &&
            std::abs(position.z) <= kLargestCoordinate))
        return inputError(fmt::format("{}: vertex {} of {} {}; repair the model where it was made", m_name, i,
                                      meshName(m_scene, index),
                                      finite(p) ? "lies too far out to be placed" : "is not a finite number"));
      m_out.positions.push_back(position + 0.0F);  // turns −0 into 0, so that equal points have equal bytes

      glm::vec3 normal(0.0F);
      if (normals) {
        const aiVector3D& n = mesh.mNormals[i];
        const glm::dvec3 given(n.x, n.y, n.z);
        normal = unitOrZero(identity ? given : transform.cofactor * given);
        if (normal == glm::vec3(0.0F)) ++m_repairedNormals;
      }
      if (normal == glm::vec3(0.0F)) m_out.normalsMissing = true;
      m_out.normals.push_back(normal + 0.0F);

      glm::vec2 uv(0.0F);
      if (uvs != nullptr) {
        uv = {uvs[i].x, uvs[i].y};
        constexpr float kLargestUv = 1e6F;
        if (!(std::abs(uv.x) <= kLargestUv && std::abs(uv.y) <= kLargestUv)) {
          uv = glm::vec2(0.0F);
          ++m_repairedUvs;
        }
      }
      m_out.uvs.push_back(uv + 0.0F);
      if (m_tangents) m_out.tangents.push_back(tangents ? tangent(mesh, i, transform) : glm::vec4(0.0F));
    }
    return {};
  }

  glm::vec4 tangent(const aiMesh& mesh, unsigned i, const Transform& transform) const {
    const aiVector3D& t = mesh.mTangents[i];
    const aiVector3D& b = mesh.mBitangents[i];
    const aiVector3D& n = mesh.mNormals[i];
    const glm::vec3 direction = unitOrZero(transform.linear * glm::dvec3(t.x, t.y, t.z));
    const double side =
        glm::dot(glm::cross(glm::dvec3(n.x, n.y, n.z), glm::dvec3(t.x, t.y, t.z)), glm::dvec3(b.x, b.y, b.z));
    if (direction == glm::vec3(0.0F) || !std::isfinite(side) || side == 0.0) return glm::vec4(0.0F);
    // A mirror turns normal × tangent round against the mirrored bitangent.
    return {direction + 0.0F, (side < 0.0) != transform.mirrors ? -1.0F : 1.0F};
  }

  Result<void> addFaces(const aiMesh& mesh, unsigned index, std::uint32_t base, bool mirrors) {
    const auto corner = [&](const aiFace& face, unsigned i) { m_out.indices.push_back(base + face.mIndices[i]); };
    const auto triangle = [&](const aiFace& face, unsigned a, unsigned b, unsigned c) {
      corner(face, a);
      corner(face, mirrors ? c : b);
      corner(face, mirrors ? b : c);
    };
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices < 3) {
        ++m_loose;
        continue;
      }
      for (unsigned i = 0; i < face.mNumIndices; ++i)
        if (face.mIndices[i] >= mesh.mNumVertices)
          return inputError(fmt::format(
              "{}: face {} of {} refers to vertex {}, but there are only {}; repair the model where it was made",
              m_name, f, meshName(m_scene, index), face.mIndices[i], mesh.mNumVertices));
      if (face.mNumIndices == 4) {
        const unsigned s = quadStart(mesh, face);
        triangle(face, s, (s + 1) & 3U, (s + 2) & 3U);
        triangle(face, s, (s + 2) & 3U, (s + 3) & 3U);
      } else {
        for (unsigned i = 1; i + 1 < face.mNumIndices; ++i) triangle(face, 0, i, i + 1);
      }
    }
    return {};
  }

  const aiScene& m_scene;
  FormatTraits m_traits;
  std::string m_name;
  Placement m_placement;
  RawMesh m_out;
  std::optional<Transform> m_skinTransform;
  bool m_tangents = false;
  std::size_t m_loose = 0, m_repairedUvs = 0, m_repairedNormals = 0;
};

}  // namespace

Result<RawMesh> flattenScene(const aiScene& scene, const FormatTraits& traits, const std::string& name,
                             Warnings& warnings, const std::stop_token& stop) {
  if (scene.mRootNode == nullptr) return inputError(fmt::format("{}: the model is empty; export it again", name));
  return Flattener(scene, traits, name).run(warnings, stop);
}

}  // namespace dermis::import
