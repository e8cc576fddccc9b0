// Eyeballs found in meshes made for the purpose.
#include "core/scene/eyeballs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/scene/primitives.h"

namespace dermis {
namespace {

/// A sphere whose cap round `axis` (half angle 25°) is pressed in by a fifth: a hollow iris.
Model hollowEye(const glm::vec3& axis) {
  Model eye = makeSphere(64);
  for (glm::vec3& p : eye.positions)
    if (glm::dot(p, axis) > std::cos(0.436F)) p *= 0.8F;
  return eye;
}

void append(Model& model, const Model& eye, const glm::vec3& centre, float radius) {
  Placement placement;
  placement.translate = centre;
  placement.scale = glm::vec3(radius);
  appendModel(model, eye, placement);
}

/// One part of all triangles.
ModelPart whole(const Model& model) { return {0, 0, static_cast<std::uint32_t>(model.indices.size())}; }

TEST(Eyeballs, APlainSphereLooksAhead) {
  Model model;
  append(model, makeSphere(48), {0.5F, 2.0F, -1.0F}, 3.0F);
  const auto eyes = findEyeballs(model, whole(model));
  ASSERT_EQ(eyes.size(), 1U);
  EXPECT_LT(glm::distance(eyes[0].centre, glm::vec3(0.5F, 2.0F, -1.0F)), 1e-4F);
  EXPECT_NEAR(eyes[0].radius, 3.0F, 1e-4F);
  EXPECT_LT(glm::distance(eyes[0].axis, glm::vec3(0, 0, 1)), 1e-4F);
  // makeSphere's u is 0.5 + φ/2π: one radius sideways is 1/2π turns near the axis, v 1/π.
  EXPECT_NEAR(eyes[0].uvGradient.x, 0.5F / std::numbers::pi_v<float>, 0.01F);
  EXPECT_NEAR(eyes[0].uvGradient.y, 0.0F, 0.003F);
  EXPECT_NEAR(eyes[0].uvGradient.z, 0.0F, 0.003F);
  EXPECT_NEAR(eyes[0].uvGradient.w, 1.0F / std::numbers::pi_v<float>, 0.02F);
}

TEST(Eyeballs, TwoInOneMeshLookWhereTheyLook) {
  const glm::vec3 left = glm::normalize(glm::vec3(0.3F, 0.1F, 1.0F)), right = glm::normalize(glm::vec3(-0.1F, 0.4F, 1));
  Model model;
  append(model, hollowEye(left), {-2.0F, 0.0F, 0.0F}, 0.9F);
  append(model, hollowEye(right), {2.0F, 0.0F, 0.0F}, 1.0F);
  auto eyes = findEyeballs(model, whole(model));
  ASSERT_EQ(eyes.size(), 2U);
  if (eyes[0].centre.x > 0.0F) std::swap(eyes[0], eyes[1]);
  EXPECT_LT(glm::distance(eyes[0].centre, glm::vec3(-2, 0, 0)), 0.01F);
  EXPECT_NEAR(eyes[0].radius, 0.9F, 0.01F) << "the hollow is not part of the sphere";
  EXPECT_NEAR(eyes[1].radius, 1.0F, 0.01F);
  EXPECT_GT(glm::dot(eyes[0].axis, left), std::cos(0.03F));
  EXPECT_GT(glm::dot(eyes[1].axis, right), std::cos(0.03F));
  for (const Eyeball& eye : eyes) {
    EXPECT_NEAR(glm::dot(eye.x(), eye.axis), 0.0F, 1e-5F);
    EXPECT_NEAR(glm::determinant(glm::mat3(eye.x(), eye.y(), eye.axis)), 1.0F, 1e-5F);
  }
}

TEST(Eyeballs, AnOpenBackTellsTheFront) {
  const glm::vec3 axis = glm::normalize(glm::vec3(0.4F, -0.2F, 1.0F));
  Model eye = makeSphere(64);
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < eye.indices.size(); i += 3) {
    const glm::vec3 middle =
        (eye.positions[eye.indices[i]] + eye.positions[eye.indices[i + 1]] + eye.positions[eye.indices[i + 2]]) / 3.0F;
    if (glm::dot(middle, axis) < -0.6F) continue;
    for (std::size_t k = 0; k < 3; ++k) kept.push_back(eye.indices[i + k]);
  }
  eye.indices = kept;
  const auto eyes = findEyeballs(eye, whole(eye));
  ASSERT_EQ(eyes.size(), 1U);
  EXPECT_GT(glm::dot(eyes[0].axis, axis), std::cos(0.1F));
}

TEST(Eyeballs, APieceWithinAnotherIsNoEye) {
  Model model;
  append(model, makeSphere(48), {0, 0, 0}, 1.0F);
  append(model, makeSphere(24), {0, 0, 0.6F}, 0.2F);
  EXPECT_EQ(findEyeballs(model, whole(model)).size(), 1U);
  Model none;
  none.slots.emplace_back();
  EXPECT_TRUE(findEyeballs(none, {0, 0, 0}).empty());
}

}  // namespace
}  // namespace dermis
