// Fewer triangles: of the model's own vertices, as near to its surface as was said, whole where it must be.
#include "core/scene/coarse_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/scene/primitives.h"

namespace dermis {
namespace {

double area(const Model& model, const std::vector<std::uint32_t>& indices) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 a(model.positions[indices[i]]), b(model.positions[indices[i + 1]]),
        c(model.positions[indices[i + 2]]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

TEST(CoarseMesh, ASphereStaysRoundWithAQuarterOfItsTriangles) {
  const Model model = makeSphere(256);
  const std::vector<CoarseMesh> levels = coarseMeshes(model, 0.004F);
  ASSERT_EQ(levels.size(), 2U);
  std::size_t before = model.indices.size();
  for (const CoarseMesh& level : levels) {
    EXPECT_LT(level.indices.size(), before / 3);
    EXPECT_GT(level.error, 0.0F);
    // The deepest place of a triangle of a ball is its middle: checked here against the radius, not by what made it.
    double deepest = 0.0;
    for (std::size_t i = 0; i + 2 < level.indices.size(); i += 3) {
      const glm::dvec3 middle =
          (glm::dvec3(model.positions[level.indices[i]]) + glm::dvec3(model.positions[level.indices[i + 1]]) +
           glm::dvec3(model.positions[level.indices[i + 2]])) /
          3.0;
      deepest = std::max(deepest, 1.0 - glm::length(middle));
    }
    EXPECT_LT(deepest, 4.0 * level.error);
    EXPECT_NEAR(area(model, level.indices) / area(model, model.indices), 1.0, 0.01);
    before = level.indices.size();
  }
  EXPECT_GT(levels[1].error, levels[0].error);
}

TEST(CoarseMesh, ListsEachPartsVerticesOnce) {
  Model model = makeSphere(96);
  appendModel(model, makeSphere(64), {glm::vec3(0.5F), {}, {3.0F, 0.0F, 0.0F}});
  const std::vector<CoarseMesh> levels = coarseMeshes(model, 0.01F);
  ASSERT_FALSE(levels.empty());
  std::set<std::uint32_t> finer;
  for (const std::uint32_t index : model.indices) finer.insert(index);
  for (const CoarseMesh& level : levels) {
    ASSERT_EQ(level.parts.size(), model.parts.size());
    std::set<std::uint32_t> all;
    for (std::size_t i = 0; i < level.parts.size(); ++i) {
      const CoarseMesh::Part& part = level.parts[i];
      const auto index = level.indices.begin() + part.firstIndex;
      const auto vertex = level.vertices.begin() + part.firstVertex;
      const std::set<std::uint32_t> used(index, index + part.indexCount);
      EXPECT_TRUE(std::equal(used.begin(), used.end(), vertex, vertex + part.vertexCount));
      EXPECT_GT(part.indexCount, 0U);
      all.insert(used.begin(), used.end());
    }
    // Each level is made of vertices of the one before: light that those hold is this one's too.
    EXPECT_TRUE(std::includes(finer.begin(), finer.end(), all.begin(), all.end()));
    finer = all;
  }
}

/// Ribbons of eight squares, far apart.
Model ribbons(int count) {
  Model model = makePlane();
  model.positions.clear();
  model.indices.clear();
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < 9; ++j) {
      const auto at = static_cast<std::uint32_t>(model.positions.size());
      for (const float side : {0.0F, 0.001F})
        model.positions.emplace_back(static_cast<float>(i) + side, 0.1F * static_cast<float>(j), 0.0F);
      if (j < 8) model.indices.insert(model.indices.end(), {at, at + 1, at + 2, at + 1, at + 3, at + 2});
    }
  model.parts.front().indexCount = static_cast<std::uint32_t>(model.indices.size());
  return model;
}

TEST(CoarseMesh, HairsLoseNothing) {
  EXPECT_TRUE(coarseMeshes(ribbons(200), 0.1F).empty());
  // Beside a head they are drawn whole, and the head is not.
  Model model = makeSphere(128);
  const auto first = static_cast<std::uint32_t>(model.positions.size());
  const Model hairs = ribbons(200);
  model.positions.insert(model.positions.end(), hairs.positions.begin(), hairs.positions.end());
  model.parts.push_back({0, static_cast<std::uint32_t>(model.indices.size()), hairs.parts.front().indexCount});
  for (const std::uint32_t index : hairs.indices) model.indices.push_back(first + index);
  const std::vector<CoarseMesh> levels = coarseMeshes(model, 0.01F);
  ASSERT_FALSE(levels.empty());
  EXPECT_LT(levels[0].parts[0].indexCount, model.parts[0].indexCount / 3);
  EXPECT_EQ(levels[0].parts[1].indexCount, model.parts[1].indexCount);
}

TEST(CoarseMesh, OpenBordersStay) {
  // A flat plate loses all of its inside, its corners and edges don't move.
  Model model = makePlane();
  model.positions.clear();
  model.indices.clear();
  constexpr std::uint32_t kSide = 33;
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      model.positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
      const std::uint32_t at = y * kSide + x;
      if (x + 1 < kSide && y + 1 < kSide)
        model.indices.insert(model.indices.end(), {at, at + 1, at + kSide, at + 1, at + kSide + 1, at + kSide});
    }
  model.parts.front().indexCount = static_cast<std::uint32_t>(model.indices.size());
  const std::vector<CoarseMesh> levels = coarseMeshes(model, 0.01F);
  ASSERT_FALSE(levels.empty());
  EXPECT_NEAR(area(model, levels.back().indices), 1024.0, 1e-6);
  const std::set<std::uint32_t> used(levels.back().vertices.begin(), levels.back().vertices.end());
  for (std::uint32_t i = 0; i < kSide; ++i)
    for (const std::uint32_t edge : {i, (kSide - 1) * kSide + i, i * kSide, i * kSide + kSide - 1})
      EXPECT_TRUE(used.contains(edge)) << edge;
}

TEST(CoarseMesh, ModelsWithoutTrianglesHaveNone) {
  Model model = makePlane();
  model.indices.clear();
  model.parts.front().indexCount = 0;
  EXPECT_TRUE(coarseMeshes(model, 1.0F).empty());
}

}  // namespace
}  // namespace dermis
