#include "gpu/sphere_fixture.h"

#include <cmath>
#include <cstring>
#include <numbers>

#include "core/scene/primitives.h"

namespace dermis::test {

namespace {

/// One renderer for all tests of the program, as one context is: programs are compiled once.
Renderer* sharedRenderer() {
  static const Result<std::unique_ptr<Renderer>> kMade = [] {
    RendererOptions options;
    options.failOnGlError = true;
    options.platform = sharedContext()->platform();
    return Renderer::create(options);
  }();
  EXPECT_TRUE(kMade.has_value()) << kMade.error().message;
  return kMade ? kMade->get() : nullptr;
}

std::uint64_t nextHash() {
  static std::uint64_t hash = 0x5eed0000;
  return ++hash;
}

}  // namespace

std::shared_ptr<const EnvironmentImages> constantEnvironment(const glm::vec3& radiance) {
  auto environment = std::make_shared<EnvironmentImages>();
  environment->constant = radiance;
  environment->contentHash = nextHash();
  environment->name = "constant";
  return environment;
}

std::shared_ptr<const EnvironmentImages> environmentOf(
    const std::function<glm::vec3(const dvec3& direction)>& radianceTowards) {
  auto image = std::make_shared<Image>();
  image->width = 512;
  image->height = 256;
  image->channels = 3;
  image->type = PixelType::Float;
  image->name = "made";
  std::vector<float> values;
  for (int j = 0; j < image->height; ++j)
    for (int i = 0; i < image->width; ++i) {
      const double phi = ((i + 0.5) / image->width - 0.5) * 2.0 * std::numbers::pi;
      const double theta = (j + 0.5) / image->height * std::numbers::pi;
      const glm::vec3 radiance =
          radianceTowards({std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)});
      values.insert(values.end(), {radiance.x, radiance.y, radiance.z});
    }
  image->pixels.resize(values.size() * sizeof(float));
  std::memcpy(image->pixels.data(), values.data(), image->pixels.size());
  auto environment = std::make_shared<EnvironmentImages>();
  environment->latLong = image;
  environment->contentHash = nextHash();
  environment->name = "made";
  return environment;
}

std::shared_ptr<const EnvironmentImages> linearEnvironment(const glm::vec3& base, const glm::vec3& x,
                                                           const glm::vec3& y, const glm::vec3& z) {
  return environmentOf([&](const dvec3& d) {
    const glm::vec3 f(d);
    return base + x * f.x + y * f.y + z * f.z;
  });
}

Camera perspectiveCamera() {
  Camera camera;
  camera.position = {0.6F, 0.9F, 4.0F};
  camera.verticalFovDegrees = 32.0F;
  return camera;
}

Camera orthographicCamera() {
  Camera camera;
  camera.position = {-1.0F, 0.4F, 4.0F};
  camera.orthographicHeight = 2.1F;
  return camera;
}

Picture SphereTest::render(const Look& look, Aov aov) {
  static const auto kSphere = std::make_shared<const Model>(makeSphere());
  static const auto kPlane = std::make_shared<const Model>(makePlane());
  Renderer* renderer = sharedRenderer();
  if (renderer == nullptr) return {};
  auto scene = std::make_shared<ResolvedScene>();
  scene->model = look.plane ? kPlane : kSphere;
  scene->millimetresPerUnit = 100.0F;
  scene->scene.lights = look.lights;
  scene->scene.environment.background.kind = BackgroundKind::None;
  ResolvedMaterial slot;
  slot.material = look.material;
  scene->slots = {slot};
  static const auto kDark = constantEnvironment(glm::vec3(0.0F));
  scene->environment = look.environment ? look.environment : kDark;
  scene->camera = look.camera;
  renderer->setScene(scene);
  renderer->keepAovs({aov});

  FrameRequest request;
  request.size = {look.size, look.size};
  request.camera = look.camera;
  request.view.transform = "Raw";
  request.targetSamples = look.samples;
  request.exactDisplay = true;
  auto finished = renderer->finishJobs();
  EXPECT_TRUE(finished.has_value()) << finished.error().message;
  EXPECT_TRUE(renderer->renderFrame(request));
  finished = renderer->finishJobs();
  EXPECT_TRUE(finished.has_value()) << finished.error().message;
  for (int i = 0; i < look.samples && renderer->accumulating(); ++i) EXPECT_TRUE(renderer->renderFrame(request));
  for (const std::string& message : renderer->takeMessages()) ADD_FAILURE() << message;

  const Image image = renderer->readAov(aov);
  Picture picture{look.size,
                  std::vector<glm::vec4>(static_cast<std::size_t>(look.size) * static_cast<std::size_t>(look.size))};
  EXPECT_EQ(image.width, look.size);
  EXPECT_EQ(image.type, PixelType::Float);
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    std::memcpy(&picture.pixels[i], image.pixels.data() + i * channels * sizeof(float), channels * sizeof(float));
  return picture;
}

void SphereTest::expectSphere(const Look& look, const std::function<dvec3(const dvec3& n, const dvec3& v)>& reference,
                              const std::string& what, double relative, double leastCosine, double absolute) {
  const Picture picture = render(look);
  ASSERT_EQ(picture.size, look.size);
  int compared = 0, wrong = 0;
  double worst = 0.0;
  std::string first;
  for (int y = 0; y < look.size; ++y)
    for (int x = 0; x < look.size; ++x) {
      const auto point = reference::sphereUnderPixel(look.camera, look.size, look.size, x, y);
      if (!point || glm::dot(point->normal, point->view) < leastCosine) continue;
      const dvec3 want = reference(point->normal, point->view), got(picture.at(x, y));
      ++compared;
      for (int c = 0; c < 3; ++c) {
        const double error = std::abs(got[c] - want[c]);
        worst = std::max(worst, error / (std::abs(want[c]) + absolute / relative));
        if (error <= relative * std::abs(want[c]) + absolute) continue;
        if (wrong++ == 0)
          first = "pixel " + std::to_string(x) + ", " + std::to_string(y) + ", channel " + std::to_string(c) + ": " +
                  std::to_string(got[c]) + " where " + std::to_string(want[c]) + " is due";
      }
    }
  EXPECT_GT(compared, look.size * look.size / 3) << what;
  EXPECT_EQ(wrong, 0) << what << ": " << wrong << " values of " << 3 * compared << "; " << first;
  ::testing::Test::RecordProperty(what, std::to_string(worst));
}

}  // namespace dermis::test
