// The C++ twins of frame_block.glsl and draw_block.glsl, byte for byte (std140).
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>

#include "core/material/texture_slot.h"
#include "core/scene/eyeballs.h"
#include "core/scene/scene.h"
#include "lighting/light_point.h"

namespace dermis {

inline constexpr unsigned kFrameBinding = 0, kMaterialBinding = 1, kDrawBinding = 2, kSampleBinding = 5;

struct LightBlock {
  glm::vec4 positionType{0.0F};
  glm::vec4 directionOuter{0.0F};
  glm::vec4 radiantInner{0.0F};
  glm::vec4 size{0.0F};
};

struct FrameBlock {
  glm::mat4 view{1.0F}, projection{1.0F}, viewProjection{1.0F}, inverseViewProjection{1.0F};
  glm::vec4 cameraPosition{0.0F};
  glm::vec4 cameraForward{0.0F};
  glm::mat4 environmentFromWorld{1.0F};
  glm::vec4 environmentScale{1.0F};
  glm::vec4 viewport{1.0F};
  glm::ivec4 lightCount{0};
  glm::vec4 units{1.0F};
  std::array<LightBlock, kMaxLights> lights{};
  std::array<glm::vec4, 9> environmentHarmonics{};
};
static_assert(sizeof(LightBlock) == 64);
static_assert(sizeof(FrameBlock) == 416 + kMaxLights * sizeof(LightBlock) + 9 * 16);

struct SampleBlock {
  glm::ivec4 sampling{0};
  glm::vec4 random{0.5F};
  glm::vec4 window{0.0F};
};

struct MapBlock {
  glm::vec4 channel{1.0F, 0.0F, 0.0F, 0.0F};
  glm::vec4 transform{1.0F, 0.0F, 1.0F, 1.0F};
};

struct DrawBlock {
  std::array<MapBlock, kTextureSlotCount> maps{};
  glm::ivec4 mapBits{0};
  glm::vec4 scattering{0.0F};
  glm::vec4 meanAlbedo{0.0F};
  glm::ivec4 eyeCount{0};
  std::array<glm::vec4, kMostEyeballs> eyeCentre{}, eyeAxis{}, eyeUv{};
  std::array<std::array<std::uint32_t, 4>, kTextureSlotCount> mapTiles{};
};
static_assert(sizeof(DrawBlock) == kTextureSlotCount * 48 + 64 + 3 * kMostEyeballs * 16);

template <class Block>
[[nodiscard]] std::span<const std::byte> bytesOf(const Block& block) {
  return std::as_bytes(std::span<const Block, 1>(&block, 1));
}

/// What sample `index` of a still picture is drawn with, or a moving picture's only one: four numbers of the R4
/// sequence (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences").
[[nodiscard]] SampleBlock packSample(int index, int targetSamples, bool moving, bool withoutSubsurface);

/// Where a lamp is at `seconds`: sway moves it along x by amplitude · sin(speed · t), as the published code does; orbit
/// turns it about the world's y axis at `speed` radians a second, its distance from the axis multiplied by the
/// amplitude.
[[nodiscard]] Light animated(const Light& light, double seconds);
[[nodiscard]] bool isAnimated(const Light& light);

/// Fills lights and lightCount: enabled lights in order, at most sixteen.
void packLights(FrameBlock& block, std::span<const Light> lights, float millimetresPerUnit, double seconds);

/// Makes a packed light shine from where it does in this picture or sample.
void packPoint(LightBlock& block, const LightPoint& point);

/// Fills the block's eyes; `hasShell`: another part is the cornea.
void packEyes(DrawBlock& block, std::span<const Eyeball> eyes, bool hasShell);

/// How a slot's map is read: channel weights, and scale and invert folded into one multiply-add.
[[nodiscard]] MapBlock packMap(TextureSlot slot, const TextureBinding& binding);

}  // namespace dermis
