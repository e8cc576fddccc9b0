#include "import/model_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/lower_case.h"
#include "import/ply_check.h"
#include "import/text.h"

namespace dermis::import {
namespace {

constexpr int kDeepestNesting = 400;

/// COLLADA and other XML: elements open inside each other.
int xmlDepth(std::string_view text) {
  int depth = 0, deepest = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos && at + 1 < text.size();
       at = text.find('<', at + 1)) {
    const char next = text[at + 1];
    if (next == '/') {
      --depth;
    } else if (next != '!' && next != '?') {
      const std::size_t end = text.find('>', at);
      if (end == std::string_view::npos || text[end - 1] != '/') deepest = std::max(deepest, ++depth);
    }
  }
  return deepest;
}

/// FBX as text, X files and the like: braces. Binary files have no such depth.
int braceDepth(std::string_view text) {
  if (text.substr(0, 1024).find('\0') != std::string_view::npos) return 0;
  int depth = 0, deepest = 0;
  for (const char c : text) {
    if (c == '{') deepest = std::max(deepest, ++depth);
    if (c == '}') --depth;
  }
  return deepest;
}

}  // namespace

Result<void> checkModelBytes(std::string_view bytes, const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::string format = lowerCase(path.extension().string());
  if (bytes.empty()) return inputError(fmt::format("{}: the model file is empty; export it again", name));
  int depth = 0;
  if (format == ".dae" || format == ".x3d" || format == ".xml" || format == ".amf")
    depth = xmlDepth(bytes);
  else if (format == ".fbx" || format == ".x" || format == ".ase" || format == ".ogex" || format == ".wrl")
    depth = braceDepth(bytes);
  if (depth > kDeepestNesting)
    return inputError(fmt::format("{}: its elements lie {} levels deep in each other, past the limit of {}", name,
                                  depth, kDeepestNesting));
  if (format == ".ply") return checkPly(bytes, name);
  return {};
}

Result<void> checkScene(const aiScene& scene, const std::string& name) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
      for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i)
        if (mesh.mFaces[f].mIndices[i] >= mesh.mNumVertices)
          return inputError(fmt::format(
              "{}: face {} of mesh {} refers to vertex {}, but there are only {}; repair the model where it was made",
              name, f, m, mesh.mFaces[f].mIndices[i], mesh.mNumVertices));
  }
  return {};
}

}  // namespace dermis::import
