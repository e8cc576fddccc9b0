// Asks the GPU what shading would read: environment and DFG lookups at places of the caller's choice.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "gl/shader_library.h"
#include "lighting/dfg_quadrature.h"
#include "lighting/environment_map.h"

namespace dermis {

/// One lookup through lighting/environment.glsl or dfg.glsl.
struct LightingQuery {
  glm::vec4 value{0.0F};

  [[nodiscard]] static LightingQuery prefiltered(const glm::vec3& direction, float perceptualRoughness) {
    return {glm::vec4(direction, perceptualRoughness)};
  }
  [[nodiscard]] static LightingQuery irradiance(const glm::vec3& direction) { return {glm::vec4(direction, -1.0F)}; }
  [[nodiscard]] static LightingQuery sharp(const glm::vec3& direction) { return {glm::vec4(direction, -2.0F)}; }
  [[nodiscard]] static LightingQuery dfg(DfgGeometry geometry, float cosine, float perceptualRoughness) {
    return {glm::vec4(cosine, perceptualRoughness, 0.0F, geometry == DfgGeometry::Smith ? -3.0F : -4.0F)};
  }
};

/// Answers in the queries' order: radiance (irradiance / π), or scale and bias. Needs a current context; `map` may be
/// null where only tables are asked for. Errors: Runtime, a shader that doesn't compile.
[[nodiscard]] Result<std::vector<glm::vec3>> probeLighting(gl::ShaderLibrary& shaders, const EnvironmentMap* map,
                                                           std::span<const LightingQuery> queries,
                                                           float rotationDegrees = 0.0F, float exposureStops = 0.0F);

}  // namespace dermis
