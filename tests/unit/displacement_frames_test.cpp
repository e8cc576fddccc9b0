// What displacement reads of a mesh, against the formulas of a sphere and a plane.
#include "core/scene/displacement_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/scene/primitives.h"

namespace dermis {
namespace {

TEST(DisplacementFrames, APlanesParametrizationHasItsScale) {
  const DisplacementFrames frames = displacementFrames(makePlane());
  ASSERT_EQ(frames.vertices.size(), 4U);
  for (const DisplacementFrame& frame : frames.vertices) {
    EXPECT_NEAR(glm::length(frame.gradientU - glm::vec4(0.5F, 0, 0, 0)), 0.0F, 1e-6F) << "u grows by 1 over 2 units";
    EXPECT_NEAR(glm::length(frame.gradientV - glm::vec4(0, 0.5F, 0, 0)), 0.0F, 1e-6F);
    EXPECT_NEAR(glm::length(frame.directionCurvature - glm::vec4(0, 0, 1, 0)), 0.0F, 1e-6F);
  }
  EXPECT_NEAR(frames.parts.at(0).uvPerUnit, 0.5F, 1e-6F);
  EXPECT_NEAR(frames.parts.at(0).meanEdge, std::sqrt((4.0 + 4.0 + 8.0) / 3.0), 1e-5);
  EXPECT_TRUE(frames.seams.empty());
}

TEST(DisplacementFrames, ASpheresGradientsAndCurvature) {
  Model sphere = makeSphere(96);
  for (glm::vec3& p : sphere.positions) p *= 3.0F;
  const DisplacementFrames frames = displacementFrames(sphere);
  const float pi = std::numbers::pi_v<float>;
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
    const glm::vec3 n = sphere.normals[i];
    const DisplacementFrame& frame = frames.vertices[i];
    EXPECT_NEAR(glm::dot(glm::vec3(frame.directionCurvature), n), 1.0F, 1e-5F);
    EXPECT_NEAR(frame.directionCurvature.w, 1.0F / 3.0F, 0.002F);
    if (std::abs(n.y) > 0.8F) continue;
    const float s = std::sqrt(1.0F - n.y * n.y);
    // Cut at u = 0 and 1, where a vertex has triangles on one side only: first-order there.
    const bool cut = sphere.uvs[i].x == 0.0F || sphere.uvs[i].x == 1.0F;
    const glm::vec3 wantU = glm::vec3(n.z, 0.0F, -n.x) / (s * 2.0F * pi * 3.0F * s);
    const glm::vec3 wantV = (glm::vec3(0, 1, 0) - n * n.y) / (s * pi * 3.0F);
    EXPECT_LT(glm::length(glm::vec3(frame.gradientU) - wantU), (cut ? 0.05F : 0.01F) * glm::length(wantU));
    EXPECT_LT(glm::length(glm::vec3(frame.gradientV) - wantV), (cut ? 0.05F : 0.01F) * glm::length(wantV));
  }
}

TEST(DisplacementFrames, BothSidesOfASeamReadTheSamePlaces) {
  const Model sphere = makeSphere(16);
  const DisplacementFrames frames = displacementFrames(sphere);
  ASSERT_EQ(frames.seamOfTriangle.size(), sphere.indices.size() / 3);
  // Each directed border of a triangle, by the places of its ends, with the coordinates that it reads at them.
  struct Border {
    glm::vec3 a, b;
    glm::vec2 uvA, uvB, cornerA;
  };
  std::vector<Border> borders;
  for (std::size_t t = 0; t < frames.seamOfTriangle.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const std::uint32_t* v = &sphere.indices[3 * t];
      Border border{sphere.positions[v[j]], sphere.positions[v[k]], sphere.uvs[v[j]], sphere.uvs[v[k]],
                    sphere.uvs[v[j]]};
      if (const std::uint32_t seam = frames.seamOfTriangle[t]; seam != 0) {
        const DisplacementSeam& read = frames.seams.at(seam - 1);
        border.uvA = read.edge[i][0];
        border.uvB = read.edge[i][1];
        border.cornerA = read.corner[j];
      }
      borders.push_back(border);
    }
  const auto same = [](const glm::vec3& a, const glm::vec3& b) { return glm::distance(a, b) < 1e-6F; };
  int pairs = 0, cut = 0;
  for (const Border& x : borders)
    for (const Border& y : borders) {
      if (same(x.a, y.a)) {
        EXPECT_EQ(x.cornerA, y.cornerA) << "every triangle at a place";
      }
      if (!same(x.a, y.b) || !same(x.b, y.a)) continue;
      ++pairs;
      EXPECT_EQ(x.uvA, y.uvB);
      EXPECT_EQ(x.uvB, y.uvA);
      cut += x.a.z < -0.1F && std::abs(x.a.x) < 1e-6F && std::abs(x.b.x) < 1e-6F ? 1 : 0;
    }
  EXPECT_EQ(pairs, static_cast<int>(borders.size())) << "a closed mesh";
  EXPECT_GT(cut, 0);
  EXPECT_GE(frames.seams.size(), 14U);
}

}  // namespace
}  // namespace dermis
