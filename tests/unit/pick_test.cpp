// Pointing at a model: the nearest triangle, from either side, with its slot and normal.
#include "core/scene/pick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/primitives.h"

namespace dermis {
namespace {

TEST(Pick, ASphereIsMetWhereItsEquationSays) {
  const Model sphere = makeSphere();
  for (const glm::vec3 from : {glm::vec3(0.0F, 0.0F, 5.0F), glm::vec3(3.0F, 2.0F, -4.0F)}) {
    const glm::vec3 aim(0.1F, -0.2F, 0.15F);
    const glm::vec3 d = glm::normalize(aim - from);
    const auto hit = hitModel(sphere, from, d);
    ASSERT_TRUE(hit.has_value());
    const float b = glm::dot(from, d);
    const float expected = -b - std::sqrt(b * b - glm::dot(from, from) + 1.0F);
    EXPECT_NEAR(hit->distance, expected, 1e-3F);
    EXPECT_NEAR(glm::dot(hit->normal, glm::normalize(hit->position)), 1.0F, 1e-3F);
    EXPECT_EQ(hit->slot, 0U);
  }
}

TEST(Pick, WhatLiesBehindOrBesideIsNotMet) {
  const Model sphere = makeSphere();
  EXPECT_FALSE(hitModel(sphere, {0.0F, 0.0F, 5.0F}, {0.0F, 0.0F, 1.0F}).has_value());
  EXPECT_FALSE(hitModel(sphere, {2.0F, 0.0F, 5.0F}, {0.0F, 0.0F, -1.0F}).has_value());
  // From inside the far side is met, from its back.
  const auto inside = hitModel(sphere, glm::vec3(0.0F), {0.0F, 0.0F, 1.0F});
  ASSERT_TRUE(inside.has_value());
  EXPECT_NEAR(inside->distance, 1.0F, 1e-3F);
}

}  // namespace
}  // namespace dermis
