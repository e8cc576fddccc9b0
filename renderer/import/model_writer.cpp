#include "import/model_writer.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Exporter.hpp>
#include <memory>
#include <unordered_map>

#include "core/base/file_io.h"
#include "core/base/lower_case.h"
#include "import/text.h"

namespace dermis::import {
namespace {

struct Format {
  const char* extension;
  const char* id;  ///< Assimp's
  float millimetres;
};
constexpr std::array kFormats = {Format{".glb", "glb2", 1000.0F}, Format{".obj", "obj", 1.0F},
                                 Format{".ply", "plyb", 1.0F}, Format{".stl", "stlb", 1.0F}};

aiVector3D vectorOf(const glm::vec3& v) { return {v.x, v.y, v.z}; }

/// The vertices that a part uses and its triangles. The scene's arrays are freed by aiMesh.
std::unique_ptr<aiMesh> meshOf(const Model& model, const ModelPart& part, float scale) {
  std::vector<std::uint32_t> used;
  std::unordered_map<std::uint32_t, unsigned> place;
  std::vector<unsigned> corners;
  corners.reserve(part.indexCount);
  for (std::uint32_t i = 0; i < part.indexCount; ++i) {
    const std::uint32_t vertex = model.indices[part.firstIndex + i];
    const auto [found, isNew] = place.try_emplace(vertex, static_cast<unsigned>(used.size()));
    if (isNew) used.push_back(vertex);
    corners.push_back(found->second);
  }
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName = model.slots[part.slot].name;
  mesh->mMaterialIndex = part.slot;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = static_cast<unsigned>(used.size());
  mesh->mVertices = new aiVector3D[used.size()];
  mesh->mNormals = new aiVector3D[used.size()];
  if (model.hasUvs) {
    mesh->mTextureCoords[0] = new aiVector3D[used.size()];
    mesh->mNumUVComponents[0] = 2;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    mesh->mVertices[i] = vectorOf(model.positions[used[i]] * scale);
    mesh->mNormals[i] = vectorOf(model.normals[used[i]]);
    if (model.hasUvs) mesh->mTextureCoords[0][i] = vectorOf(glm::vec3(model.uvs[used[i]], 0.0F));
  }
  mesh->mNumFaces = part.indexCount / 3;
  mesh->mFaces = new aiFace[mesh->mNumFaces];
  for (unsigned face = 0; face < mesh->mNumFaces; ++face) {
    mesh->mFaces[face].mNumIndices = 3;
    mesh->mFaces[face].mIndices = new unsigned[3];
    for (unsigned k = 0; k < 3; ++k) mesh->mFaces[face].mIndices[k] = corners[3 * face + k];
  }
  return mesh;
}

std::unique_ptr<aiScene> sceneOf(const Model& model, float scale) {
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode("model");
  scene->mNumMaterials = static_cast<unsigned>(model.slots.size());
  scene->mMaterials = new aiMaterial*[model.slots.size()]();
  for (std::size_t i = 0; i < model.slots.size(); ++i) {
    const aiString name(model.slots[i].name);
    scene->mMaterials[i] = new aiMaterial;
    scene->mMaterials[i]->AddProperty(&name, AI_MATKEY_NAME);
  }
  scene->mNumMeshes = static_cast<unsigned>(model.parts.size());
  scene->mMeshes = new aiMesh*[model.parts.size()]();
  scene->mRootNode->mNumMeshes = scene->mNumMeshes;
  scene->mRootNode->mMeshes = new unsigned[model.parts.size()];
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    scene->mMeshes[i] = meshOf(model, model.parts[i], scale).release();
    scene->mRootNode->mMeshes[i] = static_cast<unsigned>(i);
  }
  return scene;
}

/// Assimp calls the files of one export by this name.
std::string withStem(std::string text, const std::string& stem) {
  constexpr std::string_view kBlob = "$blobfile";
  const std::size_t at = text.find(kBlob);
  if (at != std::string::npos) text.replace(at, kBlob.size(), stem);
  return text;
}

}  // namespace

Result<void> writeModel(const std::filesystem::path& path, const Model& model) try {
  const std::string name = path.filename().string();
  const std::string extension = lowerCase(path.extension().string());
  const auto* const format =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& row) { return extension == row.extension; });
  if (format == kFormats.end())
    return runtimeError(
        fmt::format("{}: models are written as .glb, .obj, .ply or .stl; choose one of these endings", path.string()));
  const std::unique_ptr<aiScene> scene = sceneOf(model, model.millimetresPerUnit / format->millimetres);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), format->id);
  if (blob == nullptr)
    return runtimeError(fmt::format("{}: the model cannot be written ({})", name, phrase(exporter.GetErrorString())));
  // The first is the model itself, further ones are known by their extensions. They go first: a model without its
  // materials must not appear.
  const std::string stem = path.stem().string();
  for (const aiExportDataBlob* side = blob->next; side != nullptr; side = side->next) {
    const std::filesystem::path file = std::filesystem::path(path).replace_extension(side->name.C_Str());
    if (auto written = writeFileAtomically(file, {static_cast<const char*>(side->data), side->size}); !written)
      return written;
  }
  const std::string_view bytes(static_cast<const char*>(blob->data), blob->size);
  return extension == ".obj" ? writeFileAtomically(path, withStem(std::string(bytes), stem))
                             : writeFileAtomically(path, bytes);
} catch (const std::bad_alloc&) {
  return runtimeError(fmt::format("{}: there is not enough memory to write this model", path.filename().string()));
} catch (const std::exception& error) {
  return runtimeError(
      fmt::format("{}: the model cannot be written ({})", path.filename().string(), phrase(error.what())));
}

}  // namespace dermis::import
