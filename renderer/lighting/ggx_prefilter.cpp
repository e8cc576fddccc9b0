// The sum over a million pixels for each of half a million texels, made short by two ideas of fast summation (Barnes &
// Hut 1986; Greengard & Rokhlin 1987):
//  - sources far from the lobe's axis are taken as sums over cells, no larger than a fraction of their distance, with
//    the cell's variance as a second-order term;
//  - what a far cell adds varies slowly over a tile of texels, so it is evaluated at 4×4 Chebyshev points of the tile
//  and
//    interpolated; a tile's quarters take care of what was too near for it.
// The weight sum goes through the very same arithmetic, so a constant environment comes out exactly constant.
#include "lighting/ggx_prefilter.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cmath>

#include "lighting/cube_geometry.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define DERMIS_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define DERMIS_CLONES
#endif

namespace dermis {
namespace {

constexpr int kLeaf = 4;                  // texels a side of the smallest tile: 16 positions, like the Chebyshev points
constexpr int kRoot = 32;                 // texels a side of the largest
constexpr float kOpening = 0.5F;          // largest cell in units of its distance
constexpr float kNarrowOpening = 0.7F;    // the same for lobes narrower than alpha 0.03, whose tails hold little
constexpr float kHeavyOpening = 0.2F;     // the same for lamps,
constexpr float kHeavyShare = 3.0e-4F;    // cells with more than this share of all light
constexpr float kLargest = 0.1F;          // rad, of a cell anywhere
constexpr float kNarrowLargest = 0.25F;   // the same for the narrow lobes
constexpr float kHorizonShare = 1.0e-4F;  // of all light, times an angle: most that may cross a horizon in one piece
constexpr float kSeparation = 3.0F;       // least distance of an interpolated cell in half diagonals of the tile
constexpr int kMaxKernels = 8;

using Lanes = float __attribute__((vector_size(32)));
constexpr int kPositions = 16;

/// One GGX lobe: with s = sin²θ_h, 1/D is proportional to (alpha² + (1 − alpha²) s)².
struct Kernel {
  float alpha2, oneMinusAlpha2;
};

/// Sixteen directions, halved: |n/2 − l/2|² is sin²θ_h for n = v, without the cancellation of 1 − n·l.
struct alignas(32) Positions {
  std::array<float, kPositions> x, y, z;
};

/// Sums at sixteen positions: red, green, blue, weight of each kernel.
struct alignas(32) Field {
  std::array<std::array<float, kPositions>, std::size_t{4} * kMaxKernels> sums;
};

/// Reciprocals of up to three numbers by one division.
template <int K>
__attribute__((always_inline)) inline void invert(const Lanes* t, Lanes* inverse) {
  if constexpr (K == 1) {
    inverse[0] = 1.0F / t[0];
  } else if constexpr (K == 2) {
    const Lanes all = 1.0F / (t[0] * t[1]);
    inverse[0] = all * t[1];
    inverse[1] = all * t[0];
  } else {
    const Lanes pair = t[0] * t[1];
    const Lanes all = 1.0F / (pair * t[2]);
    const Lanes rest = all * t[2];
    inverse[0] = rest * t[1];
    inverse[1] = rest * t[0];
    inverse[2] = all * pair;
  }
}

/// Adds what the sources send to eight positions through K lobes.
template <int K>
__attribute__((always_inline)) inline void accumulateLanes(const RadianceSource* sources, std::size_t count,
                                                           const Kernel* kernels, const float* px, const float* py,
                                                           const float* pz, float* out) {
  const Lanes zero{};
  Lanes x = zero;
  Lanes y = zero;
  Lanes z = zero;
  __builtin_memcpy(&x, px, sizeof x);
  __builtin_memcpy(&y, py, sizeof y);
  __builtin_memcpy(&z, pz, sizeof z);
  Lanes sum[4 * K];
  for (int i = 0; i < 4 * K; ++i) __builtin_memcpy(&sum[i], out + i * kPositions, sizeof(Lanes));
  for (std::size_t i = 0; i < count; ++i) {
    const RadianceSource& source = sources[i];
    const Lanes dx = x - source.halfX;
    const Lanes dy = y - source.halfY;
    const Lanes dz = z - source.halfZ;
    const Lanes s = dx * dx + dy * dy + dz * dz;
    const Lanes cosine = 1.0F - 2.0F * s;
    const Lanes clamped = cosine > 0.0F ? cosine : zero;
    Lanes t[K];
    Lanes inverse[K];
    for (int k = 0; k < K; ++k) t[k] = kernels[k].alpha2 + kernels[k].oneMinusAlpha2 * s;
    invert<K>(t, inverse);
    for (int k = 0; k < K; ++k) {
      const Lanes inverse2 = inverse[k] * inverse[k];
      // The cell's spread: ½σ²∇²(t⁻²) = σ² b (2bs − alpha²) t⁻⁴ with b = 1 − alpha².
      const Lanes curvature = (2.0F * t[k] - 3.0F * kernels[k].alpha2) * inverse2;
      const Lanes spread = 1.0F + (source.variance * kernels[k].oneMinusAlpha2) * curvature;
      const Lanes weight = clamped * inverse2 * spread;
      sum[4 * k] += weight * source.red;
      sum[4 * k + 1] += weight * source.green;
      sum[4 * k + 2] += weight * source.blue;
      sum[4 * k + 3] += weight * source.solidAngle;
    }
  }
  for (int i = 0; i < 4 * K; ++i) __builtin_memcpy(out + i * kPositions, &sum[i], sizeof(Lanes));
}

template <int K>
__attribute__((always_inline)) inline void accumulateBoth(const RadianceSource* sources, std::size_t count,
                                                          const Kernel* kernels, const Positions& at, float* out) {
  accumulateLanes<K>(sources, count, kernels, at.x.data(), at.y.data(), at.z.data(), out);
  accumulateLanes<K>(sources, count, kernels, at.x.data() + 8, at.y.data() + 8, at.z.data() + 8, out + 8);
}

DERMIS_CLONES void accumulate1(const RadianceSource* s, std::size_t n, const Kernel* k, const Positions& at,
                               float* out) {
  accumulateBoth<1>(s, n, k, at, out);
}
DERMIS_CLONES void accumulate2(const RadianceSource* s, std::size_t n, const Kernel* k, const Positions& at,
                               float* out) {
  accumulateBoth<2>(s, n, k, at, out);
}
DERMIS_CLONES void accumulate3(const RadianceSource* s, std::size_t n, const Kernel* k, const Positions& at,
                               float* out) {
  accumulateBoth<3>(s, n, k, at, out);
}

void accumulate(const std::vector<RadianceSource>& sources, std::span<const Kernel> kernels, const Positions& at,
                Field& field) {
  const std::size_t count = kernels.size();
  std::size_t k = 0;
  for (; k + 3 <= count; k += 3) {
    accumulate3(sources.data(), sources.size(), kernels.data() + k, at, field.sums[4 * k].data());
  }
  if (count - k == 2) accumulate2(sources.data(), sources.size(), kernels.data() + k, at, field.sums[4 * k].data());
  if (count - k == 1) accumulate1(sources.data(), sources.size(), kernels.data() + k, at, field.sums[4 * k].data());
}

/// Weights that interpolate from a tile's four Chebyshev points to four places in one of its halves.
using Weights = std::array<std::array<float, 4>, 4>;

struct Interpolation {
  std::array<float, 4> points{};      // Chebyshev points of 0..1
  std::array<Weights, 2> toPoints{};  // to the points of the lower and upper half
  std::array<Weights, 2> toTexels{};  // to its texel centres, where the half is a leaf

  Interpolation() {
    for (int i = 0; i < 4; ++i) {
      points[static_cast<std::size_t>(i)] =
          static_cast<float>(0.5 - 0.5 * std::cos((2 * i + 1) * 3.14159265358979 / 8));
    }
    for (std::size_t half = 0; half < 2; ++half) {
      for (std::size_t j = 0; j < 4; ++j) {
        const auto offset = static_cast<float>(half);
        toPoints[half][j] = weights(0.5F * (points[j] + offset));
        toTexels[half][j] = weights(0.5F * ((static_cast<float>(j) + 0.5F) / 4.0F + offset));
      }
    }
  }

  [[nodiscard]] std::array<float, 4> weights(float x) const {
    std::array<float, 4> w{};
    for (std::size_t i = 0; i < 4; ++i) {
      w[i] = 1.0F;
      for (std::size_t k = 0; k < 4; ++k) {
        if (k != i) w[i] *= (x - points[k]) / (points[i] - points[k]);
      }
    }
    return w;
  }
};

/// A quarter's field from its parent's.
void interpolate(const Field& parent, const Weights& wx, const Weights& wy, std::size_t channels, Field& child) {
  for (std::size_t c = 0; c < channels; ++c) {
    std::array<float, kPositions> rows{};
    for (std::size_t y = 0; y < 4; ++y) {
      for (std::size_t x = 0; x < 4; ++x) {
        for (std::size_t i = 0; i < 4; ++i) rows[4 * y + x] += wx[x][i] * parent.sums[c][4 * y + i];
      }
    }
    for (std::size_t y = 0; y < 4; ++y) {
      for (std::size_t x = 0; x < 4; ++x) {
        float sum = 0.0F;
        for (std::size_t i = 0; i < 4; ++i) sum += wy[y][i] * rows[4 * i + x];
        child.sums[c][4 * y + x] = sum;
      }
    }
  }
}

struct CellRef {
  int level;
  std::uint32_t index;
};

/// Work memory of one depth of the recursion.
struct Scratch {
  std::vector<CellRef> stack, near;
  std::vector<RadianceSource> list;
  Field field;
};
using Workspace = std::array<Scratch, 8>;

class Prefilter {
 public:
  Prefilter(const RadianceTree& tree, int faceSize, std::span<const float> alphas)
      : m_tree(tree), m_faceSize(faceSize), m_narrowest(1.0F) {
    for (float alpha : alphas) {
      m_kernels.push_back({alpha * alpha, 1.0F - alpha * alpha});
      m_narrowest = std::min(m_narrowest, alpha);
    }
    float total = 0.0F;
    for (const RadianceSource& face : tree.level(0)) total += face.red + face.green + face.blue;
    m_horizonLight = kHorizonShare * total;
    m_heavyLight = kHeavyShare * total;
    const bool narrow = m_narrowest < 0.03F;
    m_opening = narrow ? kNarrowOpening : kOpening;
    m_largest = narrow ? kNarrowLargest : kLargest;
  }

  /// Fills the texels of one root tile.
  void run(int face, int x, int y, Workspace& workspace, std::vector<float>& rgba) {
    Scratch& top = workspace[0];
    top.near.clear();
    for (std::uint32_t f = 0; f < 6; ++f) top.near.push_back({0, f});
    solve(face, x, y, kRoot, nullptr, 0, 0, top.near, workspace, 1, rgba);
  }

 private:
  void solve(int face, int x, int y, int size, const Field* parent, std::size_t halfX, std::size_t halfY,
             const std::vector<CellRef>& candidates, Workspace& workspace, std::size_t depth,
             std::vector<float>& rgba) {
    const bool leaf = size == kLeaf;
    const std::size_t channels = 4 * m_kernels.size();
    Scratch& own = workspace[depth];

    // Where this tile's field is evaluated: Chebyshev points, or the texels themselves.
    const auto n = static_cast<float>(m_faceSize);
    Positions at{};
    for (std::size_t i = 0; i < kPositions; ++i) {
      const auto place = [&](std::size_t k) {
        return leaf ? static_cast<float>(k) + 0.5F : static_cast<float>(size) * m_interpolation.points[k];
      };
      const glm::vec3 d = 0.5F * cubeDirection(face, (static_cast<float>(x) + place(i % 4)) / n,
                                               (static_cast<float>(y) + place(i / 4)) / n);
      at.x[i] = d.x, at.y[i] = d.y, at.z[i] = d.z;
    }
    if (parent != nullptr) {
      const auto& weights = leaf ? m_interpolation.toTexels : m_interpolation.toPoints;
      interpolate(*parent, weights[halfX], weights[halfY], channels, own.field);
    } else {
      for (auto& sums : own.field.sums) sums.fill(0.0F);
    }

    classify(face, x, y, size, leaf, candidates, own);
    accumulate(own.list, m_kernels, at, own.field);

    if (leaf) {
      store(face, x, y, own.field, rgba);
      return;
    }
    const int half = size / 2;
    for (int q = 0; q < 4; ++q) {
      solve(face, x + (q & 1) * half, y + (q >> 1) * half, half, &own.field, static_cast<std::size_t>(q & 1),
            static_cast<std::size_t>(q >> 1), own.near, workspace, depth + 1, rgba);
    }
  }

  /// Sorts the candidates into those this tile evaluates (own.list) and those left to its quarters (own.near), opening
  /// cells that are too large for either.
  void classify(int face, int x, int y, int size, bool leaf, const std::vector<CellRef>& candidates, Scratch& own) {
    const auto n = static_cast<float>(m_faceSize);
    const auto corner = [&](float i, float j) {
      return cubeDirection(face, (static_cast<float>(x) + i * static_cast<float>(size)) / n,
                           (static_cast<float>(y) + j * static_cast<float>(size)) / n);
    };
    const glm::vec3 centre = corner(0.5F, 0.5F);
    float radius = 0.0F;
    for (int q = 0; q < 4; ++q) {
      radius = std::max(radius, glm::length(corner(static_cast<float>(q & 1), static_cast<float>(q >> 1)) - centre));
    }
    const float lobe2 = 4.0F * m_narrowest * m_narrowest;

    own.list.clear();
    own.near.clear();
    own.stack.assign(candidates.begin(), candidates.end());
    while (!own.stack.empty()) {
      const CellRef ref = own.stack.back();
      own.stack.pop_back();
      const RadianceSource& cell = m_tree.level(ref.level)[ref.index];
      if (cell.solidAngle <= 0.0F) continue;
      const glm::vec3 offset = 2.0F * glm::vec3{cell.halfX, cell.halfY, cell.halfZ} - centre;
      const float distance2 = glm::dot(offset, offset);
      const float distance = std::sqrt(distance2);
      // At least the cell's true width, also where pixels are sparse in it.
      const float width = 2.0F / static_cast<float>(1 << ref.level);
      const float cellSize = std::min(width, 1.5F * std::sqrt(cell.solidAngle));
      const float cosine = 1.0F - 0.5F * distance2;
      if (cosine < -1.5F * (radius + cellSize) && ref.level > 2) continue;  // wholly below every texel's horizon

      const float nearest = std::max(0.0F, distance - radius);
      // The lobe bends where n·l is clamped; a lamp that crosses some texel's horizon must not do so in one large
      // piece.
      const float light = cell.red + cell.green + cell.blue;
      const bool crosses = std::abs(cosine) < radius + 1.5F * cellSize;
      const float opening = light > m_heavyLight ? kHeavyOpening : m_opening;
      const bool small = cellSize < m_largest &&
                         cellSize * cellSize < opening * opening * (nearest * nearest + lobe2) &&
                         !(crosses && light * cellSize > m_horizonLight);
      if (leaf) {
        if (small)
          append(cell, own);
        else if (ref.level == RadianceTree::kLeafLevel) {
          const auto sources = m_tree.sources(ref.index);
          own.list.insert(own.list.end(), sources.begin(), sources.end());
        } else
          open(ref, own);
        continue;
      }
      const float reach = kSeparation * radius;
      const bool far = distance2 + lobe2 > reach * reach && !(crosses && light * radius > m_horizonLight);
      if (far && small)
        append(cell, own);
      else if (ref.level == RadianceTree::kLeafLevel || (!far && cellSize < radius))
        own.near.push_back(ref);
      else
        open(ref, own);
    }
  }

  /// Light spread over a cell sums to a mean vector of length 1 − σ², so its n·l is less by that.
  static void append(RadianceSource cell, Scratch& own) {
    const float length = 1.0F - cell.variance;
    cell.red *= length, cell.green *= length, cell.blue *= length, cell.solidAngle *= length;
    own.list.push_back(cell);
  }

  static void open(const CellRef& ref, Scratch& own) {
    for (std::uint32_t c = 0; c < 4; ++c) own.stack.push_back({ref.level + 1, 4 * ref.index + c});
  }

  void store(int face, int x, int y, const Field& field, std::vector<float>& rgba) const {
    const auto n = static_cast<std::size_t>(m_faceSize);
    for (std::size_t k = 0; k < m_kernels.size(); ++k) {
      for (std::size_t i = 0; i < kPositions; ++i) {
        const std::size_t row = (k * 6 + static_cast<std::size_t>(face)) * n + static_cast<std::size_t>(y) + i / 4;
        float* texel = rgba.data() + 4 * (row * n + static_cast<std::size_t>(x) + i % 4);
        const float weight = field.sums[4 * k + 3][i];
        for (std::size_t c = 0; c < 3; ++c) texel[c] = std::max(0.0F, field.sums[4 * k + c][i] / weight);
        texel[3] = 1.0F;
      }
    }
  }

  const RadianceTree& m_tree;
  int m_faceSize;
  std::vector<Kernel> m_kernels;
  float m_narrowest;
  float m_horizonLight = 0.0F, m_heavyLight = 0.0F, m_opening = kOpening, m_largest = kLargest;
  Interpolation m_interpolation;
};

/// Bilinear reading of a curved function is off by h²/8 f″ between texels and right at them; taking a twelfth of the
/// discrete Laplacian off every texel makes the mean error vanish. `rgba` is one cube, [face][row][column].
void compensateBilinear(float* rgba, int n) {
  const auto size = static_cast<std::size_t>(n);
  const std::vector<float> original(rgba, rgba + 6 * size * size * 4);
  const auto texel = [&](int face, int x, int y) {
    if (x < 0 || y < 0 || x >= n || y >= n) {
      const CubePoint p = cubePoint(cubeVector(face, (static_cast<float>(x) + 0.5F) / static_cast<float>(n),
                                               (static_cast<float>(y) + 0.5F) / static_cast<float>(n)));
      face = p.face;
      x = std::clamp(static_cast<int>(p.s * static_cast<float>(n)), 0, n - 1);
      y = std::clamp(static_cast<int>(p.t * static_cast<float>(n)), 0, n - 1);
    }
    return original.data() + 4 * ((static_cast<std::size_t>(face) * size + static_cast<std::size_t>(y)) * size +
                                  static_cast<std::size_t>(x));
  };
  tbb::parallel_for(0, 6 * n, [&](int row) {
    const int face = row / n;
    const int y = row % n;
    for (int x = 0; x < n; ++x) {
      const float* centre = texel(face, x, y);
      const float* a = texel(face, x - 1, y);
      const float* b = texel(face, x + 1, y);
      const float* c = texel(face, x, y - 1);
      const float* d = texel(face, x, y + 1);
      float* out = rgba + (centre - original.data());
      for (int i = 0; i < 3; ++i) {
        const float laplacian = (a[i] - centre[i]) + (b[i] - centre[i]) + (c[i] - centre[i]) + (d[i] - centre[i]);
        out[i] = std::max(0.0F, centre[i] - laplacian / 12.0F);
      }
    }
  });
}

}  // namespace

std::vector<float> prefilterGgx(const RadianceTree& tree, int faceSize, std::span<const float> alphas,
                                std::stop_token stop, const std::function<void(float)>& progress) {
  const auto texels = static_cast<std::size_t>(faceSize) * static_cast<std::size_t>(faceSize) * 6;
  std::vector<float> rgba(alphas.size() * texels * 4);
  Prefilter prefilter(tree, faceSize, alphas);
  tbb::enumerable_thread_specific<std::unique_ptr<Workspace>> workspaces([] { return std::make_unique<Workspace>(); });
  const int side = faceSize / kRoot;
  const int tiles = 6 * side * side;
  std::atomic<int> done = 0;
  tbb::parallel_for(0, tiles, [&](int tile) {
    if (stop.stop_requested()) return;
    const int face = tile / (side * side);
    prefilter.run(face, tile % side * kRoot, tile / side % side * kRoot, *workspaces.local(), rgba);
    if (progress) progress(static_cast<float>(++done) / static_cast<float>(tiles));
  });
  if (stop.stop_requested()) return {};
  for (std::size_t k = 0; k < alphas.size(); ++k) {
    // Where texels are wider than the lobe there is no smooth function to compensate for.
    if (alphas[k] * static_cast<float>(faceSize) >= 2.0F) compensateBilinear(rgba.data() + k * texels * 4, faceSize);
  }
  return rgba;
}

}  // namespace dermis
