#include "core/builtin/head/hairs.h"

#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/builtin/head/asymmetry.h"
#include "core/builtin/head/brow.h"
#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {
namespace {

constexpr glm::vec3 kUp(0, 1, 0);

/// Roots begin over the skin by half the width of a pixel: one inside it would be taken for the body's far side.
constexpr float kOffSkin = 0.16F;
/// Over what length the skin's normal is taken under a hair, mm.
constexpr float kSlopeDelta = 0.6F;

struct Hair {
  std::vector<glm::vec3> points;  ///< from the root to the tip, left side, in the symmetrical head
  float radius = 0.05F;           ///< mm at the root
};

/// Where the skin is met first from the front.
glm::vec3 onFront(const Sculpt& sculpt, float x, float y) {
  constexpr float kFrom = 128.0F, kTo = 40.0F, kClose = 0.02F;
  glm::vec3 p(x, y, kFrom);
  for (float d = sculpt(p); d > kClose && p.z > kTo; d = sculpt(p)) p.z -= std::max(0.6F * d, kClose);
  return p;
}

/// A unit direction in the skin's plane, turned counter-clockwise as seen from outside.
glm::vec3 turnedAbout(const glm::vec3& normal, const glm::vec3& direction, float angle) {
  return std::cos(angle) * direction + std::sin(angle) * glm::cross(normal, direction);
}

/// A hair that stays near the skin: it sets out along `direction`, turns by `bend` radians about the skin's normal and
/// leaves the skin by `lift` mm at the tip.
Hair lyingHair(const Sculpt& sculpt, const glm::vec3& root, glm::vec3 direction, float bend, float length, float lift,
               int pieces) {
  constexpr float kMostStep = 2.0F;
  Hair hair;
  glm::vec3 p = root;
  for (int i = 0; i <= pieces; ++i) {
    const float along = static_cast<float>(i) / static_cast<float>(pieces);
    const Sculpt::Slope slope = sculpt.slope(p, kSlopeDelta);
    p = slope.onSkin(p, kMostStep);
    const glm::vec3 normal = glm::normalize(slope.gradient);
    hair.points.push_back(p + normal * (kOffSkin + lift * (1.0F - squared(1.0F - along))));
    direction = turnedAbout(normal, glm::normalize(direction - normal * glm::dot(direction, normal)),
                            bend / static_cast<float>(pieces));
    p += direction * (length / static_cast<float>(pieces));
  }
  return hair;
}

/// Hairs of one brow. They rise at the nose, lean outwards along the brow, and from above and below meet on its ridge.
void growBrow(const Sculpt& sculpt, Random& random, int pieces, std::vector<Hair>& hairs) {
  constexpr int kCount = 480;
  const Brow brow;
  for (int i = 0; i < kCount; ++i) {
    // About even along the brow in space, and more in the middle than at the edges.
    const float x = glm::mix(8.0F, 54.0F, std::pow(random.next(), 0.95F));
    const float over = random.next() + random.next() - 1.0F;  // −1 below, 1 above
    const float along = ramp(9.0F, 54.0F, x);
    const float y = brow.height(x) + (0.95F * over - 0.1F) * brow.halfWidth(x);
    const float rise = glm::mix(1.25F, 0.45F, ramp(8.0F, 19.0F, x)) - 0.35F * ramp(19.0F, 48.0F, x);
    const float meet = -0.42F * over * ramp(11.0F, 24.0F, x);
    const float angle = rise + meet + random.between(-0.2F, 0.2F);
    const float length = random.between(0.75F, 1.15F) * glm::mix(6.2F, 8.2F, bell(along - 0.45F, 0.35F)) *
                         (1.0F - 0.35F * ramp(0.8F, 1.0F, along));
    // Along the brow in space: its tail lies on the side of the head, where its front view is short.
    const glm::vec3 root = onFront(sculpt, x, y);
    const glm::vec3 outwards = glm::normalize(onFront(sculpt, x + 1.0F, y + brow.slope(x)) - root);
    const glm::vec3 normal = glm::normalize(sculpt.slope(root, kSlopeDelta).gradient);
    Hair hair = lyingHair(sculpt, root, turnedAbout(normal, outwards, angle), -0.35F - 0.25F * random.next(), length,
                          random.between(0.35F, 1.0F), pieces);
    hair.radius = random.between(0.045F, 0.07F);
    hairs.push_back(std::move(hair));
  }
}

/// One row of lashes; they stand in tufts whose tips meet.
void growLashes(const Sculpt& sculpt, Random& random, bool upper, int pieces, std::vector<Hair>& hairs) {
  const int count = upper ? 110 : 62;
  constexpr float kFrom = -11.5F, kTo = 13.0F, kTuft = 1.35F;
  for (int i = 0; i < count; ++i) {
    const float share = (static_cast<float>(i) + random.next()) / static_cast<float>(count);
    const float x = glm::mix(kFrom, kTo, share);
    const float edge = upper ? sculpt.lids().upperEdge(x) : sculpt.lids().lowerEdge(x);
    const float offEdge = upper ? random.between(0.25F, 0.85F) : -random.between(0.55F, 0.9F);
    const glm::vec3 root = onFront(sculpt, kEyeCentre.x + x, kEyeCentre.y + edge + offEdge);
    const glm::vec3 ahead = glm::normalize(glm::vec3(0.55F, 0.35F, 1.0F) * (root - kEyeCentre));
    const float middle = (std::round(x / kTuft) - x / kTuft) * kTuft;  // to the tuft's middle
    const float fan = 0.5F * x / 13.0F + 0.10F + random.between(-0.09F, 0.09F);
    // Longest past the middle, short at the nose.
    const float profile = 0.5F + 0.5F * bell(x - 5.0F, 11.0F);
    const float length = (upper ? 8.8F : 4.6F) * profile * random.between(0.7F, 1.08F);
    const float curl = random.between(0.85F, 1.15F);
    Hair hair;
    hair.radius = upper ? random.between(0.055F, 0.075F) : random.between(0.032F, 0.048F);
    glm::vec3 p = root + kOffSkin * ahead;
    for (int k = 0; k <= pieces; ++k) {
      hair.points.push_back(p);
      const float t = (static_cast<float>(k) + 0.5F) / static_cast<float>(pieces);
      const float up = upper ? -0.5F + 1.65F * curl * t : -0.95F + 0.75F * curl * t;
      const glm::vec3 direction = glm::normalize(ahead + up * kUp + glm::vec3(fan, 0, 0));
      p += direction * (length / static_cast<float>(pieces));
      p.x += 0.75F * middle / static_cast<float>(pieces);
    }
    hairs.push_back(std::move(hair));
  }
}

/// Three-sided tubes that end in a point.
void addTube(Model& model, const Hair& hair, bool left, float u) {
  constexpr std::uint32_t kSides = 3;
  const auto first = static_cast<std::uint32_t>(model.positions.size());
  std::vector<glm::vec3> line;
  for (const glm::vec3& p : hair.points) line.push_back(asymmetrical({left ? p.x : -p.x, p.y, p.z}));
  const std::size_t last = line.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const glm::vec3 along = glm::normalize(line[std::min(i + 1, last)] - line[i == 0 ? 0 : i - 1]);
    const glm::vec3 a = glm::normalize(glm::cross(along, std::abs(along.x) < 0.8F ? glm::vec3(1, 0, 0) : kUp));
    const glm::vec3 b = glm::cross(along, a);
    const float v = static_cast<float>(i) / static_cast<float>(last);
    const float radius = hair.radius * (1.0F - 0.8F * v * v);
    for (std::uint32_t side = 0; side < (i == last ? 1 : kSides); ++side) {
      const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(side) / kSides;
      const glm::vec3 out = std::cos(angle) * a + std::sin(angle) * b;
      model.positions.push_back(i == last ? line[i] : line[i] + radius * out);
      model.normals.push_back(i == last ? along : out);
      model.uvs.emplace_back(u + 0.002F * static_cast<float>(side), v);
    }
  }
  const auto triangle = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    model.indices.insert(model.indices.end(), {first + p, first + q, first + r});
  };
  triangle(0, 2, 1);  // the root
  for (std::uint32_t i = 0; i < last; ++i)
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t next = (side + 1) % kSides, here = i * kSides;
      if (i + 1 == last) {
        triangle(here + side, here + next, here + kSides);
      } else {
        triangle(here + side, here + next, here + kSides + next);
        triangle(here + side, here + kSides + next, here + kSides + side);
      }
    }
}

}  // namespace

Model makeHairs(const Sculpt& sculpt, int pieces) {
  Model model;
  model.slots.push_back({"hair", Material{}});
  Random random(1871);
  for (const bool left : {true, false}) {
    std::vector<Hair> hairs;
    growBrow(sculpt, random, pieces, hairs);
    growLashes(sculpt, random, true, pieces + 1, hairs);
    growLashes(sculpt, random, false, pieces, hairs);
    for (const Hair& hair : hairs) addTube(model, hair, left, random.next());
  }
  for (const glm::vec3& p : model.positions) model.bounds.grow(p);
  model.tangents.resize(model.positions.size(), glm::vec4(0.0F));
  model.parts = {{0, 0, static_cast<std::uint32_t>(model.indices.size())}};
  return model;
}

}  // namespace dermis::sculpt
