// The bytes that C++ packs lie where GL says that the linked programs read them.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "core/material/parameter_table.h"
#include "gpu/gl_fixture.h"
#include "passes/subsurface_pass.h"
#include "passes/surface_pass.h"
#include "passes/uniform_blocks.h"

namespace dermis::test {
namespace {

class FrameBlocks : public GlTest {
 protected:
  /// Offset of a member, −1 where the program doesn't know it.
  static GLint offsetOf(const gl::Program& program, const std::string& name) {
    const GLuint index = glGetProgramResourceIndex(program.id(), GL_UNIFORM, name.c_str());
    if (index == GL_INVALID_INDEX) return -1;
    const GLenum property = GL_OFFSET;
    GLint offset = -1;
    glGetProgramResourceiv(program.id(), GL_UNIFORM, index, 1, &property, 1, nullptr, &offset);
    return offset;
  }
  /// Size and binding of a block; zero and −1 where the program has none of that name.
  static std::array<GLint, 2> sizeAndBinding(const gl::Program& program, const char* block) {
    const GLuint index = glGetProgramResourceIndex(program.id(), GL_UNIFORM_BLOCK, block);
    if (index == GL_INVALID_INDEX) return {0, -1};
    const std::array<GLenum, 2> properties = {GL_BUFFER_DATA_SIZE, GL_BUFFER_BINDING};
    std::array<GLint, 2> values{};
    glGetProgramResourceiv(program.id(), GL_UNIFORM_BLOCK, index, 2, properties.data(), 2, nullptr, values.data());
    return values;
  }
  const gl::Program& programOf(ShadingModel model) {
    auto program = m_shaders.program(surfaceProgram(model, SurfaceOutputs::Picture));
    EXPECT_TRUE(program.has_value()) << program.error().message;
    return **program;
  }
  gl::ShaderLibrary m_shaders;
};

TEST_F(FrameBlocks, MaterialBlockHasEveryRowWhereTheTableSays) {
  int programs = 0;
  for (const ShadingModelRow& model : shadingModels()) {
    const gl::Program& program = programOf(model.model);
    const auto [size, binding] = sizeAndBinding(program, "MaterialBlock");
    if (binding < 0) continue;  // `reflection` has no parameters
    ++programs;
    EXPECT_EQ(binding, static_cast<GLint>(kMaterialBinding));
    EXPECT_EQ(size, static_cast<GLint>(materialBlockSize())) << model.id;
    for (const ParameterRow& row : parameterTable()) {
      std::string name = "MaterialBlock." + row.glslName;
      if (row.type == ParameterType::Gaussians) name += "[0]";
      EXPECT_EQ(offsetOf(program, name), static_cast<GLint>(row.std140Offset)) << model.id << ": " << row.id;
    }
  }
  EXPECT_GE(programs, 6);
}

TEST_F(FrameBlocks, FrameBlockMatchesItsTwin) {
  const gl::Program& program = programOf(ShadingModel::Thesis);
  const auto [size, binding] = sizeAndBinding(program, "FrameBlock");
  EXPECT_EQ(binding, static_cast<GLint>(kFrameBinding));
  EXPECT_EQ(size, static_cast<GLint>(sizeof(FrameBlock)));
  const auto at = [&](const char* name, std::size_t offset) {
    EXPECT_EQ(offsetOf(program, name), static_cast<GLint>(offset)) << name;
  };
  at("u_view", offsetof(FrameBlock, view));
  at("u_projection", offsetof(FrameBlock, projection));
  at("u_view_projection", offsetof(FrameBlock, viewProjection));
  at("u_inverse_view_projection", offsetof(FrameBlock, inverseViewProjection));
  at("u_camera_position", offsetof(FrameBlock, cameraPosition));
  at("u_camera_forward", offsetof(FrameBlock, cameraForward));
  at("u_environment_from_world", offsetof(FrameBlock, environmentFromWorld));
  at("u_environment_scale", offsetof(FrameBlock, environmentScale));
  at("u_viewport", offsetof(FrameBlock, viewport));
  at("u_light_count", offsetof(FrameBlock, lightCount));
  at("u_units", offsetof(FrameBlock, units));
  const std::size_t lights = offsetof(FrameBlock, lights);
  at("u_lights[0].position_type", lights + offsetof(LightBlock, positionType));
  at("u_lights[0].direction_outer", lights + offsetof(LightBlock, directionOuter));
  at("u_lights[0].radiant_inner", lights + offsetof(LightBlock, radiantInner));
  at("u_lights[0].size", lights + offsetof(LightBlock, size));
  at("u_lights[15].size", lights + 15 * sizeof(LightBlock) + offsetof(LightBlock, size));
  at("u_environment_harmonics[0]", offsetof(FrameBlock, environmentHarmonics));
}

TEST_F(FrameBlocks, SampleBlockMatchesItsTwin) {
  auto program = m_shaders.program(subsurfacePrograms(DiffusionQuality::Disc, 1).front());
  ASSERT_TRUE(program.has_value()) << program.error().message;
  const auto [size, binding] = sizeAndBinding(**program, "SampleBlock");
  EXPECT_EQ(binding, static_cast<GLint>(kSampleBinding));
  EXPECT_EQ(size, static_cast<GLint>(sizeof(SampleBlock)));
  EXPECT_EQ(offsetOf(**program, "u_sampling"), static_cast<GLint>(offsetof(SampleBlock, sampling)));
  EXPECT_EQ(offsetOf(**program, "u_random"), static_cast<GLint>(offsetof(SampleBlock, random)));
  EXPECT_EQ(offsetOf(**program, "u_window"), static_cast<GLint>(offsetof(SampleBlock, window)));
}

TEST_F(FrameBlocks, DrawBlockMatchesItsTwin) {
  const gl::Program& program = programOf(ShadingModel::Skin);
  const auto [size, binding] = sizeAndBinding(program, "DrawBlock");
  EXPECT_EQ(binding, static_cast<GLint>(kDrawBinding));
  EXPECT_EQ(size, static_cast<GLint>(sizeof(DrawBlock)));
  EXPECT_EQ(offsetOf(program, "u_maps[0].channel"), 0);
  EXPECT_EQ(offsetOf(program, "u_maps[0].transform"), static_cast<GLint>(offsetof(MapBlock, transform)));
  EXPECT_EQ(offsetOf(program, "u_maps[12].transform"), static_cast<GLint>(12 * sizeof(MapBlock) + 16));
  EXPECT_EQ(offsetOf(program, "u_map_bits"), static_cast<GLint>(offsetof(DrawBlock, mapBits)));
  EXPECT_EQ(offsetOf(program, "u_scattering"), static_cast<GLint>(offsetof(DrawBlock, scattering)));
}

TEST(FrameMaps, ScaleAndInvertFoldIntoOneMultiplyAdd) {
  TextureBinding binding;
  binding.channel = TextureChannel::B;
  binding.scale = 0.5F;
  binding.uvScale = {2.0F, 3.0F};
  EXPECT_EQ(packMap(TextureSlot::Roughness, binding).channel, glm::vec4(0.0F, 0.0F, 1.0F, 0.0F));
  EXPECT_EQ(packMap(TextureSlot::Roughness, binding).transform, glm::vec4(0.5F, 0.0F, 2.0F, 3.0F));
  binding.invert = true;  // 0.5 (1 − x)
  EXPECT_EQ(packMap(TextureSlot::Roughness, binding).transform, glm::vec4(-0.5F, 0.5F, 2.0F, 3.0F));
  EXPECT_EQ(packMap(TextureSlot::Normal, binding).transform, glm::vec4(0.5F, 0.0F, 2.0F, 3.0F));
}

TEST(FrameLights, SwayAndOrbitMove) {
  Light light;
  light.position = {1.0F, 2.0F, 0.0F};
  light.animation = {AnimationKind::Sway, 3.0F, 0.5F};
  EXPECT_NEAR(animated(light, 3.14159265).position.x, 4.0F, 1e-5F);  // sin(π/2)
  EXPECT_EQ(animated(light, 0.0).position, light.position);
  light.animation = {AnimationKind::Orbit, 2.0F, 1.0F};
  const glm::vec3 quarter = animated(light, 1.5707963).position;  // counter-clockwise from above: +x goes to −z
  EXPECT_NEAR(quarter.x, 0.0F, 1e-5F);
  EXPECT_NEAR(quarter.y, 2.0F, 1e-5F);
  EXPECT_NEAR(quarter.z, -2.0F, 1e-5F);
}

TEST(FrameLights, SixteenAtMostAndOnlyEnabledOnes) {
  std::vector<Light> lights(20);
  lights[0].enabled = false;
  lights[1].intensity = 7.0F;
  FrameBlock block;
  packLights(block, lights, 100.0F, 0.0);
  EXPECT_EQ(block.lightCount.x, 16);
  EXPECT_FLOAT_EQ(block.lights[0].radiantInner.x, 7.0F);
  EXPECT_FLOAT_EQ(block.lights[0].size.x, 0.5F);  // 50 mm at 100 mm a unit
}

}  // namespace
}  // namespace dermis::test
