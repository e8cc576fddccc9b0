// Views on the GPU against OpenColorIO's CPU processor, and the views that always exist.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "colour/display_transform.h"
#include "gl_fixture.h"
#include "renderer.h"

namespace dermis::test {
namespace {

namespace fs = std::filesystem;

/// 33³ scene values: 0 and a logarithmic ladder to 16, what a lit face and its highlights hold.
std::vector<glm::vec4> sceneGrid() {
  std::vector<float> axis = {0.0F};
  for (int i = 1; i < 33; ++i) axis.push_back(std::exp2(-9.0F + 13.0F * static_cast<float>(i - 1) / 31.0F));
  std::vector<glm::vec4> grid;
  for (const float b : axis)
    for (const float g : axis)
      for (const float r : axis) grid.emplace_back(r, g, b, 1.0F);
  return grid;
}

gl::Texture upload(const DisplayTexture& source) {
  gl::TextureSpec spec;
  spec.target = source.dimensions == 3 ? GL_TEXTURE_3D : source.dimensions == 1 ? GL_TEXTURE_1D : GL_TEXTURE_2D;
  spec.format = source.channels == 1 ? GL_R32F : GL_RGB32F;
  spec.width = source.width;
  spec.height = source.height;
  spec.depth = source.depth;
  spec.label = source.samplerName;
  gl::Texture texture = gl::Texture::create(spec);
  const GLenum format = source.channels == 1 ? GL_RED : GL_RGB;
  if (source.dimensions == 3)
    texture.uploadAll(0, format, GL_FLOAT, source.values.data());
  else
    texture.upload(0, format, GL_FLOAT, source.values.data());
  const GLenum filter = source.nearest ? GL_NEAREST : GL_LINEAR;
  texture.setFilter(filter, filter);
  texture.setWrap(GL_CLAMP_TO_EDGE);
  return texture;
}

class Colour : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    m_folder = fs::path(::testing::TempDir()) / "dermis-colour-test";
    fs::create_directories(m_folder);
    std::ofstream(m_folder / "colour_probe.comp") << R"(layout(local_size_x = 64) in;
#include "generated/transform.glsl"
layout(std430, binding = 0) buffer Values { vec4 u_values[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < uint(u_values.length())) u_values[i] = TRANSFORM(u_values[i]);
}
)";
  }
  void TearDown() override {
    fs::remove_all(m_folder);
    GlTest::TearDown();
  }

  /// `values` through GLSL that defines vec4 NAME(vec4).
  std::vector<glm::vec4> run(const std::string& glsl, const std::string& name, const std::vector<glm::vec4>& values,
                             const std::vector<DisplayTexture>& textures) {
    gl::ShaderLibrary shaders(m_folder);
    gl::ProgramSources sources;
    sources.compute = "colour_probe.comp";
    sources.defines = {"TRANSFORM " + name};
    sources.generated["generated/transform.glsl"] = glsl;
    const auto program = shaders.program(sources);
    EXPECT_TRUE(program.has_value()) << program.error().message;
    if (!program) return values;
    (*program)->use();
    std::vector<gl::Texture> resident;
    for (std::size_t i = 0; i < textures.size(); ++i) {
      resident.push_back(upload(textures[i]));
      resident.back().bind(static_cast<GLuint>(i) + 1);
      glUniform1i((*program)->uniform(textures[i].samplerName), static_cast<GLint>(i) + 1);
    }
    const gl::Buffer buffer = gl::Buffer::writable("colour probe", values.size() * sizeof(glm::vec4));
    buffer.update(0, std::as_bytes(std::span(values)));
    buffer.bindStorage(0);
    glDispatchCompute(static_cast<GLuint>((values.size() + 63) / 64), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<glm::vec4> out(values.size());
    glGetNamedBufferSubData(buffer.id(), 0, static_cast<GLsizeiptr>(out.size() * sizeof(glm::vec4)), out.data());
    return out;
  }
  static float worst(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    float error = 0.0F;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (int c = 0; c < 3; ++c)
        error = std::max(error, std::abs(std::clamp(a[i][c], 0.0F, 1.0F) - std::clamp(b[i][c], 0.0F, 1.0F)));
    return error;
  }
  static std::shared_ptr<const DisplayTransform> make(std::string_view view, Warnings& warnings) {
    const auto made = DisplayTransform::create("sRGB", view, warnings);
    EXPECT_TRUE(made.has_value()) << made.error().message;
    return made ? *made : nullptr;
  }

  fs::path m_folder;
};

TEST_F(Colour, ExactProgramsAgreeWithTheCpuOnAGrid) {
  for (const char* view : {"ACES", "sRGB", "Raw", "Thesis", "Gamma 2.2"}) {
    Warnings warnings;
    const auto transform = make(view, warnings);
    ASSERT_NE(transform, nullptr);
    EXPECT_TRUE(warnings.empty()) << view << ": " << warnings.front();
    std::vector<glm::vec4> want = sceneGrid();
    transform->apply(&want[0].x, want.size());
    const auto& program = transform->exactProgram();
    EXPECT_LE(worst(run(program.glsl, "displayExact", sceneGrid(), program.textures), want), 1.0F / 512.0F) << view;
  }
}

TEST_F(Colour, TheBakedAcesViewIsWithinHalfAStepOfEightBits) {
  Warnings warnings;
  const auto transform = make("aces", warnings);  // names know no case
  ASSERT_NE(transform, nullptr);
  ASSERT_FALSE(transform->isSimple());
  const DisplayLut& lut = transform->lut();
  ASSERT_GT(lut.edge, 1);
  std::vector<glm::vec4> want = sceneGrid();
  transform->apply(&want[0].x, want.size());

  gl::TextureSpec spec;
  spec.target = GL_TEXTURE_3D;
  spec.format = GL_RGBA16F;
  spec.width = spec.height = spec.depth = lut.edge;
  spec.label = "baked view";
  gl::Texture texture = gl::Texture::create(spec);
  texture.uploadAll(0, GL_RGB, GL_FLOAT, lut.rgb.data());
  texture.setFilter(GL_LINEAR, GL_LINEAR);
  texture.setWrap(GL_CLAMP_TO_EDGE);
  texture.bind(3);
  const std::string glsl =
      displayBakedGlsl(3) + "vec4 baked(vec4 scene) { return vec4(displayBaked(scene.rgb), scene.a); }\n";
  // 1/512 for all but a few deeply saturated colours, whose third channel crosses zero where the sRGB curve is
  // steepest. Exports take the exact program.
  const std::vector<glm::vec4> got = run(glsl, "baked", sceneGrid(), {});
  double square = 0.0;
  std::size_t over = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const float error = std::abs(std::clamp(got[i][c], 0.0F, 1.0F) - std::clamp(want[i][c], 0.0F, 1.0F));
      square += static_cast<double>(error) * error;
      over += error > 1.0F / 512.0F ? 1 : 0;
    }
  }
  const auto count = static_cast<double>(3 * got.size());
  EXPECT_LE(static_cast<double>(over) / count, 0.004);
  EXPECT_LE(std::sqrt(square / count), 1.0 / 2048.0);
  EXPECT_LE(worst(got, want), 1.0F / 64.0F);
}

TEST_F(Colour, ABakedViewIsKeptOnDiskAndADamagedOneIsMadeAgain) {
  const char* before = std::getenv("XDG_CACHE_HOME");
  const std::string cache = before == nullptr ? "" : before;
  const fs::path folder = m_folder / "cache";
  fs::remove_all(folder);
  setenv("XDG_CACHE_HOME", folder.c_str(), 1);
  Warnings warnings;
  const std::vector<float> baked = make("ACES", warnings)->lut().rgb;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  ASSERT_EQ(files.size(), 1U);
  const auto written = fs::last_write_time(files[0]);
  fs::last_write_time(files[0], written - std::chrono::hours(1));
  EXPECT_EQ(make("ACES", warnings)->lut().rgb, baked);
  EXPECT_GE(fs::last_write_time(files[0]), written) << "nobody read it";

  std::fstream stream(files[0], std::ios::binary | std::ios::in | std::ios::out);
  stream.seekp(5000);
  stream.put('\x7f');
  stream.close();
  EXPECT_EQ(make("ACES", warnings)->lut().rgb, baked);
  EXPECT_NE(make("sRGB", warnings)->lut().rgb, baked);
  if (before == nullptr)
    unsetenv("XDG_CACHE_HOME");
  else
    setenv("XDG_CACHE_HOME", cache.c_str(), 1);
}

TEST_F(Colour, MiddleGreyLandsWhereAcesPutsIt) {
  Warnings warnings;
  const auto transform = make("ACES", warnings);
  ASSERT_NE(transform, nullptr);
  glm::vec4 grey(0.18F, 0.18F, 0.18F, 0.5F);
  transform->apply(&grey.x, 1);
  EXPECT_NEAR(grey.x, 0.356F, 0.001F);
  EXPECT_EQ(grey.w, 0.5F);
}

TEST_F(Colour, TheSeedsCurvesAreWhatTheyPublished) {
  Warnings warnings;
  glm::vec4 value(0.25F, 1.0F, 4.0F, 1.0F);
  const auto thesis = make("thesis", warnings);
  ASSERT_NE(thesis, nullptr);
  thesis->apply(&value.x, 1);
  EXPECT_NEAR(value.x, std::pow(0.2F, 1.0F / 2.2F), 1e-6F);
  EXPECT_NEAR(value.y, std::pow(0.5F, 1.0F / 2.2F), 1e-6F);
  const auto raw = make("RAW", warnings);
  ASSERT_NE(raw, nullptr);
  EXPECT_TRUE(raw->isRaw());
  value = glm::vec4(-1.0F, 0.5F, 70000.0F, 1.0F);
  raw->apply(&value.x, 1);
  EXPECT_EQ(value, glm::vec4(-1.0F, 0.5F, 70000.0F, 1.0F));
  EXPECT_TRUE(warnings.empty());
}

TEST_F(Colour, AnUnknownViewFallsBackWithAWarning) {
  Warnings warnings;
  const auto transform = make("No Such View", warnings);
  ASSERT_NE(transform, nullptr);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("No Such View"), std::string::npos);
  const auto views = displayViews();
  ASSERT_TRUE(views.has_value());
  EXPECT_EQ(transform->view(), views->defaultView);
  for (const char* always : {"ACES", "Raw", "sRGB", "Thesis", "Gamma 2.2"})
    EXPECT_NE(std::ranges::find(views->views, always), views->views.end()) << always;
}

TEST_F(Colour, TexturesDecodeByTheirColourSpace) {
  using Decode = TextureColour::Decode;
  struct Row {
    const char* space;
    bool colourSlot, isFloat;
    Decode want;
  };
  for (const Row& row : {Row{"", true, false, Decode::Srgb}, Row{"", true, true, Decode::Linear},
                         Row{"", false, false, Decode::Linear}, Row{"srgb", false, false, Decode::Srgb},
                         Row{"linear", true, false, Decode::Linear}, Row{"raw", true, false, Decode::Linear}}) {
    Warnings warnings;
    const auto colour = textureColour(row.space, row.colourSlot, row.isFloat, warnings);
    ASSERT_TRUE(colour.has_value());
    EXPECT_EQ(colour->decode, row.want) << row.space << row.colourSlot << row.isFloat;
    EXPECT_TRUE(warnings.empty());
  }
  // ACEScg's red lies outside Rec.709.
  Warnings warnings;
  const auto cg = textureColour("ACEScg", true, true, warnings);
  ASSERT_TRUE(cg.has_value());
  ASSERT_EQ(cg->decode, Decode::Convert);
  glm::vec4 red(1.0F, 0.0F, 0.0F, 1.0F);
  cg->convert(&red.x, 1);
  EXPECT_NEAR(red.x, 1.705F, 0.005F);
  EXPECT_NEAR(red.y, -0.130F, 0.005F);
  glm::vec4 white(1.0F);
  cg->convert(&white.x, 1);
  EXPECT_NEAR(white.x, 1.0F, 1e-3F);
  EXPECT_NEAR(white.z, 1.0F, 1e-3F);

  const auto unknown = textureColour("no such space", true, false, warnings);
  ASSERT_TRUE(unknown.has_value());
  EXPECT_EQ(unknown->decode, Decode::Srgb);
  EXPECT_FALSE(warnings.empty());
}

}  // namespace
}  // namespace dermis::test
