#include "core/bake/point_bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dermis {
namespace {

constexpr std::size_t kMostRays = 4096;

}  // namespace

RaySet::RaySet(int count, float coneDegrees) {
  const auto n = static_cast<std::size_t>(std::clamp(count, 1, static_cast<int>(kMostRays)));
  const double sine = std::sin(static_cast<double>(coneDegrees) * std::numbers::pi / 180.0);
  const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  m_local.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    // Equal shares of the disc under the cone (Malley's method).
    const double r2 = sine * sine * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double phi = goldenAngle * static_cast<double>(i);
    m_local.emplace_back(std::sqrt(r2) * std::cos(phi), std::sqrt(r2) * std::sin(phi), std::sqrt(1.0 - r2));
  }
}

void RaySet::around(const glm::vec3& n, std::span<glm::vec3> directions) const {
  // Duff et al. 2017, "Building an Orthonormal Basis, Revisited", listing 3.
  const float sign = std::copysign(1.0F, n.z);
  const float a = -1.0F / (sign + n.z);
  const float b = n.x * n.y * a;
  const glm::mat3 frame(glm::vec3(1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x),
                        glm::vec3(b, sign + n.y * n.y * a, -n.y), n);
  for (std::size_t i = 0; i < m_local.size(); ++i) directions[i] = frame * m_local[i];
}

Harmonics<float> hiddenSky(const RayScene& scene, const glm::vec3& position, const glm::vec3& normal,
                           const RaySet& rays) {
  std::array<glm::vec3, kMostRays> storage;
  std::array<bool, kMostRays> hit;
  const std::span<glm::vec3> directions(storage.data(), rays.size());
  rays.around(normal, directions);
  scene.blocked(position + normal * scene.bias(), directions, std::span(hit.data(), rays.size()));
  Harmonics<float> sum{};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hit[i]) continue;
    const Harmonics<float> y = harmonicsAt(directions[i]);
    for (std::size_t k = 0; k < y.size(); ++k) sum[k] += y[k];
  }
  for (float& s : sum) s /= static_cast<float>(rays.size());
  return sum;
}

float occlusionOf(const Harmonics<float>& hidden) {
  return std::clamp(1.0F - hidden[0] / harmonicsAt(glm::vec3(0.0F, 0.0F, 1.0F))[0], 0.0F, 1.0F);
}

Thickness thicknessAt(const RayScene& scene, const glm::vec3& position, const glm::vec3& normal, const RaySet& rays,
                      float contact) {
  struct Ray {
    float length = std::numeric_limits<float>::infinity();
    std::optional<RayScene::Hit> exit;
  };
  std::array<glm::vec3, kMostRays> storage;
  const std::span<glm::vec3> directions(storage.data(), rays.size());
  rays.around(-normal, directions);
  std::vector<Ray> found(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    found[i].exit = scene.exitAlong(position - normal * scene.bias(), directions[i], contact);
    if (found[i].exit) found[i].length = scene.bias() - found[i].exit->distance * glm::dot(directions[i], normal);
  }
  std::sort(found.begin(), found.end(), [](const Ray& a, const Ray& b) { return a.length < b.length; });
  const std::size_t quarter = found.size() / 4;
  Thickness result;
  for (std::size_t i = quarter; i < found.size() - quarter; ++i) {
    result.length += found[i].length;
    if (found[i].exit) result.exits.push_back(*found[i].exit);
  }
  result.length /= static_cast<float>(found.size() - 2 * quarter);
  return result;
}

}  // namespace dermis
