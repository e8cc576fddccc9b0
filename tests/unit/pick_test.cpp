// Pointing at a model: the nearest triangle, from either side, with its slot and normal.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/bake/surface_picker.h"
#include "core/scene/primitives.h"

namespace dermis {
namespace {

SurfacePicker pickerOf(const Model& model) {
  auto made = SurfacePicker::create(std::make_shared<const Model>(model));
  EXPECT_TRUE(made.has_value());
  return std::move(*made);
}

/// Every triangle of the model on its own: Möller & Trumbore 1997, without culling.
std::optional<std::pair<float, std::uint32_t>> nearestOfAll(const Model& model, const glm::vec3& o,
                                                            const glm::vec3& d) {
  std::optional<std::pair<float, std::uint32_t>> best;
  for (const ModelPart& part : model.parts)
    for (std::size_t i = part.firstIndex; i + 2 < std::size_t{part.firstIndex} + part.indexCount; i += 3) {
      const glm::vec3 a = model.positions[model.indices[i]];
      const glm::vec3 ab = model.positions[model.indices[i + 1]] - a;
      const glm::vec3 ac = model.positions[model.indices[i + 2]] - a;
      const glm::vec3 p = glm::cross(d, ac);
      const float determinant = glm::dot(ab, p);
      if (determinant == 0.0F) continue;
      const float u = glm::dot(o - a, p) / determinant;
      const glm::vec3 q = glm::cross(o - a, ab);
      const float v = glm::dot(d, q) / determinant;
      const float t = glm::dot(ac, q) / determinant;
      if (u < 0.0F || v < 0.0F || u + v > 1.0F || t <= 0.0F) continue;
      if (!best || t < best->first) best = {t, part.slot};
    }
  return best;
}

TEST(Pick, ASphereIsMetWhereItsEquationSays) {
  const SurfacePicker sphere = pickerOf(makeSphere());
  for (const glm::vec3 from : {glm::vec3(0.0F, 0.0F, 5.0F), glm::vec3(3.0F, 2.0F, -4.0F)}) {
    const glm::vec3 aim(0.1F, -0.2F, 0.15F);
    const glm::vec3 d = glm::normalize(aim - from);
    const auto hit = sphere.hit(from, d);
    ASSERT_TRUE(hit.has_value());
    const float b = glm::dot(from, d);
    const float expected = -b - std::sqrt(b * b - glm::dot(from, from) + 1.0F);
    EXPECT_NEAR(hit->distance, expected, 1e-3F);
    EXPECT_NEAR(glm::dot(hit->normal, glm::normalize(hit->position)), 1.0F, 1e-3F);
    EXPECT_EQ(hit->slot, 0U);
  }
}

TEST(Pick, WhatLiesBehindOrBesideIsNotMet) {
  const SurfacePicker sphere = pickerOf(makeSphere());
  EXPECT_FALSE(sphere.hit({0.0F, 0.0F, 5.0F}, {0.0F, 0.0F, 1.0F}).has_value());
  EXPECT_FALSE(sphere.hit({2.0F, 0.0F, 5.0F}, {0.0F, 0.0F, -1.0F}).has_value());
  // From inside the far side is met, from its back.
  const auto inside = sphere.hit(glm::vec3(0.0F), {0.0F, 0.0F, 1.0F});
  ASSERT_TRUE(inside.has_value());
  EXPECT_NEAR(inside->distance, 1.0F, 1e-3F);
}

TEST(Pick, OfSeveralPartsTheNearestIsMetWithItsSlot) {
  // A sphere in three parts that wear different slots, one of them empty.
  Model model = makeSphere();
  const auto third = static_cast<std::uint32_t>(model.indices.size() / 9 * 3);
  const auto all = static_cast<std::uint32_t>(model.indices.size());
  model.slots.resize(3);
  model.parts = {{.slot = 2, .firstIndex = 0, .indexCount = third},
                 {.slot = 1, .firstIndex = third, .indexCount = 0},
                 {.slot = 0, .firstIndex = third, .indexCount = all - third}};
  const SurfacePicker picker = pickerOf(model);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> anywhere(-1.5F, 1.5F);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 from(anywhere(random), anywhere(random), anywhere(random));
    const glm::vec3 d = glm::normalize(glm::vec3(anywhere(random), anywhere(random), anywhere(random)));
    const auto expected = nearestOfAll(model, from, d);
    const auto hit = picker.hit(from, d);
    ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
    if (!hit) continue;
    ++met;
    EXPECT_NEAR(hit->distance, expected->first, 1e-4F) << i;
    EXPECT_EQ(hit->slot, expected->second) << i;
  }
  EXPECT_GT(met, 50);
}

}  // namespace
}  // namespace dermis
