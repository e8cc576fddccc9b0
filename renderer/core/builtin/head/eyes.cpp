#include "core/builtin/head/eyes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/builtin/head/lids.h"

namespace dermis::sculpt {
namespace {

// As in the shader's eye_optics.glsl: radius of the cornea's curvature; the limbus where the two spheres meet.
constexpr float kCorneaRadius = 7.8F;
constexpr float kLimbusRadius = 5.9F;
constexpr float kPupilRadius = 1.9F;

/// Of its sphere, before the eyeball's.
float corneaCentre() {
  return std::sqrt(kEyeRadius * kEyeRadius - kLimbusRadius * kLimbusRadius) -
         std::sqrt(kCorneaRadius * kCorneaRadius - kLimbusRadius * kLimbusRadius);
}

/// A point of the meridian that is turned about +Z: distance from the axis, height, and the angle from +Z that its
/// texture coordinate stands for.
struct MeridianPoint {
  float radius, z, angle;
};

/// From the front pole backwards. Both poles are single points: the fan closes them.
Model turnedAboutZ(const std::vector<MeridianPoint>& meridian, int segments, const std::string& slot) {
  Model model;
  model.slots.push_back({slot, Material{}});
  const auto rows = static_cast<int>(meridian.size());
  const auto smooth = [&](int row) {
    const MeridianPoint& before = meridian[static_cast<std::size_t>(std::max(row - 1, 0))];
    const MeridianPoint& after = meridian[static_cast<std::size_t>(std::min(row + 1, rows - 1))];
    // Perpendicular to the meridian, outwards as it runs backwards.
    const glm::vec2 along(after.radius - before.radius, after.z - before.z);
    return glm::normalize(glm::vec2(-along.y, along.x));
  };
  for (int row = 0; row < rows; ++row) {
    const MeridianPoint& point = meridian[static_cast<std::size_t>(row)];
    const bool pole = point.radius == 0.0F;
    const glm::vec2 normal = pole ? glm::vec2(0.0F, row == 0 ? 1.0F : -1.0F) : smooth(row);
    for (int i = 0; i < segments; ++i) {
      const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(segments);
      const float c = std::cos(turn), s = std::sin(turn), out = 0.5F * std::sin(0.5F * point.angle);
      model.positions.emplace_back(point.radius * c, point.radius * s, point.z);
      model.normals.push_back(glm::normalize(glm::vec3(normal.x * c, normal.x * s, normal.y)));
      model.uvs.emplace_back(0.5F + out * c, 0.5F + out * s);
      // Along +u, laid into the surface.
      const glm::vec3 n = model.normals.back(),
                      u = std::abs(n.x) < 0.9F ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, n.x < 0 ? 1 : -1);
      model.tangents.emplace_back(glm::normalize(u - glm::dot(u, n) * n), 1.0F);
    }
  }
  const auto at = [&](int row, int i) { return static_cast<std::uint32_t>(row * segments + i % segments); };
  for (int row = 0; row + 1 < rows; ++row)
    for (int i = 0; i < segments; ++i) {
      const bool opens = meridian[static_cast<std::size_t>(row)].radius == 0.0F;
      const bool closes = meridian[static_cast<std::size_t>(row) + 1].radius == 0.0F;
      if (!closes) model.indices.insert(model.indices.end(), {at(row, i), at(row + 1, i), at(row + 1, i + 1)});
      if (!opens)
        model.indices.insert(model.indices.end(), {at(row, i), at(row + 1, closes ? i : i + 1), at(row, i + 1)});
    }
  model.parts = {{0, 0, static_cast<std::uint32_t>(model.indices.size())}};
  for (const glm::vec3& p : model.positions) model.bounds.grow(p);
  return model;
}

}  // namespace

Model makeEyeball(int segments) {
  const float limbusAngle = std::asin(kLimbusRadius / kEyeRadius), limbusZ = kEyeRadius * std::cos(limbusAngle);
  std::vector<MeridianPoint> meridian;
  const auto angleAt = [&](float radius) { return limbusAngle * radius / kLimbusRadius; };
  // The pupil's floor, the iris with its collarette, then the sclera.
  constexpr float kRimGap = 0.25F, kIrisDepth = 0.9F;
  meridian.push_back({0.0F, limbusZ - 2.2F, 0.0F});
  meridian.push_back({kPupilRadius - 0.1F, limbusZ - 2.0F, angleAt(kPupilRadius - 0.1F)});
  const int irisRows = std::max(segments / 8, 4);
  for (int i = 0; i <= irisRows; ++i) {
    const float t = 1.0F - static_cast<float>(i) / static_cast<float>(irisRows);  // 1 at the pupil
    const float radius = glm::mix(kLimbusRadius - kRimGap, kPupilRadius, t);
    const float z = limbusZ - kIrisDepth - 0.35F * t * t + 0.25F * std::sin(t * std::numbers::pi_v<float>);
    meridian.push_back({radius, z, angleAt(radius)});
  }
  const int scleraRows = std::max(segments * 5 / 8, 8);
  for (int i = 0; i < scleraRows; ++i) {
    const float angle =
        glm::mix(limbusAngle, std::numbers::pi_v<float>, static_cast<float>(i) / static_cast<float>(scleraRows));
    meridian.push_back({kEyeRadius * std::sin(angle), kEyeRadius * std::cos(angle), angle});
  }
  meridian.push_back({0.0F, -kEyeRadius, std::numbers::pi_v<float>});
  return turnedAboutZ(meridian, segments, "eye");
}

float frontOfEye(float radius) {
  if (radius < kLimbusRadius) return corneaCentre() + std::sqrt(kCorneaRadius * kCorneaRadius - radius * radius);
  return std::sqrt(std::max(kEyeRadius * kEyeRadius - radius * radius, 0.0F));
}

Model makeCornea(int segments) {
  constexpr float kFilm = 0.03F;  // over the sclera, so that the two don't fight for the depth
  const float centre = corneaCentre();
  const float last = std::asin(kLimbusRadius / kCorneaRadius);
  const int rows = std::max(segments / 4, 6);
  std::vector<MeridianPoint> meridian;
  for (int i = 0; i <= rows; ++i) {
    const float angle = last * static_cast<float>(i) / static_cast<float>(rows), radius = kCorneaRadius + kFilm;
    meridian.push_back({i == 0 ? 0.0F : radius * std::sin(angle), centre + radius * std::cos(angle), angle});
  }
  return turnedAboutZ(meridian, segments, "lens");
}

}  // namespace dermis::sculpt
