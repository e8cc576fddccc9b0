// What `dermis bake environment` and `dermis bake dfg` write: the light as the renderer samples it.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/scene/resolved_scene.h"
#include "lighting/dfg_quadrature.h"
#include "lighting/environment_bake.h"

namespace dermis {

/// Size of the lat-long images of readBackEnvironment.
inline constexpr int kReadbackWidth = 512, kReadbackHeight = 256;

struct EnvironmentReadback {
  Image irradiance;                                ///< Float RGB lat-long, irradiance / π
  std::vector<Image> prefiltered;                  ///< the same of each roughness asked for, radiance
  std::array<glm::dvec3, 9> sphericalHarmonics{};  ///< see spherical_harmonics.h; from the image itself, exactly
  EnvironmentFigures figures;
  double readbackMs = 0.0;
};

/// Bakes the environment (through the disk cache, where options name one), uploads it, and reads it back at the texel
/// centres of lat-long images through the functions of environment.glsl. Needs a current OpenGL 4.5 context.
/// Errors: Runtime.
[[nodiscard]] Result<EnvironmentReadback> readBackEnvironment(const std::shared_ptr<const EnvironmentImages>& images,
                                                              std::span<const float> perceptualRoughnesses,
                                                              const EnvironmentBakeOptions& options,
                                                              Warnings& warnings);

/// size × size RGB floats: x = N·V, y = perceptual roughness at texel centres, first row lowest; R scale, G bias, B 0.
/// Read through dfg.glsl. Needs a current OpenGL 4.5 context. Errors: Runtime.
[[nodiscard]] Result<Image> readBackDfg(DfgGeometry geometry, int size = 128);

}  // namespace dermis
