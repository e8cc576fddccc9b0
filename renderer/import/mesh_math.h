// What every mesh needs before it can be shaded, but for tangents: normals, one vertex for equal corners.
#pragma once

#include "core/scene/model.h"
#include "import/raw_mesh.h"

namespace dermis::import {

/// Fills in missing normals (zero or not finite): angle-weighted over all faces that share the position, across groups,
/// materials and UV seams, but not over edges where faces are turned by more than 80° against each other, which stay
/// sharp. Weights: Thürmer & Wüthrich 1998, "Computing Vertex Normals from Polygonal Facets". Returns whether there are
/// such edges: then every corner has become a vertex of its own, to be merged.
[[nodiscard]] bool completeNormals(RawMesh& mesh);

/// Moves the mesh into the model, slot by slot: triangles without area and unused vertices dropped, vertices in the
/// order of first use, equal ones merged where `merge` is set. Returns how many triangles were dropped.
std::size_t weldInto(RawMesh&& mesh, bool merge, Model& model);

}  // namespace dermis::import
