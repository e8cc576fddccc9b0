#include "lighting/spherical_harmonics.h"

#include <cmath>
#include <numbers>

#include "lighting/cube_geometry.h"

namespace dermis {
namespace {

constexpr double kPi = std::numbers::pi;

std::array<double, 9> basis(const glm::dvec3& d) {
  return {0.28209479177387814,
          0.4886025119029199 * d.y,
          0.4886025119029199 * d.z,
          0.4886025119029199 * d.x,
          1.0925484305920792 * d.x * d.y,
          1.0925484305920792 * d.y * d.z,
          0.31539156525252005 * (3.0 * d.z * d.z - 1.0),
          1.0925484305920792 * d.x * d.z,
          0.5462742152960396 * (d.x * d.x - d.y * d.y)};
}

void add(std::array<glm::dvec3, 9>& sums, const glm::dvec3& d, const glm::dvec3& power) {
  const auto y = basis(d);
  for (std::size_t i = 0; i < 9; ++i) sums[i] += power * y[i];
}

}  // namespace

std::array<glm::dvec3, 9> sphericalHarmonics9(const RadianceMap& map) {
  std::array<glm::dvec3, 9> sums{};
  if (map.layout == RadianceMap::Layout::Constant) {
    sums[0] = glm::dvec3(map.constant) * (2.0 * std::sqrt(kPi));
    return sums;
  }
  if (map.layout == RadianceMap::Layout::LatLong) {
    const int w = map.latLong.width;
    const int h = map.latLong.height;
    for (int j = 0; j < h; ++j) {
      // The exact area of the pixel: a band between two parallels, cut into w parts.
      const double omega = 2.0 * kPi / w * (std::cos(kPi * j / h) - std::cos(kPi * (j + 1) / h));
      const double theta = kPi * (j + 0.5) / h;
      for (int i = 0; i < w; ++i) {
        const double phi = 2.0 * kPi * ((i + 0.5) / w - 0.5);
        add(sums, {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)},
            glm::dvec3(map.latLong.at(i, j)) * omega);
      }
    }
    return sums;
  }
  for (int face = 0; face < 6; ++face) {
    const RadianceImage& image = map.faces[static_cast<std::size_t>(face)];
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const glm::vec3 d = cubeDirection(face, (static_cast<float>(x) + 0.5F) / static_cast<float>(image.width),
                                          (static_cast<float>(y) + 0.5F) / static_cast<float>(image.height));
        add(sums, d, glm::dvec3(image.at(x, y)) * cubeTexelSolidAngle(x, y, image.width));
      }
    }
  }
  return sums;
}

}  // namespace dermis
