#include "core/builtin/head/ear_map.h"

#include <limits>

#include "core/builtin/head/sdf.h"
#include "core/builtin/head/stroke.h"

namespace dermis::sculpt {
namespace {

constexpr float kStep = 0.3F;
constexpr glm::vec2 kLow(-16, -42), kHigh(34, 36);

using Outline = std::vector<glm::vec2>;

/// A closed Catmull-Rom curve through the points, as a polygon.
Outline closedCurve(const Outline& points) {
  constexpr std::size_t kPieces = 6;
  Outline curve;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::vec2 &a = points[(i + n - 1) % n], &b = points[i], &c = points[(i + 1) % n], &d = points[(i + 2) % n];
    for (std::size_t k = 0; k < kPieces; ++k) {
      const float t = static_cast<float>(k) / kPieces;
      curve.push_back(0.5F * (2.0F * b + (c - a) * t + (2.0F * a - 5.0F * b + 4.0F * c - d) * t * t +
                              (3.0F * b - a - 3.0F * c + d) * t * t * t));
    }
  }
  return curve;
}

float signedDistance(const Outline& polygon, const glm::vec2& p) {
  float nearest = std::numeric_limits<float>::max();
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const glm::vec2 a = polygon[i], along = polygon[j] - a, off = p - a;
    const float h = glm::clamp(glm::dot(off, along) / glm::dot(along, along), 0.0F, 1.0F);
    nearest = std::min(nearest, glm::length(off - along * h));
    if ((a.y > p.y) != (polygon[j].y > p.y) && off.x < along.x * off.y / along.y) inside = !inside;
  }
  return inside ? -nearest : nearest;
}

Outline earOutline() {
  return closedCurve({{-3, 4},
                      {-4, 11},
                      {-3, 19},
                      {0.5F, 26},
                      {7, 30.8F},
                      {15, 31.2F},
                      {22.5F, 27.5F},
                      {27.5F, 20},
                      {29.3F, 10},
                      {28, -1},
                      {24.6F, -11},
                      {20.2F, -19.5F},
                      {16.4F, -27},
                      {10.4F, -32.4F},
                      {3, -32.2F},
                      {-2.2F, -26.5F},
                      {-4, -16},
                      {-4, -5}});
}
Outline conchaOutline() {
  return closedCurve({{-1, 1},
                      {0, 8.5F},
                      {5, 11.5F},
                      {11, 10.5F},
                      {15, 5.5F},
                      {16, -1},
                      {14, -7},
                      {9.5F, -11},
                      {4.5F, -13.2F},
                      {1, -12.5F},
                      {-1, -8},
                      {-2, -3}});
}
Stroke antihelix() {
  return Stroke({{{8.0F, -14.0F, 0}, 3.4F, 1.4F},
                 {{13, -11.5F, 0}, 3.6F, 2.6F},
                 {{17.6F, -5, 0}, 4.0F, 3.3F},
                 {{19, 3, 0}, 4.2F, 3.4F},
                 {{17.5F, 10, 0}, 4.4F, 3.2F},
                 {{14.6F, 16, 0}, 4.0F, 3.0F},
                 {{12.2F, 22, 0}, 3.8F, 2.0F},
                 {{11, 26, 0}, 4, 0.3F}},
                8);
}
Stroke lowerCrus() {
  return Stroke({{{16.5F, 11.0F, 0}, 3.8F, 0.7F},
                 {{11, 13.0F, 0}, 3.4F, 2.6F},
                 {{5, 14.0F, 0}, 3.2F, 2.0F},
                 {{0.5F, 14.0F, 0}, 3.2F, 0.6F}},
                8);
}
Stroke scapha() {
  return Stroke({{{5, 24.5F, 0}, 3.0F, -1.2F},
                 {{13.5F, 25, 0}, 3.2F, -1.8F},
                 {{20, 21.5F, 0}, 3.6F, -2.4F},
                 {{23.5F, 14, 0}, 3.6F, -2.6F},
                 {{24, 5, 0}, 3.6F, -2.6F},
                 {{21.8F, -5, 0}, 3.4F, -1.7F},
                 {{17.5F, -13, 0}, 3.2F, -0.5F},
                 {{14, -18, 0}, 3, -0.2F}},
                8);
}
float blob(const glm::vec2& p, const glm::vec2& centre, const glm::vec2& squaredWidths) {
  const glm::vec2 off = p - centre;
  return std::exp(-glm::dot(off * off, 1.0F / squaredWidths));
}

}  // namespace

std::size_t EarMap::index(int i, int j) const {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(i);
}

EarMap::EarMap()
    : m_width(static_cast<int>((kHigh.x - kLow.x) / kStep) + 1),
      m_rows(static_cast<int>((kHigh.y - kLow.y) / kStep) + 1) {
  const Outline outline = earOutline(), conchaEdge = conchaOutline();
  const std::vector<Stroke> folds = {antihelix(), lowerCrus(), scapha()};
  m_samples.reserve(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_rows));
  for (int j = 0; j < m_rows; ++j)
    for (int i = 0; i < m_width; ++i) {
      const glm::vec2 p = kLow + kStep * glm::vec2(i, j);
      const float concha = signedDistance(conchaEdge, p);
      float height = -glm::mix(9.0F, 11.5F, fade(-6.0F, 4.0F, p.y)) * fade(-4.2F, 1.6F, concha);
      height += raisedBy(folds, {p.x, p.y, 0.0F});
      height -= 2.2F * blob(p, {8.0F, 19.6F}, {20, 14});                          // triangular fossa
      height += 1.1F * blob(p, {8.2F, -14.2F}, {26, 20});                         // antitragus
      height += 1.4F * blob(p, {5.5F, -25}, {60, 60});                            // the lobe's swelling
      height -= fade(-30.0F, -12.0F, p.y) + 0.03F * std::max(0.0F, p.y - 14.0F);  // lobe and top turn in a little
      const float thickness = 2.7F + 2.2F * blob(p, {6, -25}, {90, 90}) + 1.2F * fade(-3.0F, 2.0F, concha);
      m_samples.push_back({height, signedDistance(outline, p), thickness, concha});
    }
  for (int round = 0; round < 6; ++round) smoothHeights();
}

void EarMap::smoothHeights() {
  const std::vector<Sample> before = m_samples;
  for (int j = 1; j + 1 < m_rows; ++j)
    for (int i = 1; i + 1 < m_width; ++i) {
      float height = 0.0F, thickness = 0.0F;
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const float weight = (x == 0 ? 2.0F : 1.0F) * (y == 0 ? 2.0F : 1.0F) / 16.0F;
          height += weight * before[index(i + x, j + y)].height;
          thickness += weight * before[index(i + x, j + y)].thickness;
        }
      m_samples[index(i, j)].height = height;
      m_samples[index(i, j)].thickness = thickness;
    }
}

EarMap::Sample EarMap::at(float v, float u) const {
  const float x = glm::clamp((v - kLow.x) / kStep, 0.0F, static_cast<float>(m_width) - 1.001F);
  const float y = glm::clamp((u - kLow.y) / kStep, 0.0F, static_cast<float>(m_rows) - 1.001F);
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
  const Sample &a = m_samples[index(i, j)], &b = m_samples[index(i + 1, j)], &c = m_samples[index(i, j + 1)],
               &d = m_samples[index(i + 1, j + 1)];
  const auto mixed = [&](float Sample::*field) {
    return glm::mix(glm::mix(a.*field, b.*field, s), glm::mix(c.*field, d.*field, s), t);
  };
  return {mixed(&Sample::height), mixed(&Sample::outline), mixed(&Sample::thickness), mixed(&Sample::concha)};
}

float EarMap::steepness(float v, float u) const {
  constexpr float kDelta = 0.4F;
  const float here = at(v, u).height;
  const glm::vec2 slope((at(v + kDelta, u).height - here) / kDelta, (at(v, u + kDelta).height - here) / kDelta);
  return 1.0F / std::sqrt(1.0F + glm::dot(slope, slope));
}

float EarMap::beyond(float v, float u) {
  return std::max(std::max(kLow.x - v, v - kHigh.x), std::max(kLow.y - u, u - kHigh.y));
}

}  // namespace dermis::sculpt
