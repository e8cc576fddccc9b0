#include "lighting/radiance_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lighting/cube_geometry.h"

namespace dermis {
namespace {

constexpr int kFineSide = 2 << RadianceTree::kLeafLevel;  // cells a face side in which pixels are merged
constexpr int kMinimumWidth = 1024;                       // of a lat-long image, before it is interpolated
constexpr int kMinimumFace = 256;

/// Sums of sources before the centre is divided out. Weights of the centre are luminance, with a little of the solid
/// angle so that a black cell has one too.
struct Sum {
  float x = 0, y = 0, z = 0, weight = 0, red = 0, green = 0, blue = 0, solidAngle = 0;
  float spread = 0;  // variance already inside the parts, weighted

  void add(const glm::vec3& d, const glm::vec3& power, float omega, float variance) {
    const float w = power.x + power.y + power.z + 1.0e-12F * omega;
    x += w * d.x, y += w * d.y, z += w * d.z, weight += w;
    red += power.x, green += power.y, blue += power.z, solidAngle += omega;
    spread += w * variance;
  }

  [[nodiscard]] RadianceSource source() const {
    const float inverse = 1.0F / weight;
    const glm::vec3 mean{x * inverse, y * inverse, z * inverse};
    const float length = glm::length(mean);
    const glm::vec3 half = mean * (0.5F / length);
    // Points spread with variance σ² on each of two tangent axes have a mean vector of length 1 − σ².
    const float variance = std::max(0.0F, 1.0F - length) + spread * inverse;
    return {half.x, half.y, half.z, variance > 3.0e-7F ? variance : 0.0F, red, green, blue, solidAngle};
  }
};

std::uint32_t spreadBits(std::uint32_t v) {
  v = (v | (v << 8U)) & 0x00FF00FFU;
  v = (v | (v << 4U)) & 0x0F0F0F0FU;
  v = (v | (v << 2U)) & 0x33333333U;
  return (v | (v << 1U)) & 0x55555555U;
}

std::uint32_t fineCell(const glm::vec3& d) {
  const CubePoint p = cubePoint(d);
  const auto index = [](float v) {
    return static_cast<std::uint32_t>(std::clamp(static_cast<int>(v * kFineSide), 0, kFineSide - 1));
  };
  constexpr auto kCells = static_cast<std::uint32_t>(kFineSide) * static_cast<std::uint32_t>(kFineSide);
  return static_cast<std::uint32_t>(p.face) * kCells + spreadBits(index(p.s)) + (spreadBits(index(p.t)) << 1U);
}

struct Pixel {
  glm::vec3 direction, power;
  float solidAngle;
  std::uint32_t cell;
};

/// Rows of pixels with their directions, solid angles and cells; neighbours in one cell of a large image are merged on
/// the way.
std::vector<Pixel> collectLatLong(const RadianceMap& map) {
  const int factor = std::max(1, (kMinimumWidth + map.latLong.width - 1) / map.latLong.width);
  const int w = map.latLong.width * factor;
  const int h = map.latLong.height * factor;
  const double rowStep = std::numbers::pi / h;
  std::vector<glm::vec2> circle(static_cast<std::size_t>(w));
  for (int i = 0; i < w; ++i) {
    const double phi = ((i + 0.5) / w - 0.5) * 2.0 * std::numbers::pi;
    circle[static_cast<std::size_t>(i)] = {std::sin(phi), -std::cos(phi)};
  }
  std::vector<Pixel> pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  tbb::parallel_for(tbb::blocked_range<int>(0, h, 8), [&](const auto& rows) {
    for (int j = rows.begin(); j < rows.end(); ++j) {
      const double theta = (j + 0.5) * rowStep;
      const auto y = static_cast<float>(std::cos(theta));
      const auto radius = static_cast<float>(std::sin(theta));
      const auto omega = static_cast<float>(2.0 * std::numbers::pi / w * 2.0 * std::sin(rowStep / 2) * std::sin(theta));
      for (int i = 0; i < w; ++i) {
        const glm::vec2 c = circle[static_cast<std::size_t>(i)];
        const glm::vec3 d{radius * c.x, y, radius * c.y};
        const float inverse = 1.0F / static_cast<float>(factor);
        const glm::vec3 radiance = factor == 1 ? map.latLong.at(i, j)
                                               : map.latLongAt((static_cast<float>(i) + 0.5F) * inverse - 0.5F,
                                                               (static_cast<float>(j) + 0.5F) * inverse - 0.5F);
        pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(w) + static_cast<std::size_t>(i)] = {
            d, radiance * omega, omega, fineCell(d)};
      }
    }
  });
  return pixels;
}

std::vector<Pixel> collectFaces(const RadianceMap& map) {
  const int own = map.faces[0].width;
  const int factor = std::max(1, (kMinimumFace + own - 1) / own);
  const int n = own * factor;
  const auto perFace = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  std::vector<Pixel> pixels(6 * perFace);
  tbb::parallel_for(0, 6 * n, [&](int row) {
    const int face = row / n;
    const int y = row % n;
    for (int x = 0; x < n; ++x) {
      const float s = (static_cast<float>(x) + 0.5F) / static_cast<float>(n);
      const float t = (static_cast<float>(y) + 0.5F) / static_cast<float>(n);
      const glm::vec3 d = cubeDirection(face, s, t);
      const auto omega = static_cast<float>(cubeTexelSolidAngle(x, y, n));
      const glm::vec3 radiance =
          factor == 1 ? map.faces[static_cast<std::size_t>(face)].at(x, y) : map.faceAt(face, s, t);
      pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(x)] = {
          d, radiance * omega, omega, fineCell(d)};
    }
  });
  return pixels;
}

}  // namespace

RadianceTree::RadianceTree(const RadianceMap& map) {
  const std::vector<Pixel> pixels = map.layout == RadianceMap::Layout::Faces ? collectFaces(map) : collectLatLong(map);

  // Sort the pixels by fine cell (counting sort), then merge those that share one.
  constexpr std::size_t kFineCells = 6U * kFineSide * kFineSide;
  constexpr std::size_t kLeafCells = kFineCells / 4;
  std::vector<std::uint32_t> start(kFineCells + 1, 0);
  for (const Pixel& p : pixels) ++start[p.cell + 1];
  for (std::size_t c = 0; c < kFineCells; ++c) start[c + 1] += start[c];
  std::vector<std::uint32_t> order(pixels.size());
  {
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < pixels.size(); ++i) order[next[pixels[i].cell]++] = static_cast<std::uint32_t>(i);
  }
  m_first.resize(kLeafCells + 1);
  m_sources.reserve(std::min(pixels.size(), kFineCells));
  m_levels[kLeafLevel].resize(kLeafCells);
  for (std::size_t leaf = 0; leaf < kLeafCells; ++leaf) {
    m_first[leaf] = static_cast<std::uint32_t>(m_sources.size());
    Sum whole;
    for (std::size_t fine = 4 * leaf; fine < 4 * leaf + 4; ++fine) {
      Sum sum;
      for (std::uint32_t i = start[fine]; i < start[fine + 1]; ++i) {
        const Pixel& p = pixels[order[i]];
        sum.add(p.direction, p.power, p.solidAngle, 0.0F);
        whole.add(p.direction, p.power, p.solidAngle, 0.0F);
      }
      if (sum.solidAngle > 0.0F) m_sources.push_back(sum.source());
    }
    m_levels[kLeafLevel][leaf] = whole.solidAngle > 0.0F ? whole.source() : RadianceSource{};
  }
  m_first[kLeafCells] = static_cast<std::uint32_t>(m_sources.size());

  // Each coarser cell is the sum of its four.
  for (int l = kLeafLevel - 1; l >= 0; --l) {
    const auto& fine = m_levels[static_cast<std::size_t>(l) + 1];
    auto& coarse = m_levels[static_cast<std::size_t>(l)];
    coarse.resize(fine.size() / 4);
    for (std::size_t cell = 0; cell < coarse.size(); ++cell) {
      Sum sum;
      for (std::size_t child = 4 * cell; child < 4 * cell + 4; ++child) {
        const RadianceSource& s = fine[child];
        if (s.solidAngle <= 0.0F) continue;
        sum.add(2.0F * glm::vec3{s.halfX, s.halfY, s.halfZ}, {s.red, s.green, s.blue}, s.solidAngle, s.variance);
      }
      if (sum.solidAngle > 0.0F) coarse[cell] = sum.source();
    }
  }
}

}  // namespace dermis
