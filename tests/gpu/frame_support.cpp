#include "gpu/frame_support.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "core/scene/primitives.h"

namespace dermis::test {

std::shared_ptr<const EnvironmentImages> constantWorld(const glm::vec3& radiance) {
  // One of a radiance: a renderer that has it baked doesn't bake it again.
  static std::vector<std::shared_ptr<EnvironmentImages>> made;
  for (const auto& known : made)
    if (known->constant == radiance) return known;
  auto environment = std::make_shared<EnvironmentImages>();
  environment->constant = radiance;
  environment->contentHash = 0xf4a3e0000 + made.size();
  environment->name = "constant";
  return made.emplace_back(std::move(environment));
}

ResolvedScene sceneOf(Model model, const Material& material, const glm::vec3& environment) {
  ResolvedScene scene;
  scene.model = std::make_shared<Model>(std::move(model));
  scene.millimetresPerUnit = 100.0F;
  for (std::size_t i = 0; i < scene.model->slots.size(); ++i) scene.slots.push_back({material, {}});
  scene.environment = constantWorld(environment);
  scene.scene.environment.background.kind = BackgroundKind::None;
  scene.camera.position = {0.0F, 0.0F, 5.0F};
  scene.camera.target = {0.0F, 0.0F, 0.0F};
  scene.camera.orthographicHeight = 2.0F;
  return scene;
}

Light pointLight(const glm::vec3& position, float intensity) {
  Light light;
  light.position = position;
  light.intensity = intensity;
  return light;
}

Material materialOf(ShadingModel model) {
  Material material;
  material.model = model;
  return material;
}

Model emptied(Model model) {
  model.positions.clear();
  model.normals.clear();
  model.tangents.clear();
  model.uvs.clear();
  model.indices.clear();
  return model;
}

Model planeOf(int n) {
  const Model plane = makePlane();
  Model model = emptied(plane);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const glm::vec2 uv = glm::vec2(i, j) / static_cast<float>(n);
      model.positions.emplace_back(2.0F * uv - 1.0F, 0.0F);
      model.normals.push_back(plane.normals[0]);
      model.tangents.push_back(plane.tangents[0]);
      model.uvs.push_back(uv);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (n + 1) + i);
      const auto b = a + static_cast<std::uint32_t>(n) + 1;
      model.indices.insert(model.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  model.parts[0].indexCount = static_cast<std::uint32_t>(model.indices.size());
  return model;
}

Material emissive(const glm::vec3& radiance) {
  Material material = materialOf(ShadingModel::MetallicRoughness);
  material.parameters.baseAlbedo.rgb = glm::vec3(0.0F);
  material.parameters.metallicRoughnessEmissive.rgb = radiance;
  return material;
}

std::shared_ptr<const Image> imageOf(int width, int height, int channels, PixelType type,
                                     const std::vector<float>& values) {
  auto image = std::make_shared<Image>();
  image->width = width;
  image->height = height;
  image->channels = channels;
  image->type = type;
  image->name = "test.png";
  image->pixels.resize(values.size() * bytesPerChannel(type));
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::byte* at = image->pixels.data() + i * bytesPerChannel(type);
    const float value = values[i];
    if (type == PixelType::U8) *at = static_cast<std::byte>(std::lround(value * 255.0F));
    const auto wide = type == PixelType::Half
                          ? glm::packHalf1x16(value)
                          : static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F));
    if (type == PixelType::U16 || type == PixelType::Half) std::memcpy(at, &wide, sizeof wide);
    if (type == PixelType::Float) std::memcpy(at, &value, sizeof value);
  }
  return image;
}

void setMap(ResolvedScene& scene, TextureSlot slot, std::shared_ptr<const Image> image, const TextureBinding& binding) {
  for (ResolvedMaterial& material : scene.slots) {
    material.images.at(static_cast<std::size_t>(slot)) = image;
    material.material.texture(slot) = binding;
    material.material.texture(slot).path = "test.png";
  }
}

glm::vec4 pixel(const Image& image, int x, int y) {
  glm::vec4 value(0.0F);
  const auto index =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
      static_cast<std::size_t>(image.channels);
  std::memcpy(&value, image.pixels.data() + index * sizeof(float),
              static_cast<std::size_t>(image.channels) * sizeof(float));
  return value;
}

float largestDifference(const Image& a, const Image& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  float largest = 0.0F;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const glm::vec4 difference = glm::abs(pixel(a, x, y) - pixel(b, x, y));
      largest = std::max({largest, difference.x, difference.y, difference.z, difference.w});
    }
  return largest;
}

Window::Window(glm::ivec2 size)
    : texture(gl::Texture::create({.format = GL_RGBA8, .width = size.x, .height = size.y, .label = "window"})),
      framebuffer(gl::Framebuffer::create("window")) {
  framebuffer.attachColour(0, texture);
  framebuffer.drawTo(1);
}

std::vector<std::uint8_t> Window::read() const {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(texture.width()) *
                                   static_cast<std::size_t>(texture.height()) * 4);
  glGetTextureImage(texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(values.size()), values.data());
  return values;
}

void FrameTest::SetUp() {
  GlTest::SetUp();
  if (!HasFatalFailure()) makeRenderer();
}

void FrameTest::TearDown() {
  if (m_renderer) {
    EXPECT_EQ(m_renderer->statistics().glErrors, 0U);
  }
  m_renderer.reset();
  GlTest::TearDown();
}

void FrameTest::makeRenderer(RendererOptions options) {
  options.failOnGlError = true;
  options.platform = sharedContext()->platform();
  m_renderer.reset();
  auto made = Renderer::create(options);
  ASSERT_TRUE(made.has_value()) << made.error().message;
  m_renderer = std::move(*made);
}

void FrameTest::show(const ResolvedScene& scene) {
  m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
  const auto finished = m_renderer->finishJobs();
  ASSERT_TRUE(finished.has_value()) << finished.error().message;
}

FrameRequest FrameTest::request(const ResolvedScene& scene, int samples) const {
  FrameRequest frame;
  frame.size = m_size;
  frame.camera = scene.camera;
  frame.view.transform = "Raw";
  frame.targetSamples = samples;
  frame.exactDisplay = true;
  return frame;
}

Image FrameTest::still(const ResolvedScene& scene, int samples) {
  show(scene);
  const FrameRequest frame = request(scene, samples);
  do EXPECT_TRUE(m_renderer->renderFrame(frame));
  while (m_renderer->accumulating());
  for (const std::string& message : m_renderer->takeMessages()) ADD_FAILURE() << message;
  return m_renderer->readAov(Aov::Beauty);
}

std::vector<std::uint8_t> FrameTest::movingPicture(const ResolvedScene& scene, bool software) {
  RendererOptions options;
  options.software = software;
  makeRenderer(options);
  show(scene);
  const Window window(m_size);
  FrameRequest frame = request(scene);
  frame.exactDisplay = false;
  frame.moving = true;
  frame.framebuffer = window.framebuffer.id();
  EXPECT_TRUE(m_renderer->renderFrame(frame));
  return window.read();
}

}  // namespace dermis::test
