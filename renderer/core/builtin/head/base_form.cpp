#include "core/builtin/head/base_form.h"

#include <array>

#include "core/bake/parallel.h"
#include "core/builtin/head/pins.h"
#include "core/builtin/head/sdf.h"
#include "core/builtin/head/thin_plate.h"

namespace dermis::sculpt {
namespace {

constexpr float kSpacing = 4.0F;
constexpr glm::ivec3 kCounts(91, 104, 76);
constexpr glm::vec3 kOrigin(-180.0F, -270.0F, -150.0F);

/// Enough to take out the lumps that pins a few tenths of a millimetre off would make.
constexpr double kPinSmoothing = 1e-3;

float neck(const glm::vec3& p) {
  const glm::vec3 top(0, -10, -8), bottom(0, -205, -30);  // the axis leans forward going up
  if (p.y > top.y) return glm::length(p - top) - 50.0F;
  const glm::vec3 along = bottom - top;
  const float h = glm::clamp(glm::dot(p - top, along) / glm::dot(along, along), 0.0F, 1.0F);
  const glm::vec3 off = p - top - along * h;
  const glm::vec2 radii(glm::mix(50.0F, 56.0F, h), glm::mix(50.0F, 60.0F, h));
  return (glm::length(glm::vec2(off.x, off.z) / radii) - 1.0F) * std::min(radii.x, radii.y);
}

float shoulders(const glm::vec3& p, const glm::vec3& q) {
  const float trapezius = capsule(q, {8, -100, -56}, {106, -196, -56}, 23, 27);
  const float arms = capsule(q, {0, -240, -44}, {150, -226, -48}, 46, 42);
  return smoothMin(smoothMin(trapezius, arms, 30), ellipsoid(p, {0, -262, -28}, {150, 72, 66}), 30);
}

class PinnedForm {
 public:
  PinnedForm() : m_pull(samples(), kPinSmoothing) {}
  float operator()(const glm::vec3& p) const {
    const float rough = roughForm(p);
    // Away from the surface the pull is of no use, and it must not make a second surface.
    const float share = fade(10.0F, 40.0F, std::abs(rough));
    return share <= 0.0F ? rough : rough - share * glm::clamp(m_pull(p), -25.0F, 25.0F);
  }

 private:
  static std::vector<ThinPlate::Sample> samples() {
    std::vector<ThinPlate::Sample> list;
    const auto add = [&](const glm::vec3& p, double value) {
      list.push_back({p, value});
      if (p.x > 0.0F) list.push_back({{-p.x, p.y, p.z}, value});
    };
    for (const Pin& pin : headPins()) add(pin.place, roughForm(pin.place));
    for (const glm::vec3& anchor : headAnchors()) add(anchor, 0.0);
    return list;
  }
  ThinPlate m_pull;
};

std::size_t latticeIndex(int x, int y, int z) {
  return (static_cast<std::size_t>(z) * kCounts.y + static_cast<std::size_t>(y)) * kCounts.x +
         static_cast<std::size_t>(x);
}

std::array<float, 4> catmullRomWeights(float t) {
  const float t2 = t * t, t3 = t2 * t;
  return {0.5F * (-t + 2.0F * t2 - t3), 0.5F * (2.0F - 5.0F * t2 + 3.0F * t3), 0.5F * (t + 4.0F * t2 - 3.0F * t3),
          0.5F * (t3 - t2)};
}

}  // namespace

float roughForm(const glm::vec3& p) {
  const glm::vec3 q = mirrored(p, 3.0F);
  float skull = ellipsoid(p, {0, 38, -4}, {76, 80, 94});
  skull = smoothMin(skull, ellipsoid(p, {0, 42, 32}, {60, 58, 64}), 20);
  skull = smoothMin(skull, ellipsoid(p, {0, 20, -40}, {68, 55, 59}), 25);
  float face = ellipsoid(p, {0, -32, 36}, {58, 82, 58});
  face = smoothMin(face, ellipsoid(p, {0, -68, 66}, {34, 40, 34}), 25);
  face = smoothMin(face, ellipsoid(q, {42, -22, 56}, {24, 20, 22}), 18);
  face = smoothMin(face, capsule(q, {50, -66, 14}, {14, -100, 78}, 12, 14), 22);
  face = smoothMin(face, capsule(q, {52, -30, 14}, {50, -66, 14}, 14, 12), 20);
  const float head = smoothMin(smoothMin(skull, face, 22), neck(p), 18);
  return smoothMin(head, shoulders(p, q), 44);
}

BaseForm::BaseForm() : m_lattice(latticeIndex(0, 0, kCounts.z)) {
  const PinnedForm form;
  const std::size_t rows = latticeIndex(0, 0, kCounts.z) / static_cast<std::size_t>(kCounts.x);
  forPieces(
      rows, 16, {},
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
          const int y = static_cast<int>(row) % kCounts.y, z = static_cast<int>(row) / kCounts.y;
          for (int x = 0; x <= kCounts.x / 2; ++x)
            m_lattice[latticeIndex(x, y, z)] = m_lattice[latticeIndex(kCounts.x - 1 - x, y, z)] =
                form(kOrigin + kSpacing * glm::vec3(x, y, z));
        }
      },
      [](float) {});
}

float BaseForm::operator()(const glm::vec3& p) const {
  const glm::vec3 at = glm::clamp((p - kOrigin) / kSpacing, glm::vec3(1.0F), glm::vec3(kCounts) - 2.001F);
  const glm::ivec3 cell(at);
  const glm::vec3 t = at - glm::vec3(cell);
  const std::array<float, 4> wx = catmullRomWeights(t.x), wy = catmullRomWeights(t.y), wz = catmullRomWeights(t.z);
  float sum = 0.0F;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      const float* row = &m_lattice[latticeIndex(cell.x - 1, cell.y - 1 + j, cell.z - 1 + k)];
      sum += wz[static_cast<std::size_t>(k)] * wy[static_cast<std::size_t>(j)] *
             (row[0] * wx[0] + row[1] * wx[1] + row[2] * wx[2] + row[3] * wx[3]);
    }
  return sum;
}

}  // namespace dermis::sculpt
