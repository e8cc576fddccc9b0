#include "lighting/spherical_harmonics.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "core/bake/harmonics.h"
#include "lighting/cube_geometry.h"

namespace dermis {
namespace {

constexpr double kPi = std::numbers::pi;

void add(std::array<glm::dvec3, 9>& sums, const glm::dvec3& d, const glm::dvec3& power) {
  const auto y = harmonicsAt(d);
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

Harmonics<glm::vec3> harmonicsOfIrradiance(const CubeTexels& irradiance) {
  const int n = irradiance.faceSize;
  const float side = static_cast<float>(n);
  const std::size_t texelBytes = bytesPerTexel(irradiance.storage);
  const std::size_t faceBytes = static_cast<std::size_t>(n) * static_cast<std::size_t>(n) * texelBytes;
  std::array<glm::dvec3, 9> sums{};
  std::size_t offset = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x, offset += texelBytes) {
      const double omega = cubeTexelSolidAngle(x, y, n);  // the same on all faces
      for (int face = 0; face < 6; ++face) {
        const std::byte* texel = irradiance.bytes.data() + static_cast<std::size_t>(face) * faceBytes + offset;
        glm::vec4 rgba;
        if (irradiance.storage == TexelStorage::Float) {
          std::memcpy(&rgba, texel, sizeof rgba);
        } else {
          std::uint64_t halves = 0;
          std::memcpy(&halves, texel, sizeof halves);
          rgba = glm::unpackHalf4x16(halves);
        }
        const glm::vec3 d =
            cubeDirection(face, (static_cast<float>(x) + 0.5F) / side, (static_cast<float>(y) + 0.5F) / side);
        add(sums, d, glm::dvec3(rgba) * omega);
      }
    }
  Harmonics<glm::vec3> radiance{};
  for (std::size_t i = 0; i < 9; ++i) radiance[i] = glm::vec3(sums[i] / kCosineLobe<double>[i]);
  return radiance;
}

Harmonics<glm::vec3> turned(const Harmonics<glm::vec3>& f, const glm::mat3& turn) {
  // Products of two harmonics have degree 4: three Gauss-Legendre heights and five directions each integrate them
  // exactly.
  constexpr std::array<double, 3> kHeights = {-0.7745966692414834, 0.0, 0.7745966692414834};
  constexpr std::array<double, 3> kWeights = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  constexpr int kAround = 5;
  Harmonics<glm::dvec3> sums{};
  for (std::size_t j = 0; j < 3; ++j)
    for (int i = 0; i < kAround; ++i) {
      const double phi = 2.0 * kPi * i / kAround;
      const double r = std::sqrt(1.0 - kHeights[j] * kHeights[j]);
      const glm::dvec3 d(r * std::cos(phi), r * std::sin(phi), kHeights[j]);
      const auto there = harmonicsAt(glm::dmat3(turn) * d);
      glm::dvec3 value(0.0);
      for (std::size_t k = 0; k < 9; ++k) value += glm::dvec3(f[k]) * there[k];
      add(sums, d, value * (kWeights[j] * 2.0 * kPi / kAround));
    }
  Harmonics<glm::vec3> result{};
  for (std::size_t k = 0; k < 9; ++k) result[k] = glm::vec3(sums[k]);
  return result;
}

}  // namespace dermis
