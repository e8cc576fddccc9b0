#include "import/model_loader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>

#include "core/base/file_io.h"
#include "core/base/lower_case.h"
#include "core/scene/tangents.h"
#include "import/gltf_check.h"
#include "import/mesh_math.h"
#include "import/model_checks.h"
#include "import/model_io.h"
#include "import/model_materials.h"
#include "import/model_units.h"
#include "import/raw_mesh.h"
#include "import/text.h"

namespace dermis::import {
namespace {

namespace fs = std::filesystem;

/// What we don't use costs time and is one more place to go wrong.
void configure(Assimp::Importer& importer) {
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_CAMERAS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_LIGHTS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
}

bool hasPolygons(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f)
      if (scene.mMeshes[m]->mFaces[f].mNumIndices > 4) return true;
  return false;
}

/// The scene with polygons of five and more corners cut up (Assimp's ear clipping; smaller ones we cut ourselves).
Result<const aiScene*> parse(Assimp::Importer& importer, const fs::path& path, const std::string& name,
                             const std::stop_token& stop) {
  const aiScene* scene = nullptr;
  std::string message;
  try {
    scene = importer.ReadFile(path.string(), 0);
    if (scene == nullptr) message = importer.GetErrorString();
    if (scene != nullptr && hasPolygons(*scene)) {
      if (auto checked = checkScene(*scene, name); !checked) return tl::unexpected(checked.error());
      scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
      if (scene == nullptr) message = "its polygons cannot be cut into triangles";
    }
  } catch (const std::bad_alloc&) {
    scene = nullptr;
    message = "there is not enough memory, or the file promises more than it holds";
  } catch (const std::exception& error) {
    scene = nullptr;
    message = error.what();
  }
  if (stop.stop_requested()) return cancelledError();
  if (scene == nullptr) {
    message = phrase(message);
    return inputError(fmt::format("{}: not readable as a model ({}); export it again, as glTF or OBJ for instance",
                                  name, message.empty() ? "the parser gives no reason" : message));
  }
  return scene;
}

}  // namespace

Result<Model> loadModel(const fs::path& path, const std::stop_token& stop) try {
  const std::string name = path.filename().string();
  const std::string format = lowerCase(path.extension().string());
  if (stop.stop_requested()) return cancelledError();

  // Read the file once, and refuse what can be seen to be wrong before a parser gets to see it.
  auto bytes = readFile(path, kLargestModelBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const bool gltf = format == ".gltf" || format == ".glb" || format == ".vrm";
  fs::path parsedName = path;
  if (gltf) {
    bytes = checkedGltf(*bytes, path);
    if (!bytes) return tl::unexpected(bytes.error());
    parsedName.replace_extension(".glb");
  } else if (auto checked = checkModelBytes(*bytes, path); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto shared = std::make_shared<const std::string>(std::move(*bytes));

  // Parse. Assimp owns the handlers and the scene.
  Assimp::Importer importer;
  configure(importer);
  importer.SetIOHandler(new ModelFiles(parsedName, shared, stop));
  importer.SetProgressHandler(new StopWatcher(stop));
  const auto scene = parse(importer, parsedName, name, stop);
  if (!scene) return tl::unexpected(scene.error());

  // Flatten, and make what is missing.
  Model model;
  const FormatTraits traits = {
      .trustNormals = format != ".stl", .trustTangents = gltf, .correction = correction(**scene, format, *shared)};
  auto raw = flattenScene(**scene, traits, name, model.warnings, stop);
  if (!raw) return tl::unexpected(raw.error());
  const bool separated = completeNormals(*raw);
  if (stop.stop_requested()) return cancelledError();
  model.hasUvs = raw->anyUvs;
  std::vector<unsigned> materials;
  for (const RawMesh::Run& run : raw->runs) materials.push_back(run.material);
  // glTF comes indexed: its author's vertices are kept as they are.
  const std::size_t dropped = weldInto(std::move(*raw), !gltf || separated, model);
  if (model.indices.empty())
    return inputError(fmt::format("{}: none of the model's {} triangles has any area", name, dropped));
  if (dropped > 0) model.warnings.push_back(fmt::format("{}: {} triangles without area are left out", name, dropped));
  if (stop.stop_requested()) return cancelledError();
  completeTangents(model);

  // Materials, extent and unit.
  addSlots(model, **scene, materials, {path.parent_path().empty() ? fs::path(".") : path.parent_path(), name, gltf});
  for (const glm::vec3& position : model.positions) model.bounds.grow(position);
  findUnit(model, **scene, format, *shared);
  return model;
} catch (const std::bad_alloc&) {
  return runtimeError(fmt::format("{}: there is not enough memory for this model", path.filename().string()));
} catch (const std::exception& error) {
  return inputError(fmt::format("{}: the model cannot be read ({})", path.filename().string(), phrase(error.what())));
}

}  // namespace dermis::import
