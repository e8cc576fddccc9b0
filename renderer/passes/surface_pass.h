// The model: opaque parts first, blended ones after the sky.
#pragma once

#include <string>
#include <vector>

#include "passes/frame_context.h"

namespace dermis {

/// What a surface's program writes: surface.frag says which is which.
enum class SurfaceOutputs { Picture, Split, Everything, BlendedEverything };
/// Of a scene's opaque or blended parts.
[[nodiscard]] SurfaceOutputs surfaceOutputs(const ResolvedScene& scene, bool withAovs, bool blended);
/// Whether light diffuses in some opaque part, so that what enters and what leaves are kept apart.
[[nodiscard]] bool isSplit(const ResolvedScene& scene);

/// The program of a shading model. `constantMaps` are the bits of the maps that are there (material_maps.glsl); without
/// them the program asks a uniform.
[[nodiscard]] gl::ProgramSources surfaceProgram(ShadingModel model, SurfaceOutputs outputs,
                                                std::optional<int> constantMaps = std::nullopt);

/// As a define: the maps that are there, for programs that know them.
[[nodiscard]] std::string mapsDefine(int maps);

/// Without the lamps' part of lights.glsl where none is lit.
[[nodiscard]] gl::ProgramSources forLampsOf(gl::ProgramSources sources, const ResolvedScene& scene);

/// Opaque parts, depth tested and written.
void surfacePass(const FrameContext& frame);

/// The same in two steps, for software GL, where a small triangle costs as much as sixteen pixels: geometry first, then
/// each pixel is shaded once. A still picture is the one that surfacePass draws, but for rounding; a moving one takes
/// short cuts (DERMIS_MOVING), and its maps are a touch blurred along silhouettes and seams.
void geometryPass(const FrameContext& frame);
void shadingPass(const FrameContext& frame);
/// Whether that is possible (few opaque slots, no cut-outs) and pays (many triangles).
[[nodiscard]] bool deferringPays(const ResolvedScene& scene);
/// Their programs, of a slot, with its present maps as a constant.
[[nodiscard]] gl::ProgramSources geometryProgram(bool moving, bool displaced);
[[nodiscard]] gl::ProgramSources deferredProgram(const ResolvedScene& scene, std::size_t slot, bool moving,
                                                 SurfaceOutputs outputs);

/// Lenses and blended materials, premultiplied over what is there, far ones first. A blended part shows its back faces,
/// then its front ones; its own triangles are not sorted further.
void transparentPass(const FrameContext& frame);
[[nodiscard]] bool hasTransparentParts(const SceneResources& resources);
/// The rectangles that they lie in.
[[nodiscard]] std::vector<PixelArea> transparentAreas(const FrameContext& frame);

}  // namespace dermis
