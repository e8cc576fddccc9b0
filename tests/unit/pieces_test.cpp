// What hangs together, and what bounds a solid: of shapes whose answer is known.
#include "core/scene/pieces.h"

#include <gtest/gtest.h>

#include <set>
#include <span>

#include "core/scene/primitives.h"

namespace dermis {
namespace {

bool isSolid(const Model& model) { return boundsSolids(model.positions, model.indices); }

std::size_t piecesIn(const Model& model) {
  const Pieces pieces = piecesOf(model.positions, model.indices);
  std::set<unsigned> found;
  for (const std::uint32_t index : model.indices) found.insert(pieces.piece[pieces.point[index]]);
  return found.size();
}

Model twoBalls() {
  Model model = makeSphere(32);
  appendModel(model, makeSphere(16), {glm::vec3(0.5F), {}, {4.0F, 0.0F, 0.0F}});
  return model;
}

/// Turns the triangles from `first` on the other way round.
Model turned(Model model, std::size_t first = 0) {
  for (std::size_t i = first; i + 2 < model.indices.size(); i += 3) std::swap(model.indices[i], model.indices[i + 1]);
  return model;
}

TEST(Pieces, SeamsDontPartWhatLiesTogether) {
  EXPECT_EQ(piecesIn(makeSphere(32)), 1U);
  EXPECT_EQ(piecesIn(twoBalls()), 2U);
}

TEST(Pieces, ABallIsSolidWhereverItStands) {
  EXPECT_TRUE(isSolid(makeSphere(32)));
  EXPECT_TRUE(isSolid(twoBalls()));
  Model far = makePlane();  // makes room before the ball
  far.indices.clear();
  appendModel(far, makeSphere(32), {glm::vec3(2.0F), {}, {-8.0F, 16.0F, 32.0F}});
  EXPECT_TRUE(isSolid(far));
}

TEST(Pieces, WhatIsOpenIsNotSolid) {
  EXPECT_FALSE(isSolid(makePlane()));
  Model holed = makeSphere(32);
  holed.indices.resize(holed.indices.size() / 2 / 3 * 3);
  EXPECT_FALSE(isSolid(holed));
  EXPECT_FALSE(isSolid(Model{}));
}

TEST(Pieces, WhatFacesInwardsIsNotSolid) {
  EXPECT_FALSE(isSolid(turned(makeSphere(32))));
  EXPECT_FALSE(isSolid(turned(twoBalls(), makeSphere(32).indices.size()))) << "the second ball alone";
  const Model ball = makeSphere(32);
  EXPECT_FALSE(isSolid(turned(ball, ball.indices.size() - 3))) << "a single triangle, away from the pole";
}

}  // namespace
}  // namespace dermis
