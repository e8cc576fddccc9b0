// What a mesh bake finds, against closed forms: form factors for hidden sky, shapes of known thickness.
#include "core/bake/mesh_bake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <thread>

#include "core/bake/bake_cache.h"
#include "core/bake/bake_points.h"
#include "core/bake/point_bake.h"
#include "core/bake/texel_bake.h"
#include "core/scene/primitives.h"
#include "unit/temporary_folder.h"

namespace dermis {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// A rectangle of n×n cells from `corner` along two edges, facing their cross product.
void addSheet(Model& model, const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b, int cells) {
  const auto first = static_cast<std::uint32_t>(model.positions.size());
  const glm::vec3 normal = glm::normalize(glm::cross(a, b));
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const glm::vec2 uv = glm::vec2(i, j) / static_cast<float>(cells);
      model.positions.push_back(corner + a * uv.x + b * uv.y);
      model.normals.push_back(normal);
      model.tangents.emplace_back(glm::normalize(a), 1.0F);
      model.uvs.push_back(uv);
    }
  const auto n = static_cast<std::uint32_t>(cells);
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = first + j * (n + 1) + i;
      for (const std::uint32_t corners : {v, v + 1, v + n + 2, v, v + n + 2, v + n + 1})
        model.indices.push_back(corners);
    }
}

/// One slot, scene units of a millimetre.
Model finished(Model model) {
  model.slots = {{"default", Material{}}};
  model.parts = {{0, 0, static_cast<std::uint32_t>(model.indices.size())}};
  for (const glm::vec3& p : model.positions) model.bounds.grow(p);
  model.millimetresPerUnit = 1.0F;
  return model;
}

/// Two facing sheets of 40 mm, `thickness` apart: the front at z = 0 looks to +Z.
Model slab(float thickness, int cells = 20) {
  Model model;
  addSheet(model, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, cells);
  addSheet(model, {-20, -20, -thickness}, {0, 40, 0}, {40, 0, 0}, cells);
  return finished(std::move(model));
}

/// A sphere with its normals turned inwards appended to one without.
Model shell(float outer, float inner) {
  Model model = makeSphere(96);
  Model hollow = makeSphere(96);
  for (glm::vec3& n : hollow.normals) n = -n;
  for (glm::vec3& p : model.positions) p *= outer;
  for (glm::vec3& p : hollow.positions) p *= inner;
  appendModel(model, hollow);
  model.millimetresPerUnit = 1.0F;
  return model;
}

RayScene sceneOf(const Model& model) {
  auto scene = RayScene::create(model, {});
  EXPECT_TRUE(scene.has_value());
  return std::move(*scene);
}

float occlusionAt(const Model& model, const glm::vec3& p, const glm::vec3& n, int rays = 1024) {
  return occlusionOf(hiddenSky(sceneOf(model), p, n, RaySet(rays, 90.0F)));
}

std::shared_ptr<const MeshBake> bakeOf(const Model& model, MeshBakeOptions options = {}) {
  options.millimetresPerUnit = model.millimetresPerUnit;
  auto bake = bakeMesh(model, options);
  EXPECT_TRUE(bake.has_value());
  return bake ? *bake : nullptr;
}

TEST(MeshBake, FootOfAnEndlessWallSeesHalfTheSky) {
  Model model;
  addSheet(model, {-1e4F, 0, 0}, {2e4F, 0, 0}, {0, 1e4F, 0}, 1);  // a wall at z = 0, facing +Z
  const Model wall = finished(std::move(model));
  EXPECT_NEAR(occlusionAt(wall, {0, 0, 0.5F}, {0, 1, 0}), 0.5F, 0.004F);
  // From either side.
  EXPECT_NEAR(occlusionAt(wall, {0, 0, -0.5F}, {0, 1, 0}), 0.5F, 0.004F);
}

TEST(MeshBake, WallOfKnownHeightHidesItsFormFactor) {
  // An endless wall of height h at a distance d hides (1 − d/√(d² + h²))/2 of a horizontal element's sky.
  const float h = 3.0F;
  Model model;
  addSheet(model, {-1e4F, 0, 0}, {2e4F, 0, 0}, {0, h, 0}, 1);
  const Model wall = finished(std::move(model));
  for (const float d : {1.0F, 2.0F, 4.0F, 8.0F}) {
    const float expected = 1.0F - 0.5F * (1.0F - d / std::sqrt(d * d + h * h));
    EXPECT_NEAR(occlusionAt(wall, {0, 0, d}, {0, 1, 0}), expected, 0.008F) << d;
  }
}

TEST(MeshBake, ParallelRectangleHidesItsFormFactor) {
  // Siegel & Howell, "Thermal Radiation Heat Transfer", configuration 4: an element and a parallel rectangle a × b
  // whose corner lies above it at height c; four of them make one centred above it.
  const float a = 2.0F, b = 3.0F, c = 1.5F;
  Model model;
  addSheet(model, {-a, c, -b}, {2 * a, 0, 0}, {0, 0, 2 * b}, 1);
  const Model lid = finished(std::move(model));
  const float x = a / c, y = b / c, rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
  const float corner = (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * kPi);
  EXPECT_NEAR(occlusionAt(lid, {0, 0, 0}, {0, 1, 0}), 1.0F - 4.0F * corner, 0.004F);
}

TEST(MeshBake, HiddenSkyHasTheRightDirection) {
  // Below a lid that covers the half z > 0 of the sky, light from +Z is gone and light from −Z is not: against
  // quadrature over the hemisphere.
  Model model;
  addSheet(model, {-1e4F, 0, 0}, {2e4F, 0, 0}, {0, 1e4F, 0}, 1);
  const Model wall = finished(std::move(model));
  const Harmonics<float> hidden = hiddenSky(sceneOf(wall), {0, 0, -0.01F}, {0, 1, 0}, RaySet(1024, 90.0F));
  Harmonics<double> expected{};
  const int n = 400;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double y = std::sqrt((j + 0.5) / n), r = std::sqrt(1 - y * y), phi = std::numbers::pi * (i + 0.5) / n;
      const Harmonics<double> basis = harmonicsAt(glm::dvec3(r * std::cos(phi), y, r * std::sin(phi)));
      for (std::size_t k = 0; k < 9; ++k) expected[k] += basis[k] / (2.0 * n * n);
    }
  for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(hidden[k], expected[k], 0.004) << k;
}

TEST(MeshBake, ConvexBodySeesTheWholeSky) {
  const auto bake = bakeOf(makeSphere(64));
  for (const VertexBake& vertex : bake->vertices) EXPECT_EQ(occlusionOf(vertex.hiddenSky), 1.0F);
}

/// What a wall facing +Z receives at the height y above a floor that reaches to z = `depth`, by quadrature over its
/// sky.
Harmonics<double> receivedByWall(double y, double depth) {
  Harmonics<double> received{};
  const int n = 120;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < 2 * n; ++i) {
      const double z = std::sqrt((j + 0.5) / n), r = std::sqrt(1 - z * z), phi = std::numbers::pi * (i + 0.5) / n;
      const glm::dvec3 d(r * std::cos(phi), r * std::sin(phi), z);
      if (d.y < 0.0 && d.z * (y / -d.y) < depth) continue;
      const Harmonics<double> basis = harmonicsAt(d);
      for (std::size_t k = 0; k < 9; ++k) received[k] += basis[k] / (2.0 * n * n);
    }
  return received;
}

TEST(MeshBake, WallSendsOnWhatItReceives) {
  const double height = 3.0, depth = 8.0;
  constexpr int kCells = 40;
  Model model;
  addSheet(model, {-1e3F, 0, 0}, {0, 0, static_cast<float>(depth)}, {2e3F, 0, 0}, kCells);   // the floor
  addSheet(model, {-1e3F, 0, 0}, {2e3F, 0, 0}, {0, static_cast<float>(height), 0}, kCells);  // the wall
  MeshBakeOptions options;
  options.skyRays = 2048;
  const auto bake = bakeOf(finished(std::move(model)), options);
  // The share of a floor element's sky that is the strip of an endless wall at the height y: d y / (2 (d² + y²)^1.5)
  // dy.
  std::vector<Harmonics<double>> received;
  const int steps = 60;
  received.reserve(steps);
  for (int i = 0; i < steps; ++i) received.push_back(receivedByWall(height * (i + 0.5) / steps, depth));
  for (const int cell : {4, 10, 20}) {
    const double d = depth * cell / kCells;
    Harmonics<double> expected{};
    for (int i = 0; i < steps; ++i) {
      const double y = height * (i + 0.5) / steps;
      const double share = d * y / (2.0 * std::pow(d * d + y * y, 1.5)) * height / steps;
      for (std::size_t k = 0; k < 9; ++k) expected[k] += share * received[static_cast<std::size_t>(i)][k];
    }
    const int place = 20 * (kCells + 1) + cell;
    const VertexBake& vertex = bake->vertices[static_cast<std::size_t>(place)];
    for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(vertex.bounce[k], expected[k], 0.002) << "z " << d << ", " << k;
  }
}

TEST(MeshBake, NoLightInAClosedCavity) {
  const auto bake = bakeOf(shell(10.0F, 8.0F));
  for (const VertexBake& vertex : bake->vertices) ASSERT_NEAR(vertex.bounce[0], 0.0F, 1e-3F);
}

TEST(MeshBake, SlabsHaveTheirThickness) {
  for (const float thickness : {0.5F, 1.0F, 2.0F, 4.0F, 8.0F}) {
    const Model model = slab(thickness);
    const auto bake = bakeOf(model);
    for (std::size_t v = 0; v < model.positions.size(); ++v) {
      const bool rim = std::abs(model.positions[v].x) > 12 || std::abs(model.positions[v].y) > 12;
      if (rim) continue;
      ASSERT_NEAR(bake->vertices[v].thicknessMm, thickness, 0.002F * thickness) << v;
    }
  }
}

// On an edge a ray inwards would run along the next face.
TEST(MeshBake, BoxOfFewVerticesHasItsThickness) {
  for (const float thickness : {1.0F, 8.0F}) {
    Model model;
    const glm::vec3 x(200, 0, 0), y(0, 200, 0), z(0, 0, thickness), low(-100, -100, -thickness);
    addSheet(model, low + z, x, y, 1);  // the first four vertices look to +Z
    addSheet(model, low, y, x, 1);
    addSheet(model, low, x, z, 1);
    addSheet(model, low + y, z, x, 1);
    addSheet(model, low, z, y, 1);
    addSheet(model, low + x, y, z, 1);
    MeshBakeOptions options;
    options.millimetresPerUnit = 1.0F;
    const auto made = bakeMesh(finished(std::move(model)), options);
    ASSERT_TRUE(made.has_value()) << made.error().message;
    for (std::size_t v = 0; v < 8; ++v)
      EXPECT_NEAR((*made)->vertices[v].thicknessMm, thickness, 0.02F * thickness) << v;
  }
}

TEST(MeshBake, ThicknessFollowsTheUnit) {
  Model model = slab(4.0F);
  for (glm::vec3& p : model.positions) p *= 0.001F;
  model.millimetresPerUnit = 1000.0F;
  EXPECT_NEAR(bakeOf(model)->vertices[21 * 10 + 10].thicknessMm, 4.0F, 0.01F);
}

TEST(MeshBake, ThicknessOfASphereIsThatOfItsCone) {
  Model model = makeSphere(128);
  model.millimetresPerUnit = 1.0F;
  const auto bake = bakeOf(model);
  for (const std::uint32_t i : model.indices) ASSERT_NEAR(bake->vertices[i].thicknessMm, 1.75F, 0.01F);
}

TEST(MeshBake, ThicknessOfAShellIsItsWall) {
  const Model model = shell(20.0F, 18.0F);
  const auto bake = bakeOf(model);
  for (const std::uint32_t i : model.indices) ASSERT_NEAR(bake->vertices[i].thicknessMm, 2.0F, 0.12F);
}

TEST(MeshBake, OpenSheetIsThick) {
  Model model;
  addSheet(model, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, 8);
  const auto bake = bakeOf(finished(std::move(model)));
  for (const VertexBake& vertex : bake->vertices) EXPECT_EQ(vertex.thicknessMm, kThickestMm);
}

TEST(MeshBake, WhatLiesInsideIsPassedThrough) {
  // A ball of 10 mm inside a slab of 30: the light goes through both.
  Model model = slab(30.0F);
  Model ball = makeSphere(32);
  for (glm::vec3& p : ball.positions) p = p * 5.0F + glm::vec3(0, 0, -15);
  appendModel(model, ball);
  model.millimetresPerUnit = 1.0F;
  EXPECT_NEAR(bakeOf(model)->vertices[21 * 10 + 10].thicknessMm, 30.0F, 0.01F);
}

TEST(MeshBake, BodiesThatTouchAreOne) {
  // A lid of 2 mm over an eyeball's worth of 20: tears fill a narrow gap, a wide one is air.
  for (const float gap : {0.1F, 0.25F, 0.5F, 3.0F}) {
    Model model = slab(2.0F), below = slab(20.0F);
    for (glm::vec3& p : below.positions) p.z -= 2.0F + gap;
    appendModel(model, below);
    model.millimetresPerUnit = 1.0F;
    const float wanted = gap < kContactMm ? 22.0F + gap : 2.0F;
    EXPECT_NEAR(bakeOf(model)->vertices[21 * 10 + 10].thicknessMm, wanted, 0.01F) << gap;
  }
}

TEST(MeshBake, FarSideOfASlabSeesItsOwnSky) {
  const Model model = slab(2.0F);
  const auto bake = bakeOf(model);
  const VertexBake& front = bake->vertices[21 * 10 + 10];
  const Harmonics<float> open = harmonicsAt(glm::vec3(0, 0, -1));
  for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(front.farSky[k], kCosineLobe<float>[k] * open[k], 1e-3F) << k;
}

TEST(MeshBake, FarSideInTheDarkReceivesNothing) {
  // Inside a closed shell there is no sky.
  const Model model = shell(20.0F, 18.0F);
  const auto bake = bakeOf(model);
  for (std::size_t v = 0; v < model.positions.size() / 2; ++v)
    ASSERT_NEAR(bake->vertices[v].farSky[0], 0.0F, 0.01F) << v;
}

TEST(MeshBake, LensesNeitherStopLightNorAreBaked) {
  Model model = makeSphere(32);
  Model lens = makeSphere(32);
  for (glm::vec3& p : lens.positions) p *= 1.1F;
  appendModel(model, lens);
  MeshBakeOptions options;
  options.castingSlots = {true, false};
  const auto bake = bakeOf(model, options);
  EXPECT_EQ(occlusionOf(bake->vertices[40].hiddenSky), 1.0F);
  EXPECT_EQ(bake->vertices.back(), VertexBake{});
  options.castingSlots = {};
  EXPECT_LT(occlusionOf(bakeOf(model, options)->vertices[40].hiddenSky), 0.01F);
}

TEST(MeshBake, SameModelGivesTheSameBytes) {
  const Model model = shell(20.0F, 18.0F);
  EXPECT_EQ(bakeOf(model)->vertices, bakeOf(model)->vertices);
}

TEST(MeshBake, DenseMeshIsBakedInPart) {
  // A ball that hovers over a plane; the plane's occlusion must not depend on how many of its points are baked.
  Model model;
  addSheet(model, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, 120);
  Model ball = makeSphere(32);
  for (glm::vec3& p : ball.positions) p = p * 6.0F + glm::vec3(0, 0, 8);
  model = finished(std::move(model));
  appendModel(model, ball);
  model.millimetresPerUnit = 1.0F;
  MeshBakeOptions few;
  few.mostPoints = 3000;
  const BakePoints points = bakePoints(model, {});
  EXPECT_LE(representatives(points, few.mostPoints).size(), few.mostPoints);
  EXPECT_EQ(representatives(points, 1'000'000).size(), points.positions.size());
  const auto all = bakeOf(model);
  const auto some = bakeOf(model, few);
  const std::size_t planes = 121 * 121;
  for (std::size_t v = 0; v < planes; ++v)
    ASSERT_NEAR(occlusionOf(all->vertices[v].hiddenSky), occlusionOf(some->vertices[v].hiddenSky), 0.05F) << v;
}

TEST(MeshBake, SeamsAreOnePoint) {
  Model model;
  addSheet(model, {-20, -20, 0}, {20, 0, 0}, {0, 40, 0}, 4);
  addSheet(model, {0, -20, 0}, {20, 0, 0}, {0, 40, 0}, 4);
  const BakePoints points = bakePoints(finished(std::move(model)), {});
  EXPECT_EQ(points.ofVertex[4], points.ofVertex[25]);  // the right end of one row, the left end of the other's
  EXPECT_EQ(points.positions.size(), 45U);
}

TEST(MeshBake, CacheHoldsWhatWasBaked) {
  const test::TemporaryFolder folder;
  const Model model = slab(2.0F);
  MeshBakeOptions options;
  options.cacheFolder = folder.path();
  const auto first = bakeOf(model, options);
  options.millimetresPerUnit = model.millimetresPerUnit;
  const auto file = meshBakeFile(model, options);
  ASSERT_TRUE(std::filesystem::exists(file));
  const auto read = readMeshBake(file, model);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->vertices, first->vertices);
  EXPECT_EQ(read->solids, std::vector<std::uint8_t>{0});
  Model larger = model, parted = model;
  larger.positions.emplace_back(0.0F);
  EXPECT_FALSE(readMeshBake(file, larger).has_value());
  parted.parts.emplace_back();
  EXPECT_FALSE(readMeshBake(file, parted).has_value());

  // One bit gone wrong: not taken.
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekg(500);
  const int byte = stream.get();
  stream.seekp(500);
  stream.put(static_cast<char>(byte ^ 4));
  stream.close();
  EXPECT_FALSE(readMeshBake(file, model).has_value());

  // Another model, another file.
  Model moved = model;
  moved.positions.front().x += 1e-4F;
  EXPECT_NE(meshBakeFile(moved, options), file);
  MeshBakeOptions otherUnit = options;
  otherUnit.millimetresPerUnit = 2.0F;
  EXPECT_NE(meshBakeFile(model, otherUnit), file);
}

TEST(MeshBake, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  MeshBakeOptions options;
  options.stop = stop.get_token();
  const auto bake = bakeMesh(slab(2.0F), options);
  ASSERT_FALSE(bake.has_value());
  EXPECT_EQ(bake.error().kind, Error::Kind::Cancelled);
}

TEST(MeshBake, NothingToBakeIsNoError) {
  Model model = slab(2.0F);
  MeshBakeOptions options;
  options.castingSlots = {false};
  const auto bake = bakeOf(model, options);
  EXPECT_EQ(bake->vertices.front(), VertexBake{});
}

float texel(const Image& image, int x, int y) {
  float value = 0.0F;
  std::memcpy(&value, image.pixels.data() + static_cast<std::size_t>(y * image.width + x) * sizeof value, sizeof value);
  return value;
}

TEST(TexelBake, ThicknessLiesWhereTheTextureDoes) {
  // A wedge: 2 mm at u = 0, 6 mm at u = 1, laid out in the lower left quarter of the texture.
  Model model;
  addSheet(model, {-40, -40, 0}, {80, 0, 0}, {0, 80, 0}, 40);
  addSheet(model, {-40, -40, -2}, {0, 80, 0}, {80, 0, -4}, 40);
  const std::size_t front = model.positions.size() / 2;
  for (std::size_t v = 0; v < model.uvs.size(); ++v) model.uvs[v] *= v < front ? 0.5F : 0.0F;
  TexelBakeOptions options;
  options.size = 32;
  options.millimetresPerUnit = 1.0F;
  const auto image = bakeTexels(finished(std::move(model)), "wedge", BakedMap::Thickness, options);
  ASSERT_TRUE(image.has_value());
  // Texel 4 of 16 across: u = 4.5/16. Rows are counted from the top.
  EXPECT_NEAR(texel(*image, 4, 32 - 8), 2.0F + 4.0F * 4.5F / 16.0F, 0.05F);
  EXPECT_NEAR(texel(*image, 11, 32 - 8), 2.0F + 4.0F * 11.5F / 16.0F, 0.05F);
  // Beside the island its rim goes on; nothing is left empty.
  EXPECT_EQ(texel(*image, 18, 32 - 8), texel(*image, 15, 32 - 8));
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) EXPECT_GT(texel(*image, x, y), 0.0F);
}

TEST(TexelBake, OcclusionIsThatOfThePoint) {
  Model model;
  addSheet(model, {-10, 0, -10}, {0, 0, 20}, {20, 0, 0}, 1);  // the floor, facing +Y
  const std::size_t floor = model.positions.size();
  addSheet(model, {-1e3F, 0, -10}, {2e3F, 0, 0}, {0, 1e3F, 0}, 1);  // a wall at its end z = −10
  for (std::size_t v = floor; v < model.uvs.size(); ++v) model.uvs[v] = glm::vec2(0.0F);
  TexelBakeOptions options;
  options.size = 16;
  options.rays = 512;
  const auto image = bakeTexels(finished(std::move(model)), "corner", BakedMap::Occlusion, options);
  ASSERT_TRUE(image.has_value());
  // An endless wall as good as without a top hides half of the sky wherever one stands before it.
  for (const int u : {0, 7, 15}) EXPECT_NEAR(texel(*image, u, 8), 0.5F, 0.02F) << u;
}

TEST(TexelBake, ModelWithoutCoordinatesIsRefused) {
  Model model = slab(2.0F);
  model.hasUvs = false;
  const auto image = bakeTexels(model, "slab.obj", BakedMap::Occlusion, {});
  ASSERT_FALSE(image.has_value());
  EXPECT_EQ(image.error().kind, Error::Kind::Input);
  EXPECT_NE(image.error().message.find("slab.obj"), std::string::npos);
}

}  // namespace
}  // namespace dermis
