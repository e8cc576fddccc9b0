// Tangents from texture coordinates.
#pragma once

#include "core/scene/model.h"

namespace dermis {

/// Completes tangents (w = 0 where there is none): along +u, bitangent w · cross(n, t) along +v, angle-weighted over
/// the vertex's triangles; a vertex that mirrored UVs share is split. Without UVs, any frame about the normal. After
/// Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited", §3.3, but grouping by welded vertex.
void completeTangents(Model& model);

}  // namespace dermis
