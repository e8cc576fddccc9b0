#include "core/builtin/head/head_mesh.h"

#include <cmath>

#include "core/builtin/head/remesh.h"
#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {
namespace {

/// Spacing of the polygoniser's lattice. Fine enough that lids, nostrils and ears come out whole; the remesher decides
/// what becomes of the triangles.
constexpr float kSpacing = 2.6F;

std::vector<float> graded(float from, float to, float (*share)(float)) {
  std::vector<float> planes;
  for (float at = from; at < to; at += kSpacing * share(at)) planes.push_back(at);
  planes.push_back(to);
  return planes;
}
float shareOfX(float x) {
  if (x < 14.0F) return 0.75F;
  if (x < 48.0F) return 0.62F;
  if (x < 52.0F) return 0.85F;
  if (x < 66.0F) return 1.25F;
  return x < 92.0F ? 0.48F : 2.0F;  // the ears' walls are 2 mm thin
}
float shareOfY(float y) {
  if (y > -8.0F && y < 7.0F) return 0.4F;
  if (y > -71.5F && y < -66.5F) return 0.35F;
  if (y > -82.0F && y < 18.0F) return 0.66F;
  return y > -120.0F && y < 30.0F ? 1.1F : 1.8F;
}
float shareOfZ(float z) {
  if (z > 68.0F) return z < 86.0F ? 0.5F : 0.72F;
  return z > -36.0F && z < 6.0F ? 0.52F : 1.6F;
}

Lattice headLattice() {
  const std::vector<float> half = graded(0.0F, 126.0F, shareOfX);
  std::vector<float> x;
  for (std::size_t i = half.size() - 1; i > 0; --i) x.push_back(-half[i]);
  x.insert(x.end(), half.begin(), half.end());
  return {{x, graded(-228.0F, 124.0F, shareOfY), graded(-130.0F, 128.0F, shareOfZ)}};
}

/// Longest edge, mm.
float longestEdge(const glm::vec3& p) {
  const float face = ramp(30.0F, 62.0F, p.z) * ramp(-128.0F, -104.0F, p.y) * fade(34.0F, 58.0F, p.y);
  const float base = fade(-219.0F, -214.0F, p.y);
  const glm::vec3 q(std::abs(p.x), p.y, p.z);
  const float socket =
      fade(kEyeRadius + 1.0F, kEyeRadius + 1.6F, glm::distance(q, kEyeCentre)) * fade(70.0F, 78.0F, p.z);
  return std::max({glm::mix(10.0F, 4.6F, face), 14.0F * base, 4.5F * socket});
}

/// Shortest edge, mm: finest where a line is sharp, at the lids' edges, between the lips and round the nostrils.
float shortestEdge(const glm::vec3& p) {
  const glm::vec3 q(std::abs(p.x), p.y, p.z);
  const float lids =
      fade(8.0F, 13.0F, std::abs(q.y)) * fade(15.0F, 20.0F, std::abs(q.x - kEyeCentre.x)) * ramp(74.0F, 77.0F, q.z);
  const float lips = fade(2.0F, 5.0F, std::abs(q.y + 69.0F)) * fade(27.0F, 32.0F, q.x) * ramp(70.0F, 80.0F, q.z);
  const float nostrils = fade(11.0F, 15.0F, glm::distance(q, glm::vec3(7.0F, -45.0F, 103.0F)));
  return glm::mix(1.25F, lids > lips ? 0.6F : 0.7F, std::max({lids, lips, nostrils}));
}

}  // namespace

AtlasMesh coarseHeadMesh(const Sculpt& sculpt) {
  const Surface rough = polygonise([&](const glm::vec3& p) { return sculpt(p); }, headLattice());
  EdgeLengths lengths;
  lengths.tolerance = 0.3F;
  lengths.shortest = shortestEdge;
  lengths.longest = longestEdge;
  return unwrap(remesh(rough, sculpt, lengths), sculpt);
}

}  // namespace dermis::sculpt
