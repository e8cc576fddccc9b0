#include "gpu/subsurface_support.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace dermis::test {

Material bareSkin() {
  Material material = materialOf(ShadingModel::Skin);
  MaterialParameters& p = material.parameters;
  p.baseAlbedo.rgb = glm::vec3(1.0F);
  p.specularIntensity = 0.0F;
  p.transmissionWeight = 0.0F;
  p.subsurfaceAlbedoMix = 1.0F;
  p.subsurfaceRadiusReading = RadiusReading::BurleyD;
  p.subsurfaceRadiusMm = {0.3F, 0.2F, 0.1F};
  return material;
}

std::shared_ptr<const Image> stepMap() {
  static const auto kMap = imageOf(2, 1, 1, PixelType::U8, {0.0F, 1.0F});
  return kMap;
}

Model twoHalves(float behind, bool sameSlot) {
  Model model;
  for (const bool right : {false, true}) {
    Model half = makePlane();
    for (glm::vec2& uv : half.uvs) uv = {right ? 0.75F : 0.25F, 0.5F};
    Placement placement;
    placement.scale = {0.5F, 1.0F, 1.0F};
    placement.translate = {right ? 0.5F : -0.5F, 0.0F, right ? -behind : 0.0F};
    appendModel(model, half, placement);
  }
  if (sameSlot) {
    model.parts[0].indexCount += model.parts[1].indexCount;
    model.parts.resize(1);
    model.slots.resize(1);
  }
  return model;
}

ResolvedScene stepScene(const Material& material, float widthMm) {
  ResolvedScene scene = sceneOf(twoHalves(0.0F, true), material);
  scene.millimetresPerUnit = 0.5F * widthMm;
  setMap(scene, TextureSlot::Albedo, stepMap());
  return scene;
}

Image SubsurfaceTest::moving(const ResolvedScene& scene) {
  // A moving frame is not kept; shown raw in a window of floats, it is its beauty.
  show(scene);
  const gl::Texture texture =
      gl::Texture::create({.format = GL_RGBA32F, .width = m_size.x, .height = m_size.y, .label = "window of floats"});
  const gl::Framebuffer framebuffer = gl::Framebuffer::create("window of floats");
  framebuffer.attachColour(0, texture);
  framebuffer.drawTo(1);
  FrameRequest frame = request(scene);
  frame.moving = true;
  frame.framebuffer = framebuffer.id();
  EXPECT_TRUE(m_renderer->renderFrame(frame));
  for (const std::string& message : m_renderer->takeMessages()) ADD_FAILURE() << message;
  const std::vector<float> values = texture.readFloats(4);
  Image image;
  image.width = m_size.x;
  image.height = m_size.y;
  image.channels = 4;
  image.type = PixelType::Float;
  image.pixels.resize(values.size() * sizeof(float));
  // Textures start at the lowest row, images at the top.
  for (int y = 0; y < m_size.y; ++y)
    std::memcpy(image.pixels.data() + image.rowBytes() * static_cast<std::size_t>(m_size.y - 1 - y),
                values.data() + static_cast<std::size_t>(y * m_size.x) * 4, image.rowBytes());
  return image;
}

std::vector<EdgePoint> SubsurfaceTest::acrossTheMiddle(const Image& image, double mmPerPixel, int rows) {
  std::vector<EdgePoint> points;
  for (int x = 0; x < image.width; ++x) {
    EdgePoint point{(x + 0.5 - 0.5 * image.width) * mmPerPixel, glm::dvec3(0.0)};
    for (int y = 0; y < rows; ++y)
      point.colour += glm::dvec3(pixel(image, x, (image.height - rows) / 2 + y)) / static_cast<double>(rows);
    points.push_back(point);
  }
  return points;
}

double SubsurfaceTest::errorOfEdge(const std::vector<EdgePoint>& seen, const DiffusionProfile& profile, double reachMm,
                                   double pixelMm, const std::string& name) {
  std::ofstream csv;
  if (const char* folder = std::getenv("DERMIS_CURVES"); folder != nullptr) {
    csv.open(std::string(folder) + "/" + name + ".csv");
    csv << "x_mm,R,G,B,R_exact,G_exact,B_exact\n";
  }
  glm::dvec3 squares(0.0);
  int count = 0;
  for (const EdgePoint& point : seen) {
    if (std::abs(point.x) > reachMm) continue;
    constexpr int kSteps = 9;
    glm::dvec3 exact(0.0);
    for (int i = 0; i < kSteps; ++i)
      exact += profile.edgeSpread(point.x + pixelMm * ((i + 0.5) / kSteps - 0.5)) / static_cast<double>(kSteps);
    squares += (point.colour - exact) * (point.colour - exact);
    ++count;
    if (csv)
      csv << point.x << ',' << point.colour.r << ',' << point.colour.g << ',' << point.colour.b << ',' << exact.r << ','
          << exact.g << ',' << exact.b << '\n';
  }
  EXPECT_GT(count, 8) << name;
  const glm::dvec3 error = glm::sqrt(squares / static_cast<double>(count));
  const double worst = std::max({error.r, error.g, error.b});
  std::printf("  %-44s RMSE %.4f %.4f %.4f of the plateau\n", name.c_str(), error.r, error.g, error.b);
  return worst;
}

}  // namespace dermis::test
