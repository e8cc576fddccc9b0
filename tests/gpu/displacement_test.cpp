// Surfaces displaced by a height map: where they are, which way they face, that they don't tear, what they cost nothing
// for.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"
#include "reference/sphere_view.h"

namespace dermis::test {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// A cube of half extent ½ with hard edges, turned towards the camera by a corner; every face has all of the map.
Model cube() {
  const Model face = makePlane();
  Model model = emptied(face);
  model.bounds = {};
  const glm::vec3 corner = glm::normalize(glm::vec3(1.0F, 1.2F, 1.5F));
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), corner));
  const glm::mat3 turn = glm::transpose(glm::mat3(right, glm::cross(corner, right), corner));
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0F, 1.0F}) {
      glm::vec3 n(0.0F), t(0.0F);
      n[axis] = side;
      t[(axis + 1) % 3] = side;
      const glm::vec3 b = glm::cross(n, t);
      const auto first = static_cast<std::uint32_t>(model.positions.size());
      for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec2 uv = face.uvs[i];
        model.positions.push_back(turn * (0.5F * n + (uv.x - 0.5F) * t + (uv.y - 0.5F) * b));
        model.normals.push_back(turn * n);
        model.tangents.emplace_back(turn * t, 1.0F);
        model.uvs.push_back(uv);
        model.bounds.grow(model.positions.back());
      }
      for (const std::uint32_t i : face.indices) model.indices.push_back(first + i);
    }
  model.parts[0].indexCount = static_cast<std::uint32_t>(model.indices.size());
  return model;
}

/// A map of one channel; value(u, v) with v upwards.
template <class Function>
std::shared_ptr<const Image> heightMap(int size, const Function& value) {
  std::vector<float> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      texels.push_back(static_cast<float>(value((x + 0.5) / size, 1.0 - (y + 0.5) / size)));
  return imageOf(size, size, 1, PixelType::Float, texels);
}

std::shared_ptr<const Image> noise() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return heightMap(64, [&](double, double) { return unit(random); });
}

class Displacement : public FrameTest {
 protected:
  static ResolvedScene displacedScene(Model model, std::shared_ptr<const Image> map, float mm, float midlevel) {
    Material skin = materialOf(ShadingModel::Skin);
    skin.parameters.surfaceDisplacementMm = mm;
    skin.parameters.surfaceDisplacementMidlevel = midlevel;
    ResolvedScene scene = sceneOf(std::move(model), skin);
    setMap(scene, TextureSlot::Displacement, std::move(map));
    return scene;
  }
  /// One sample at the pixels' centres.
  struct Views {
    Image beauty, depth, normal;
  };
  Views look(const ResolvedScene& scene) {
    m_renderer->keepAovs({Aov::Depth, Aov::Normal});
    Views views;
    views.beauty = still(scene);
    views.depth = m_renderer->readAov(Aov::Depth);
    views.normal = m_renderer->readAov(Aov::Normal);
    return views;
  }
};

TEST_F(Displacement, ASineIsWhereItShouldBeAndFacesWhereItShould) {
  m_size = {400, 400};
  constexpr double kWaves = 3.0, kAmplitude = 3.5, kMidlevel = 0.3;  // mm from trough to crest
  const auto height01 = [](double u, double v) {
    return 0.5 + 0.25 * (std::sin(kTwoPi * kWaves * u) + std::cos(kTwoPi * kWaves * v));
  };
  const auto map = heightMap(512, height01);
  // The plane is 2 units wide: 20, 60 and 200 mm.
  for (const float mmPerUnit : {10.0F, 30.0F, 100.0F}) {
    ResolvedScene scene =
        displacedScene(planeOf(16), map, static_cast<float>(kAmplitude), static_cast<float>(kMidlevel));
    scene.millimetresPerUnit = mmPerUnit;
    const Views views = look(scene);
    double depthError = 0.0, worstAngle = 0.0, meanAngle = 0.0;
    int count = 0;
    for (int y = 4; y < 396; ++y)
      for (int x = 4; x < 396; ++x) {
        const double u = (x + 0.5) / 400.0, v = 1.0 - (y + 0.5) / 400.0;
        const double unit = kAmplitude / static_cast<double>(mmPerUnit);
        const double h = (height01(u, v) - kMidlevel) * unit;
        depthError = std::max(depthError, std::abs(5.0 - h - static_cast<double>(pixel(views.depth, x, y).r)) / unit);
        // One unit of u is two scene units.
        const double slope = 0.25 * kTwoPi * kWaves * unit / 2.0;
        const glm::dvec3 n = glm::normalize(
            glm::dvec3(-slope * std::cos(kTwoPi * kWaves * u), slope * std::sin(kTwoPi * kWaves * v), 1.0));
        const glm::dvec3 got(pixel(views.normal, x, y));
        const double angle = std::acos(std::min(1.0, glm::dot(n, glm::normalize(got)))) * 180.0 / std::numbers::pi;
        worstAngle = std::max(worstAngle, angle);
        meanAngle += angle;
        ++count;
      }
    meanAngle /= count;
    const std::string what = std::to_string(mmPerUnit) + " mm a unit";
    EXPECT_LT(depthError, 0.01) << what << ": share of the amplitude";
    EXPECT_LT(worstAngle, 0.5) << what << ": degrees";
    EXPECT_LT(meanAngle, 0.15) << what << ": degrees";
    RecordProperty("depth error at " + what, std::to_string(depthError));
    RecordProperty("largest angle at " + what, std::to_string(worstAngle));
  }
}

TEST_F(Displacement, AnInflatedSphereIsALargerSphere) {
  m_size = {120, 120};
  ResolvedScene scene = displacedScene(makeSphere(96), heightMap(4, [](double, double) { return 1.0; }), 15.0F, 0.2F);
  scene.camera.orthographicHeight = 2.5F;  // 100 mm a unit: the radius grows from 1 by 0.12
  const Views views = look(scene);
  Camera shrunk = scene.camera;  // the larger sphere seen, in units of its radius
  shrunk.orthographicHeight = 2.5F / 1.12F;
  int inside = 0;
  for (int y = 0; y < m_size.y; ++y)
    for (int x = 0; x < m_size.x; ++x) {
      const auto point = reference::sphereUnderPixel(shrunk, m_size.x, m_size.y, x, y);
      const bool covered = pixel(views.beauty, x, y).a > 0.5F;
      if (!point) {
        const double across = std::hypot(x - 59.5, y - 59.5) * 2.5 / 120.0;
        if (across > 1.12) {
          EXPECT_FALSE(covered) << x << ", " << y;
        }
        continue;
      }
      if (point->normal.z < 0.3) continue;
      ++inside;
      EXPECT_TRUE(covered) << x << ", " << y;
      EXPECT_NEAR(pixel(views.depth, x, y).r, 5.0 - 1.12 * point->normal.z, 0.006) << x << ", " << y;
      EXPECT_GT(glm::dot(glm::dvec3(pixel(views.normal, x, y)), point->normal), 0.9999) << x << ", " << y;
    }
  EXPECT_GT(inside, 8000);
}

TEST_F(Displacement, WavesRoundASphereFaceWhereTheyShould) {
  m_size = {160, 160};
  // r(φ) = 1 + 0.1 (½ + ½ cos 12 φ − ½) with φ from +Z towards +X, as makeSphere's u has it; the slope reaches 0.6.
  ResolvedScene scene = displacedScene(
      makeSphere(128),
      heightMap(1024, [](double u, double) { return 0.5 + 0.5 * std::cos(12.0 * kTwoPi * (u - 0.5)); }), 10.0F, 0.5F);
  const Views views = look(scene);
  double worst = 0.0, mean = 0.0;
  int count = 0;
  for (int y = 0; y < m_size.y; ++y)
    for (int x = 0; x < m_size.x; ++x) {
      // The picture says where the surface is; what it faces there follows from the formula.
      const glm::dvec3 p((x + 0.5) / 80.0 - 1.0, 1.0 - (y + 0.5) / 80.0,
                         5.0 - static_cast<double>(pixel(views.depth, x, y).r));
      if (std::hypot(p.x, p.y) > 0.85 || std::abs(p.y) > 0.6) continue;
      const double phi = std::atan2(p.x, p.z), r = glm::length(p);
      EXPECT_NEAR(r, 1.0 + 0.05 * std::cos(12.0 * phi), 0.008);
      // F = |p| − r(φ): its gradient, with ∂φ/∂p = (cos φ, 0, −sin φ) / (|p| sin θ).
      const double derivative = -0.6 * std::sin(12.0 * phi);
      const glm::dvec3 n =
          glm::normalize(p / r - derivative * glm::dvec3(std::cos(phi), 0.0, -std::sin(phi)) / std::hypot(p.x, p.z));
      const double angle =
          std::acos(std::min(1.0, glm::dot(n, glm::normalize(glm::dvec3(pixel(views.normal, x, y)))))) * 180.0 /
          std::numbers::pi;
      worst = std::max(worst, angle);
      mean += angle;
      ++count;
    }
  ASSERT_GT(count, 8000);
  RecordProperty("mean angle", std::to_string(mean / count));
  EXPECT_LT(mean / count, 0.5) << "degrees";
  EXPECT_LT(worst, 6.0) << "degrees, where a pixel's depth is a crest's triangle";
}

TEST_F(Displacement, NothingTearsAtSeamsPolesAndHardEdges) {
  m_size = {240, 240};
  // The inside of the far side would show through a crack.
  struct Solid {
    const char* name;
    Model model;
    double least;  // radius of the disc on the screen that the solid fills, however its map turns out
  };
  const std::vector<Solid> solids = {{"sphere", makeSphere(24), 0.75}, {"cube", cube(), 0.4}};
  for (const Solid& solid : solids)
    for (const glm::vec3 from :
         {glm::vec3(0, 0, 5), glm::vec3(0, 4.5F, -2), glm::vec3(0, -3, -4), glm::vec3(3, 3, 2)}) {
      ResolvedScene scene = displacedScene(solid.model, noise(), 20.0F, 0.5F);
      scene.camera.position = from;
      const Views views = look(scene);
      const float middle = glm::length(from);
      int holes = 0, looked = 0;
      for (int y = 0; y < m_size.y; ++y)
        for (int x = 0; x < m_size.x; ++x) {
          if (std::hypot(x - 119.5, y - 119.5) / 120.0 > solid.least) continue;
          ++looked;
          if (pixel(views.beauty, x, y).a < 0.5F || pixel(views.depth, x, y).r > middle) ++holes;
        }
      EXPECT_GT(looked, 5000);
      EXPECT_EQ(holes, 0) << solid.name << " from " << from.x << ", " << from.y << ", " << from.z;
    }
}

TEST_F(Displacement, ZeroIsAsIfThereWereNoMap) {
  m_size = {96, 96};
  ResolvedScene scene = displacedScene(makeSphere(48), noise(), 0.0F, 0.5F);
  const Image none = still(sceneOf(makeSphere(48), materialOf(ShadingModel::Skin)));
  const auto geometryUploads = m_renderer->statistics().geometryUploads;
  const Image zero = still(scene);
  EXPECT_EQ(largestDifference(none, zero), 0.0F);
  EXPECT_EQ(m_renderer->statistics().geometryUploads, geometryUploads + 1);
  // Models that have no displacement don't become displaced by a value that another model left behind.
  scene.slots[0].material.parameters.surfaceDisplacementMm = 10.0F;
  for (const ShadingModel model : {ShadingModel::Thesis, ShadingModel::MetallicRoughness, ShadingModel::Eye}) {
    scene.slots[0].material.model = model;
    const Image flat = still(sceneOf(makeSphere(48), scene.slots[0].material));
    EXPECT_EQ(largestDifference(flat, still(scene)), 0.0F) << shadingModelRow(model).id;
  }
}

TEST_F(Displacement, TheSliderCompilesAndUploadsNothing) {
  ResolvedScene scene = displacedScene(planeOf(8), noise(), 0.0F, 0.5F);
  scene.environment = constantWorld(glm::vec3(0.0F));  // in a white one everything is white
  scene.scene.lights = {pointLight({0.5F, 0.5F, 2.0F}, 5.0F)};
  const Image flat = still(scene);
  const RenderStatistics before = m_renderer->statistics();
  for (const float mm : {0.5F, 3.0F, -2.0F, 0.0F, 1.0F}) {
    scene.slots[0].material.parameters.surfaceDisplacementMm = mm;
    const Image picture = still(scene);
    if (mm == 0.0F) {
      EXPECT_EQ(largestDifference(picture, flat), 0.0F);
    } else {
      EXPECT_GT(largestDifference(picture, flat), 0.01F);
    }
  }
  const RenderStatistics after = m_renderer->statistics();
  EXPECT_EQ(after.programsCompiled, before.programsCompiled);
  EXPECT_EQ(after.texturesUploaded, before.texturesUploaded);
  EXPECT_EQ(after.geometryUploads, before.geometryUploads);
}

TEST_F(Displacement, IsNotCutOffByThePlanesOfTheCamera) {
  // 5 mm a unit: the plane rises by 4 units towards a camera 5 away, and sinks by 4.
  for (const float mm : {20.0F, -20.0F}) {
    ResolvedScene scene = displacedScene(planeOf(4), heightMap(4, [](double, double) { return 1.0; }), mm, 0.0F);
    scene.millimetresPerUnit = 5.0F;
    const Views views = look(scene);
    EXPECT_NEAR(pixel(views.depth, 24, 24).r, 5.0F - mm / 5.0F, 1e-3F);
  }
}

TEST_F(Displacement, MovesWithTheCameraAsItStands) {
  m_size = {160, 160};
  // Many triangles, so that software GL takes its way for dense meshes.
  ResolvedScene scene = displacedScene(
      planeOf(80),
      heightMap(256, [](double u,
                        double v) { return 0.5 + 0.25 * (std::sin(3.0 * kTwoPi * u) + std::cos(2.0 * kTwoPi * v)); }),
      20.0F, 0.5F);
  show(scene);
  const Window window(m_size);
  FrameRequest frame = request(scene);
  frame.framebuffer = window.framebuffer.id();
  frame.moving = true;
  EXPECT_TRUE(m_renderer->renderFrame(frame));
  const std::vector<std::uint8_t> moving = window.read();
  for (const glm::ivec2 at : {glm::ivec2(20, 30), glm::ivec2(80, 80), glm::ivec2(130, 50)}) {
    const auto position = m_renderer->pickPosition(at);
    ASSERT_TRUE(position.has_value());
    const double u = (at.x + 0.5) / 160.0, v = 1.0 - (at.y + 0.5) / 160.0;
    EXPECT_NEAR(position->z, 0.2 * 0.25 * (std::sin(3.0 * kTwoPi * u) + std::cos(2.0 * kTwoPi * v)), 0.003);
  }
  frame.moving = false;
  do EXPECT_TRUE(m_renderer->renderFrame(frame));
  while (m_renderer->accumulating());
  const std::vector<std::uint8_t> stillPicture = window.read();
  double sum = 0.0;
  for (std::size_t i = 0; i < moving.size(); ++i) sum += std::abs(int{moving[i]} - int{stillPicture[i]});
  EXPECT_LT(sum / static_cast<double>(moving.size()), 1.5) << "mean difference in codes of 255";
}

}  // namespace
}  // namespace dermis::test
