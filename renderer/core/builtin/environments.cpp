#include "core/builtin/environments.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <vector>

namespace dermis {
namespace {

constexpr int kWidth = 512;
constexpr int kHeight = 256;
/// Angle between neighbouring rows: the width over which an edge is smoothed.
constexpr float kTexelAngle = std::numbers::pi_v<float> / kHeight;

constexpr std::array<BuiltinEnvironmentRow, 3> kEnvironments = {{
    {"studio", "Studio", "Three soft boxes in a dark room: a warm key from the left, a dim fill, a rim from behind."},
    {"overcast", "Overcast", "The CIE standard overcast sky over grey ground: light without a direction."},
    {"rim", "Rim", "Two tall strips behind the subject and a dark front: outlines only."},
}};

/// A luminous rectangle that faces the origin, like a photographer's soft box.
struct SoftBox {
  glm::vec3 centre{0.0F};    ///< any unit: only directions count
  glm::vec2 halfSize{1.0F};  ///< across, upright, in the same unit
  glm::vec3 radiance{1.0F};  ///< in the middle
  float edgeShare = 1.0F;    ///< radiance at the border as a share of the middle's
};

/// A soft box made ready for many rays.
class PlacedBox {
 public:
  explicit PlacedBox(const SoftBox& box) : m_box(box), m_distance(glm::length(box.centre)) {
    m_axis = box.centre / m_distance;
    m_right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), -m_axis));
    m_up = glm::cross(-m_axis, m_right);
  }

  /// Radiance along the unit direction, smoothed over a texel at the edges.
  [[nodiscard]] glm::vec3 radiance(const glm::vec3& direction) const {
    const float cosine = glm::dot(direction, m_axis);
    if (cosine <= 0.02F) return glm::vec3(0.0F);
    const float t = m_distance / cosine;
    const glm::vec2 p(t * glm::dot(direction, m_right), t * glm::dot(direction, m_up));
    // A texel seen on the box's plane: an angle becomes a length t, stretched by the slant.
    const float texel = kTexelAngle * t / std::max(cosine, 0.1F);
    const auto inside = [&](float x, float half) {
      return std::clamp((half - std::abs(x)) / texel + 0.5F, 0.0F, 1.0F);
    };
    const float coverage = inside(p.x, m_box.halfSize.x) * inside(p.y, m_box.halfSize.y);
    if (coverage <= 0.0F) return glm::vec3(0.0F);
    // Real boxes are brightest before the lamp and fall off towards the frame.
    const glm::vec2 q = p / m_box.halfSize;
    const float falloff = std::clamp(0.5F * glm::dot(q, q), 0.0F, 1.0F);
    return m_box.radiance * coverage * (1.0F + (m_box.edgeShare - 1.0F) * falloff);
  }

 private:
  SoftBox m_box;
  float m_distance;
  glm::vec3 m_axis, m_right, m_up;
};

float smooth(float edge0, float edge1, float x) {
  const float t = std::clamp((x - edge0) / (edge1 - edge0), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

using RadianceFunction = std::function<glm::vec3(const glm::vec3& direction)>;

RadianceFunction studio() {
  const std::vector<PlacedBox> boxes = {
      // Key: large, warm, high on the camera's left; level enough to leave a catchlight in an eye.
      PlacedBox({{-2.3F, 1.9F, 2.3F}, {1.05F, 1.35F}, glm::vec3(9.6F, 9.0F, 8.1F), 0.55F}),
      // Fill: dim, cool, low on the right.
      PlacedBox({{3.4F, 0.2F, 1.7F}, {1.1F, 1.9F}, glm::vec3(0.62F, 0.72F, 0.88F), 0.5F}),
      // Rims: a tall strip behind on the right, a narrower one on the left.
      PlacedBox({{2.6F, 1.0F, -2.5F}, {0.42F, 2.0F}, glm::vec3(13.0F, 13.6F, 15.0F), 0.6F}),
      PlacedBox({{-3.3F, 0.7F, -1.9F}, {0.26F, 1.7F}, glm::vec3(6.0F, 6.1F, 6.4F), 0.6F}),
      // Overhead bank: fills the crown of a head.
      PlacedBox({{0.25F, 4.0F, -0.4F}, {1.1F, 0.8F}, glm::vec3(2.6F, 2.6F, 2.7F), 0.5F}),
  };
  return [boxes](const glm::vec3& d) {
    // Dark walls, lighter towards a paper roll behind the subject, and a warm floor that bounces the key.
    const glm::vec3 wall = glm::vec3(0.034F, 0.036F, 0.040F) * (1.0F - 0.55F * smooth(0.0F, 1.0F, d.y));
    // A pool of light on the backdrop: a Gaussian of the angle from straight behind, lengthwise a little wider.
    const float spread = (d.x * d.x / (0.30F * 0.30F) + (d.y - 0.02F) * (d.y - 0.02F) / (0.22F * 0.22F)) * 0.5F;
    const float backdrop = d.z < 0.0F ? std::exp(-spread) : 0.0F;
    const float below = smooth(0.05F, -0.75F, d.y);
    const float bounce = below * (0.5F + 0.5F * smooth(-0.9F, 0.9F, d.z - 0.4F * d.x));
    glm::vec3 sum = wall + backdrop * glm::vec3(0.150F, 0.162F, 0.185F) + bounce * glm::vec3(0.20F, 0.175F, 0.15F);
    for (const PlacedBox& box : boxes) sum += box.radiance(d);
    return sum;
  };
}

RadianceFunction overcast() {
  return [](const glm::vec3& d) {
    // CIE standard overcast sky (CIE S 003, 1996): L = L_z (1 + 2 sin γ) / 3; its horizontal irradiance is 7π L_z / 9,
    // which a diffuse ground of reflectance ρ returns as radiance 7 ρ L_z / 9.
    const glm::vec3 zenith = 1.35F * glm::vec3(0.955F, 1.0F, 1.075F);
    const glm::vec3 ground = zenith * (7.0F / 9.0F) * glm::vec3(0.21F, 0.20F, 0.185F);
    const glm::vec3 sky = zenith * (1.0F + 2.0F * std::max(d.y, 0.0F)) / 3.0F;
    const float above = std::clamp(d.y / kTexelAngle + 0.5F, 0.0F, 1.0F);
    return ground + (sky - ground) * above;
  };
}

RadianceFunction rim() {
  const std::vector<PlacedBox> boxes = {
      PlacedBox({{-2.7F, 0.35F, -1.7F}, {0.36F, 2.3F}, glm::vec3(26.0F, 24.6F, 22.6F), 0.6F}),
      PlacedBox({{2.7F, 0.35F, -1.7F}, {0.36F, 2.3F}, glm::vec3(21.5F, 23.6F, 26.5F), 0.6F}),
  };
  return [boxes](const glm::vec3& d) {
    glm::vec3 sum = glm::vec3(0.016F, 0.017F, 0.020F) * (1.0F + 0.5F * smooth(0.3F, -0.8F, d.y));
    for (const PlacedBox& box : boxes) sum += box.radiance(d);
    return sum;
  };
}

std::shared_ptr<const EnvironmentImages> paint(std::string_view id, const RadianceFunction& radiance) {
  auto image = std::make_shared<Image>();
  image->width = kWidth;
  image->height = kHeight;
  image->channels = 3;
  image->type = PixelType::Float;
  image->name = std::string(id);
  image->pixels.resize(static_cast<std::size_t>(kHeight) * image->rowBytes());
  // Pixel (i, j): u = (i + ½)/W, v = (j + ½)/H from the top; direction (sinθ sinφ, cosθ, −sinθ cosφ).
  std::array<glm::vec2, kWidth> azimuth;
  for (int i = 0; i < kWidth; ++i) {
    const float phi = ((static_cast<float>(i) + 0.5F) / kWidth - 0.5F) * 2.0F * std::numbers::pi_v<float>;
    azimuth.at(static_cast<std::size_t>(i)) = {std::sin(phi), -std::cos(phi)};
  }
  std::byte* out = image->pixels.data();
  for (int j = 0; j < kHeight; ++j) {
    const float theta = (static_cast<float>(j) + 0.5F) * kTexelAngle;
    const float sine = std::sin(theta);
    const float cosine = std::cos(theta);
    for (const glm::vec2& a : azimuth) {
      const glm::vec3 value = radiance({sine * a.x, cosine, sine * a.y});
      std::memcpy(out, &value.x, 3 * sizeof(float));
      out += 3 * sizeof(float);
    }
  }
  auto environment = std::make_shared<EnvironmentImages>();
  environment->contentHash = XXH64(image->pixels.data(), image->pixels.size(), 0);
  environment->name = std::string(id);
  environment->latLong = std::move(image);
  return environment;
}

}  // namespace

std::span<const BuiltinEnvironmentRow> builtinEnvironments() { return kEnvironments; }

std::shared_ptr<const EnvironmentImages> builtinEnvironment(std::string_view id) {
  if (id == "studio") return paint(id, studio());
  if (id == "overcast") return paint(id, overcast());
  if (id == "rim") return paint(id, rim());
  return nullptr;
}

}  // namespace dermis
