// The embedded head as a mesh: closed, whole, laid flat without overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "core/builtin/head/asymmetry.h"
#include "core/builtin/head/head.h"
#include "core/builtin/head/lids.h"
#include "core/builtin/head/polygonise.h"
#include "core/builtin/head/regions.h"
#include "core/builtin/head/remesh.h"
#include "core/builtin/head/sculpt.h"
#include "core/builtin/head/tear_line.h"
#include "core/scene/eyeballs.h"

namespace dermis {
namespace {

using sculpt::kEyeRadius;

const Head& lowHead() {
  static const Head head = makeHead(HeadLevel::Low);
  return head;
}

const ModelPart& face() { return lowHead().model.parts.front(); }

glm::uvec3 faceTriangle(std::uint32_t t) {
  const std::uint32_t* first = &lowHead().model.indices[face().firstIndex + 3 * t];
  return {first[0], first[1], first[2]};
}

/// Vertices at one place as one number.
std::vector<std::uint32_t> places() {
  std::map<std::tuple<float, float, float>, std::uint32_t> known;
  std::vector<std::uint32_t> place;
  for (const glm::vec3& p : lowHead().rest)
    place.push_back(known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(known.size())).first->second);
  return place;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

TEST(HeadMesh, SlotsSizeAndUnitAreThePromisedOnes) {
  const Model& model = lowHead().model;
  ASSERT_EQ(model.slots.size(), 4U);
  EXPECT_EQ(model.slots[0].name, "face");
  EXPECT_EQ(model.slots[1].name, "eye");
  EXPECT_EQ(model.slots[2].name, "lens");
  EXPECT_EQ(model.slots[3].name, "hair");
  EXPECT_EQ(model.millimetresPerUnit, 1000.0F);
  const std::uint32_t triangles = face().indexCount / 3;
  EXPECT_GT(triangles, 24000U);
  EXPECT_LT(triangles, 36000U);
}

TEST(HeadMesh, FaceIsClosedAndInOnePiece) {
  const std::vector<std::uint32_t> place = places();
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::vector<std::uint32_t> parent(place.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto find = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (std::uint32_t t = 0; t < face().indexCount / 3; ++t) {
    const glm::uvec3 v = faceTriangle(t);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = place[v[i]], b = place[v[(i + 1) % 3]];
      ASSERT_NE(a, b);
      ++edges[{a, b}];
      parent[find(a)] = find(b);
    }
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << "an edge has two triangles on one side";
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << "an open edge";
  }
  const std::uint32_t root = find(place[0]);
  for (const std::uint32_t v : place) ASSERT_EQ(find(v), root) << "a second piece";
}

TEST(HeadMesh, FewTrianglesAreThinOrTurnedOver) {
  int slivers = 0, turned = 0;
  const auto count = static_cast<int>(face().indexCount / 3);
  for (std::uint32_t t = 0; t < face().indexCount / 3; ++t) {
    const glm::uvec3 v = faceTriangle(t);
    const auto& rest = lowHead().rest;
    const auto& normals = lowHead().restNormals;
    const glm::vec3 area = glm::cross(rest[v.y] - rest[v.x], rest[v.z] - rest[v.x]);
    const float longest = std::max({glm::distance(rest[v.x], rest[v.y]), glm::distance(rest[v.y], rest[v.z]),
                                    glm::distance(rest[v.z], rest[v.x])});
    // A height under a tenth of the longest side.
    slivers += glm::length(area) < 0.1F * longest * longest ? 1 : 0;
    turned += glm::dot(area, normals[v.x] + normals[v.y] + normals[v.z]) <= 0.0F ? 1 : 0;
  }
  EXPECT_LT(slivers, count / 500);
  EXPECT_LT(turned, count / 500);
}

TEST(HeadMesh, SameBytesEveryTime) {
  // The steps that run on several threads, on the nose alone: the whole head twice would take seconds.
  using namespace sculpt;
  const auto noseOf = [] {
    const Sculpt sculpt;
    const auto nose = [&](const glm::vec3& p) {
      const glm::vec3 q = glm::abs(p - glm::vec3(0.0F, -30.0F, 100.0F)) - glm::vec3(20.0F, 22.0F, 20.0F);
      return std::max(sculpt(p), std::max({q.x, q.y, q.z}));
    };
    Lattice lattice;
    for (int i = 0; i <= 36; ++i) {
      const float at = 1.5F * static_cast<float>(i - 18);
      lattice.planes[0].push_back(at);
      lattice.planes[1].push_back(at - 30.0F);
      lattice.planes[2].push_back(at + 100.0F);
    }
    EdgeLengths lengths;
    lengths.shortest = [](const glm::vec3&) { return 1.5F; };
    lengths.longest = [](const glm::vec3&) { return 4.0F; };
    return remesh(polygonise(nose, lattice), sculpt, lengths);
  };
  const Surface a = noseOf(), b = noseOf();
  EXPECT_GT(a.triangles.size(), 500U);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(HeadMesh, AtlasHasNoOverlapAndStaysInTheSquare) {
  const Model& model = lowHead().model;
  for (std::size_t v = 0; v < lowHead().rest.size(); ++v) {
    ASSERT_GE(std::min(model.uvs[v].x, model.uvs[v].y), 0.0F);
    ASSERT_LE(std::max(model.uvs[v].x, model.uvs[v].y), 1.0F);
  }
  // The middles of a fine grid's cells lie in at most one triangle each.
  constexpr int kGrid = 1500;
  std::vector<std::uint8_t> hits(static_cast<std::size_t>(kGrid) * kGrid, 0);
  int twice = 0;
  for (std::uint32_t t = 0; t < face().indexCount / 3; ++t) {
    const glm::uvec3 v = faceTriangle(t);
    glm::dvec2 p[3];
    for (int i = 0; i < 3; ++i) p[i] = glm::dvec2(model.uvs[v[i]]) * static_cast<double>(kGrid);
    ASSERT_GT(cross(p[1] - p[0], p[2] - p[0]), 0.0) << "a triangle lies on its back";
    const glm::dvec2 low = glm::floor(glm::min(p[0], glm::min(p[1], p[2])));
    const glm::dvec2 high = glm::floor(glm::max(p[0], glm::max(p[1], p[2])));
    for (double y = low.y; y <= high.y; ++y)
      for (double x = low.x; x <= high.x; ++x) {
        const glm::dvec2 at(x + 0.5, y + 0.5);
        bool inside = true;
        for (int i = 0; i < 3; ++i) inside = inside && cross(p[(i + 1) % 3] - p[i], at - p[i]) > 1e-7;
        if (inside) twice += hits[static_cast<std::size_t>(y) * kGrid + static_cast<std::size_t>(x)]++ > 0 ? 1 : 0;
      }
  }
  EXPECT_EQ(twice, 0);
}

TEST(HeadMesh, TexelDensityIsEven) {
  struct Triangle {
    double density, area;
  };
  std::vector<Triangle> triangles;
  double total = 0.0;
  const HeadRegions regions;
  const double scale = static_cast<double>(lowHead().millimetresPerUv);
  for (std::uint32_t t = 0; t < face().indexCount / 3; ++t) {
    const glm::uvec3 v = faceTriangle(t);
    const auto& rest = lowHead().rest;
    if (regions.at((rest[v.x] + rest[v.y] + rest[v.z]) / 3.0F)[HeadRegion::Hidden] > 0.5F) continue;
    const auto& uvs = lowHead().model.uvs;
    const double onSkin =
        0.5 * static_cast<double>(glm::length(glm::cross(rest[v.y] - rest[v.x], rest[v.z] - rest[v.x])));
    const double flat = 0.5 * cross(glm::dvec2(uvs[v.y] - uvs[v.x]), glm::dvec2(uvs[v.z] - uvs[v.x])) * scale * scale;
    triangles.push_back({flat / std::max(onSkin, 1e-6), onSkin});
    total += onSkin;
  }
  std::sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) { return a.density < b.density; });
  const auto percentile = [&](double share) {
    double sum = 0.0;
    for (const Triangle& t : triangles)
      if ((sum += t.area) >= share * total) return t.density;
    return triangles.back().density;
  };
  // Texels a mm² over the median: between 2 % and 98 % of the visible skin.
  EXPECT_GT(percentile(0.02) / percentile(0.5), 0.4);
  EXPECT_LT(percentile(0.98) / percentile(0.5), 2.0);
}

TEST(HeadMesh, NothingCutsTheEyeballs) {
  // Lids and caruncle as triangles, not only as a form; in the socket behind, where the mesh is coarse and nobody
  // looks, a chord may come nearer.
  const HeadRegions regions;
  const Model& model = lowHead().model;
  constexpr float kMillimetres = 1000.0F;
  const std::vector<Eyeball> eyes = findEyeballs(model, model.parts[1]);
  int near = 0;
  for (std::uint32_t t = 0; t < face().indexCount / 3; ++t) {
    const glm::uvec3 v = faceTriangle(t);
    const glm::vec3 rest = (lowHead().rest[v.x] + lowHead().rest[v.y] + lowHead().rest[v.z]) / 3.0F;
    const float least = regions.at(rest)[HeadRegion::Hidden] > 0.5F ? kEyeRadius - 0.5F : kEyeRadius - 0.1F;
    for (const glm::vec3 weights :
         {glm::vec3(1, 0, 0), {0.5F, 0.5F, 0}, {0, 0.5F, 0.5F}, {0.5F, 0, 0.5F}, {0.34F, 0.33F, 0.33F}}) {
      const glm::vec3 p =
          weights.x * model.positions[v.x] + weights.y * model.positions[v.y] + weights.z * model.positions[v.z];
      for (const Eyeball& eye : eyes) {
        const float distance = kMillimetres * glm::distance(p, eye.centre);
        ASSERT_GT(distance, least) << rest.x << " " << rest.y << " " << rest.z;
        near += distance < kEyeRadius + 0.5F ? 1 : 0;
      }
    }
  }
  EXPECT_GT(near, 500) << "the lids lie on the eyes";
}

TEST(HeadHairs, AreClosedGrowFromTheSkinAndKeepOutOfTheEyes) {
  const Model& model = lowHead().model;
  const ModelPart& part = model.parts[3];
  ASSERT_EQ(model.slots[part.slot].name, "hair");
  // By place: tangents may have split vertices.
  std::map<std::tuple<float, float, float>, std::uint32_t> known;
  std::vector<glm::vec3> places;
  const auto placeOf = [&](std::uint32_t vertex) {
    const glm::vec3& p = model.positions[vertex];
    const auto [at, isNew] = known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(places.size()));
    if (isNew) places.push_back(p);
    return at->second;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; i += 3)
    for (std::uint32_t k = 0; k < 3; ++k)
      ++edges[{placeOf(model.indices[i + k]), placeOf(model.indices[i + (k + 1) % 3])}];
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << "a tube is open";
  }
  const std::vector<Eyeball> eyes = findEyeballs(model, model.parts[1]);
  float highest = -1.0F, lowest = 1.0F;
  for (const glm::vec3& p : places) {
    for (const Eyeball& eye : eyes) ASSERT_GT(glm::distance(p, eye.centre), 0.0122F);
    highest = std::max(highest, p.y);
    lowest = std::min(lowest, p.y);
  }
  EXPECT_LT(highest, 0.040F);
  EXPECT_GT(lowest, -0.020F);
}

TEST(HeadTears, StandBetweenTheLowerLidsAndTheEyeballs) {
  const sculpt::Sculpt sculpt;
  const Model tears = sculpt::makeTearLine(sculpt, 40);
  ASSERT_FALSE(tears.positions.empty());
  float low = 0.0F, high = -10.0F;  // of the left strip's middle
  for (std::size_t v = 0; v < tears.positions.size(); ++v) {
    const bool left = tears.positions[v].x > 0.0F;
    const glm::vec3 centre((left ? 1.0F : -1.0F) * sculpt::kEyeCentre.x, sculpt::kEyeCentre.y, sculpt::kEyeCentre.z);
    const glm::vec3 off = tears.positions[v] - sculpt::asymmetrical(centre);  // one translation round each eye
    EXPECT_GT(glm::length(off), kEyeRadius - 0.01F) << "not in the eyeball";
    EXPECT_LT(glm::length(off), kEyeRadius + 1.3F) << "on the lid's margin at most";
    EXPECT_GT(sculpt(centre + off), -0.1F) << "not in the lid";
    EXPECT_LT(sculpt(centre + off), 0.5F) << "nor over the eye";
    EXPECT_GT(std::max(tears.normals[v].y, tears.normals[v].z), 0.5F) << "looks ahead or upwards";
    if (!left || std::abs(off.x) > 1.0F) continue;
    low = std::min(low, off.y);
    high = std::max(high, off.y);
  }
  EXPECT_GT(high - low, 0.2F);
  EXPECT_LT(high - low, 0.8F);
}

TEST(HeadMesh, RendererFindsTheEyes) {
  const std::vector<Eyeball> eyes = findEyeballs(lowHead().model, lowHead().model.parts[1]);
  ASSERT_EQ(eyes.size(), 2U);
  for (const Eyeball& eye : eyes) {
    EXPECT_NEAR(eye.radius, 0.012F, 1e-4F);
    EXPECT_GT(eye.axis.z, 0.999F);
    EXPECT_NEAR(std::abs(eye.centre.x), 0.0315F, 0.001F);
    EXPECT_GT(glm::length(eye.uvGradient), 0.05F);
  }
}

TEST(HeadAtlasMaps, TexelsHoldTheRestPositionOfTheirTriangle) {
  const HeadAtlas atlas = rasteriseHead(lowHead(), 256);
  ASSERT_EQ(atlas.rest.size(), 256U * 256U);
  EXPECT_NEAR(atlas.millimetresPerTexel * 256.0F, lowHead().millimetresPerUv, 1e-2F);
  // A vertex's texel is near its rest position, wherever it isn't on a border.
  int checked = 0;
  for (std::size_t v = 0; v < lowHead().rest.size(); v += 7) {
    const glm::vec2 uv = lowHead().model.uvs[v];
    const auto x = static_cast<std::size_t>(uv.x * 256.0F), y = static_cast<std::size_t>((1.0F - uv.y) * 256.0F);
    const std::size_t i = y * 256 + x;
    if (atlas.covered[i] != 2) continue;
    ++checked;
    ASSERT_LT(glm::distance(atlas.rest[i], lowHead().rest[v]), 16.0F);
  }
  EXPECT_GT(checked, 1000);
}

}  // namespace
}  // namespace dermis
