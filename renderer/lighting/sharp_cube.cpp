#include "lighting/sharp_cube.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "lighting/cube_geometry.h"
#include "lighting/roughness_nodes.h"

namespace dermis {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Lat-long radiance at one place of each face of a group that shares its angles: the four sides, or top and bottom.
class LatLongSampler {
 public:
  LatLongSampler(const RadianceMap& map) : m_map(map) {}

  void sides(float s, float t, glm::vec3* faces) const {
    const float sc = 2.0F * s - 1.0F;
    const float tc = 2.0F * t - 1.0F;
    const float v = 0.5F + std::atan(tc / std::sqrt(1.0F + sc * sc)) / kPi;
    const float turn = std::atan(sc) / (2.0F * kPi);
    // The middle of +X is at u = 0.75, −X at 0.25, +Z at 1 and −Z at 0.5; on each, s grows where u falls.
    faces[0] = at(0.75F - turn, v);
    faces[1] = at(0.25F - turn, v);
    faces[4] = at(1.0F - turn, v);
    faces[5] = at(0.5F - turn, v);
  }

  void caps(float s, float t, glm::vec3* faces) const {
    const float x = 2.0F * s - 1.0F;
    const float z = 2.0F * t - 1.0F;
    const float polar = std::atan(std::sqrt(x * x + z * z)) / kPi;
    faces[2] = at(0.5F + std::atan2(x, -z) / (2.0F * kPi), polar);
    faces[3] = at(0.5F + std::atan2(x, z) / (2.0F * kPi), 1.0F - polar);
  }

 private:
  [[nodiscard]] glm::vec3 at(float u, float v) const {
    return m_map.latLongAt(u * static_cast<float>(m_map.latLong.width) - 0.5F,
                           v * static_cast<float>(m_map.latLong.height) - 0.5F);
  }
  const RadianceMap& m_map;
};

}  // namespace

int sharpFaceSize(int pixelsPerFace, int maximum) {
  // Twice the pixels of a quarter turn: texels in the middle of a face are wider than those at its edges.
  const auto wanted = std::bit_ceil(static_cast<unsigned>(std::max(1, 2 * pixelsPerFace)));
  return std::clamp(static_cast<int>(std::min(wanted, 1U << 14U)), std::min(kPrefilterFaceSize, maximum), maximum);
}

std::vector<float> resampleToCube(const RadianceMap& map, int faceSize) {
  const auto n = static_cast<std::size_t>(faceSize);
  std::vector<float> rgba(6 * n * n * 4, 1.0F);
  // A texel in the middle of a face covers 4/π of the pixels that one of equal share would.
  const int taps = std::clamp(static_cast<int>(std::ceil(1.27 * map.pixelsPerFace() / faceSize - 0.5)), 1, 32);
  const LatLongSampler sampler(map);
  tbb::parallel_for(0, faceSize, [&](int row) {
    for (int column = 0; column < faceSize; ++column) {
      glm::vec3 sums[6]{};
      for (int tap = 0; tap < taps * taps; ++tap) {
        const auto place = [&](int texel, int i) {
          return (static_cast<float>(texel) + (static_cast<float>(i) + 0.5F) / static_cast<float>(taps)) /
                 static_cast<float>(faceSize);
        };
        const float s = place(column, tap % taps);
        const float t = place(row, tap / taps);
        glm::vec3 faces[6];
        if (map.layout == RadianceMap::Layout::LatLong) {
          sampler.sides(s, t, faces);
          sampler.caps(s, t, faces);
        } else {
          for (int f = 0; f < 6; ++f) faces[f] = map.faceAt(f, s, t);
        }
        for (int f = 0; f < 6; ++f) sums[f] += faces[f];
      }
      for (std::size_t f = 0; f < 6; ++f) {
        float* texel =
            rgba.data() + 4 * ((f * n + static_cast<std::size_t>(row)) * n + static_cast<std::size_t>(column));
        for (int c = 0; c < 3; ++c) texel[c] = sums[f][c] / static_cast<float>(taps * taps);
      }
    }
  });
  return rgba;
}

std::vector<float> halveCube(const std::vector<float>& rgba, int faceSize) {
  const auto n = static_cast<std::size_t>(faceSize / 2);
  std::vector<float> half(6 * n * n * 4, 1.0F);
  // Solid angle of a texel goes with (1 + u² + v²)^(−3/2).
  const auto weight = [&](std::size_t x, std::size_t y) {
    const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(n) - 1.0F;
    const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(n) - 1.0F;
    const float w = 1.0F + u * u + v * v;
    return 1.0F / (w * std::sqrt(w));
  };
  for (std::size_t face = 0; face < 6; ++face) {
    for (std::size_t y = 0; y < n; ++y) {
      for (std::size_t x = 0; x < n; ++x) {
        float sum[3]{};
        float weights = 0.0F;
        for (std::size_t q = 0; q < 4; ++q) {
          const std::size_t fx = 2 * x + (q & 1U);
          const std::size_t fy = 2 * y + (q >> 1U);
          const float w = weight(fx, fy);
          const float* texel = rgba.data() + 4 * ((face * 2 * n + fy) * 2 * n + fx);
          for (std::size_t c = 0; c < 3; ++c) sum[c] += w * texel[c];
          weights += w;
        }
        float* out = half.data() + 4 * ((face * n + y) * n + x);
        for (std::size_t c = 0; c < 3; ++c) out[c] = sum[c] / weights;
      }
    }
  }
  return half;
}

}  // namespace dermis
