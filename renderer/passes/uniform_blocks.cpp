#include "passes/uniform_blocks.h"

#include <algorithm>
#include <cmath>

namespace dermis {

bool isAnimated(const Light& light) {
  return light.enabled && light.animation.kind != AnimationKind::None && light.animation.speed != 0.0F;
}

Light animated(const Light& light, double seconds) {
  Light moved = light;
  const auto angle =
      static_cast<float>(std::fmod(static_cast<double>(light.animation.speed) * seconds, 6.283185307179586));
  switch (light.animation.kind) {
    case AnimationKind::None:
      break;
    case AnimationKind::Sway:
      moved.position.x += light.animation.amplitude * std::sin(angle);
      break;
    case AnimationKind::Orbit: {
      const glm::vec3 p = light.position * glm::vec3(light.animation.amplitude, 1.0F, light.animation.amplitude);
      const glm::vec3 d = light.direction;
      const float c = std::cos(angle);
      const float s = std::sin(angle);
      moved.position = {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
      moved.direction = {c * d.x + s * d.z, d.y, c * d.z - s * d.x};
      break;
    }
  }
  return moved;
}

void packLights(FrameBlock& block, std::span<const Light> lights, float millimetresPerUnit, double seconds) {
  int count = 0;
  for (const Light& source : lights) {
    if (!source.enabled || count == static_cast<int>(kMaxLights)) continue;
    const Light light = animated(source, seconds);
    const float length = glm::length(light.direction);
    const glm::vec3 direction = length > 0.0F ? light.direction / length : glm::vec3(0.0F, 0.0F, -1.0F);
    LightBlock& out = block.lights.at(static_cast<std::size_t>(count++));
    out.positionType = {light.position, static_cast<float>(light.type)};
    out.directionOuter = {direction, std::cos(glm::radians(light.outerDegrees))};
    out.radiantInner = {light.color * light.intensity, std::cos(glm::radians(light.innerDegrees))};
    out.size = {light.radiusMm / millimetresPerUnit, 0.5F * light.sizeMm.x / millimetresPerUnit,
                0.5F * light.sizeMm.y / millimetresPerUnit, 0.0F};
  }
  block.lightCount = {count, 0, 0, 0};
}

SampleBlock packSample(int index, int targetSamples, bool moving, bool withoutSubsurface) {
  // Powers of 1/g, with g⁵ = g + 1.
  constexpr double kG = 1.1673039782614187;
  SampleBlock block;
  block.sampling = {index, moving ? 1 : 0, withoutSubsurface ? 1 : 0, moving ? 1 : targetSamples};
  double step = 1.0;
  for (int i = 0; i < 4; ++i) {
    step /= kG;
    const double value = 0.5 + step * index;
    block.random[i] = static_cast<float>(value - std::floor(value));
  }
  return block;
}

void packPoint(LightBlock& block, const LightPoint& point) {
  block.positionType = {point.position, static_cast<float>(point.type)};
  block.directionOuter = {point.direction, block.directionOuter.w};
  block.radiantInner = {point.intensityScale * glm::vec3(block.radiantInner), block.radiantInner.w};
  block.size.w = point.spread;
}

void packEyes(DrawBlock& block, std::span<const Eyeball> eyes, bool hasShell) {
  const std::size_t count = std::min(eyes.size(), kMostEyeballs);
  block.eyeCount = {static_cast<int>(count), hasShell ? 1 : 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    block.eyeCentre.at(i) = {eyes[i].centre, eyes[i].radius};
    block.eyeAxis.at(i) = {eyes[i].axis, 0.0F};
    block.eyeUv.at(i) = eyes[i].uvGradient;
  }
}

MapBlock packMap(TextureSlot slot, const TextureBinding& binding) {
  MapBlock map;
  switch (binding.channel) {
    case TextureChannel::R:
      map.channel = {1.0F, 0.0F, 0.0F, 0.0F};
      break;
    case TextureChannel::G:
      map.channel = {0.0F, 1.0F, 0.0F, 0.0F};
      break;
    case TextureChannel::B:
      map.channel = {0.0F, 0.0F, 1.0F, 0.0F};
      break;
    case TextureChannel::A:
      map.channel = {0.0F, 0.0F, 0.0F, 1.0F};
      break;
    case TextureChannel::Luminance:
      map.channel = {0.2126F, 0.7152F, 0.0722F, 0.0F};
      break;
  }
  // scale · (1 − x) = −scale · x + scale. A normal map has nothing to invert.
  const bool isNormal = slot == TextureSlot::Normal || slot == TextureSlot::DetailNormal;
  const bool invert = binding.invert && !isNormal;
  map.transform = {invert ? -binding.scale : binding.scale, invert ? binding.scale : 0.0F, binding.uvScale[0],
                   binding.uvScale[1]};
  return map;
}

}  // namespace dermis
