#include "passes/sky_pass.h"

#include <algorithm>
#include <numbers>

namespace dermis {

namespace {

constexpr float kHalfMaximum = 65504.0F;
constexpr int kLampVertices = 64 * 32 * 6;  // as in lamps.vert

bool isShownAsSphere(const Light& light) {
  return light.enabled && light.visible && light.type != LightType::Directional && light.radiusMm > 0.0F;
}

bool isSky(const FrameContext& frame) {
  const BackgroundKind kind = frame.scene.scene.environment.background.kind;
  return kind != BackgroundKind::Color && kind != BackgroundKind::None && frame.resources.environment() != nullptr;
}

}  // namespace

glm::vec4 backgroundClearColour(const FrameContext& frame) {
  const Background& background = frame.scene.scene.environment.background;
  if (background.kind == BackgroundKind::None) return glm::vec4(0.0F);
  if (background.kind == BackgroundKind::Color) return {background.color, 1.0F};
  return {0.0F, 0.0F, 0.0F, 1.0F};
}

void skyPass(const FrameContext& frame) {
  if (!isSky(frame)) return;
  const Background& background = frame.scene.scene.environment.background;
  const int kind = background.kind == BackgroundKind::Irradiance    ? 1
                   : background.kind == BackgroundKind::Prefiltered ? 2
                                                                    : 0;
  gl::ProgramSources sources;
  sources.vertex = "full_screen.vert";
  sources.fragment = "sky.frag";
  sources.defines = {"DERMIS_BACKGROUND " + std::to_string(kind)};
  const gl::Program* program = frame.useProgram(sources);
  if (program == nullptr) return;
  glUniform1f(program->uniform("u_perceptual_roughness"), background.perceptualRoughness);
  glUniform1f(program->uniform("u_maximum"), frame.targets.precise() ? 3.4e38F : kHalfMaximum);
  // At the far plane of the reversed depth: passes where nothing was drawn.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  gl::drawFullScreen();
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_GREATER);
}

bool hasVisibleLamps(const ResolvedScene& scene) {
  return std::any_of(scene.scene.lights.begin(), scene.scene.lights.end(), isShownAsSphere);
}

void lampPass(const FrameContext& frame) {
  gl::ProgramSources sources;
  sources.vertex = "lamps.vert";
  sources.fragment = "lamps.frag";
  const gl::Program* program = frame.useProgram(sources);
  if (program == nullptr) return;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  const float most = frame.targets.precise() ? 3.4e38F : kHalfMaximum;
  for (const Light& source : frame.scene.scene.lights) {
    if (!isShownAsSphere(source)) continue;
    const Light light = animated(source, frame.request.seconds);
    const float radius = light.radiusMm / frame.scene.millimetresPerUnit;
    const glm::vec3 radiance = light.color * light.intensity / (std::numbers::pi_v<float> * radius * radius);
    const glm::vec3 held = glm::min(radiance, glm::vec3(most));
    glUniform4f(program->uniform("u_sphere"), light.position.x, light.position.y, light.position.z, radius);
    glUniform3f(program->uniform("u_radiance"), held.r, held.g, held.b);
    glDrawArrays(GL_TRIANGLES, 0, kLampVertices);
  }
}

}  // namespace dermis
