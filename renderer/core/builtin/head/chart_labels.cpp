#include "core/builtin/head/chart_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>

#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {
namespace {

constexpr float kBaseHeight = -218.0F;

std::pair<std::uint32_t, std::uint32_t> undirected(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

/// The chart of a place with x ≥ 0 on the left, by geometry alone.
Chart leftChartAt(const glm::vec3& q, const glm::vec3& normal, const Sculpt& sculpt) {
  if (q.y < kBaseHeight && normal.y < -0.7F) return Chart::Base;
  const float fromEye = glm::distance(q, kEyeCentre);
  constexpr float kSocketSkin = 0.35F, kHidden = 1.2F;
  if (fromEye < kEyeRadius + kLidGap + kSocketSkin && (q.z < kEyeCentre.z || sculpt.lids().opening(q) > kHidden))
    return q.z < kEyeCentre.z ? Chart::SocketBackL : Chart::SocketFrontL;
  if (q.x < 20.0F && q.z > 75.0F && q.y > -41.0F && q.y < -20.0F && Nose::nostril(q) < 0.6F) return Chart::NostrilL;
  if (q.x < 55.0F) return Chart::Face;
  const glm::vec3 at = sculpt.ear().local(q);
  if (EarMap::beyond(at.x, at.y) > 0.0F) return Chart::Face;
  const EarMap::Sample map = sculpt.ear().map().at(at.x, at.y);
  const float above = at.z - map.height;
  if (map.outline > 1.5F || at.x < 1.0F || above < -0.5F * map.thickness - 4.0F || at.z > 9.0F) return Chart::Face;
  const float faces = glm::dot(normal, sculpt.ear().outwards());
  if (faces > -0.15F && (above > -0.5F * map.thickness || map.outline > -4.0F)) return Chart::EarFrontL;
  if (faces <= -0.15F) return map.concha < 1.0F && above > -0.3F * map.thickness ? Chart::EarFrontL : Chart::EarBackL;
  return Chart::Face;
}

Chart onTheRight(Chart left) {
  switch (left) {
    case Chart::EarFrontL:
      return Chart::EarFrontR;
    case Chart::EarBackL:
      return Chart::EarBackR;
    case Chart::SocketFrontL:
      return Chart::SocketFrontR;
    case Chart::SocketBackL:
      return Chart::SocketBackR;
    case Chart::NostrilL:
      return Chart::NostrilR;
    default:
      return left;
  }
}

using Neighbours = std::vector<std::array<std::uint32_t, 3>>;

Neighbours neighboursOf(const Surface& surface) {
  std::unordered_map<std::uint64_t, std::uint32_t> byEdge;
  const auto key = [](std::uint32_t a, std::uint32_t b) { return static_cast<std::uint64_t>(a) << 32U | b; };
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) byEdge[key(surface.triangles[t][i], surface.triangles[t][(i + 1) % 3])] = t;
  Neighbours neighbours(surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      neighbours[t][static_cast<std::size_t>(i)] =
          byEdge.at(key(surface.triangles[t][(i + 1) % 3], surface.triangles[t][i]));
  return neighbours;
}

/// Single triangles and teeth along the borders go over to what surrounds them.
void smoothBorders(std::vector<Chart>& charts, const Neighbours& neighbours) {
  for (int round = 0; round < 6; ++round) {
    const std::vector<Chart> before = charts;
    for (std::size_t t = 0; t < charts.size(); ++t) {
      const Chart a = before[neighbours[t][0]], b = before[neighbours[t][1]], c = before[neighbours[t][2]];
      if (a == b || a == c) charts[t] = a;
      if (b == c) charts[t] = b;
    }
  }
}

/// Of each chart only the largest piece stays; smaller ones go to a neighbouring chart.
void dropIslands(std::vector<Chart>& charts, const Neighbours& neighbours) {
  for (int round = 0; round < 3; ++round) {
    std::vector<int> piece(charts.size(), -1);
    std::vector<std::vector<std::uint32_t>> pieces;
    for (std::uint32_t first = 0; first < charts.size(); ++first) {
      if (piece[first] >= 0) continue;
      std::vector<std::uint32_t> members = {first};
      piece[first] = static_cast<int>(pieces.size());
      for (std::size_t i = 0; i < members.size(); ++i)
        for (const std::uint32_t n : neighbours[members[i]])
          if (piece[n] < 0 && charts[n] == charts[first]) {
            piece[n] = piece[first];
            members.push_back(n);
          }
      pieces.push_back(std::move(members));
    }
    std::array<std::size_t, kChartCount> largest{};
    for (const auto& members : pieces) {
      std::size_t& most = largest[static_cast<std::size_t>(charts[members[0]])];
      most = std::max(most, members.size());
    }
    for (const auto& members : pieces) {
      const Chart chart = charts[members[0]];
      if (members.size() == largest[static_cast<std::size_t>(chart)]) continue;
      Chart other = chart;
      for (const std::uint32_t t : members)
        for (const std::uint32_t n : neighbours[t])
          if (other == chart) other = charts[n];
      for (const std::uint32_t t : members) charts[t] = other;
    }
  }
}

}  // namespace

std::vector<Chart> labelCharts(const Surface& surface, const Sculpt& sculpt) {
  std::vector<Chart> charts;
  charts.reserve(surface.triangles.size());
  for (const glm::uvec3& t : surface.triangles) {
    const glm::vec3 &a = surface.points[t.x], &b = surface.points[t.y], &c = surface.points[t.z];
    glm::vec3 middle = (a + b + c) / 3.0F, normal = glm::normalize(glm::cross(b - a, c - a));
    const bool right = middle.x < 0.0F;
    if (right) {
      middle.x = -middle.x;
      normal.x = -normal.x;
    }
    const Chart chart = leftChartAt(middle, normal, sculpt);
    charts.push_back(right ? onTheRight(chart) : chart);
  }
  const Neighbours neighbours = neighboursOf(surface);
  smoothBorders(charts, neighbours);
  dropIslands(charts, neighbours);
  return charts;
}

EdgeSet backSeam(const Surface& surface, const std::vector<Chart>& charts) {
  constexpr glm::vec3 kTop(0.0F, 104.0F, -54.0F);
  std::vector<std::vector<std::uint32_t>> ways(surface.points.size());
  std::vector<bool> onBase(surface.points.size(), false);
  for (std::size_t t = 0; t < charts.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = surface.triangles[t][i], b = surface.triangles[t][(i + 1) % 3];
      if (charts[t] == Chart::Base) onBase[a] = true;
      if (charts[t] == Chart::Face) ways[a].push_back(b);
    }
  std::uint32_t start = 0;
  for (std::uint32_t v = 0; v < surface.points.size(); ++v)
    if (glm::distance(surface.points[v], kTop) < glm::distance(surface.points[start], kTop)) start = v;
  // The shortest way along edges, where being off the middle is dear (Dijkstra).
  std::vector<double> cost(surface.points.size(), std::numeric_limits<double>::max());
  std::vector<std::uint32_t> from(surface.points.size(), start);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[start] = 0.0;
  open.emplace(0.0, start);
  EdgeSet seam;
  while (!open.empty()) {
    const auto [c, v] = open.top();
    open.pop();
    if (c > cost[v]) continue;
    if (onBase[v]) {
      for (std::uint32_t at = v; at != start; at = from[at]) seam.insert(undirected(at, from[at]));
      return seam;
    }
    for (const std::uint32_t n : ways[v]) {
      const glm::vec3& p = surface.points[n];
      const double dear = 1.0 + static_cast<double>(squared(p.x / 3.0F)) + (p.z > 0.0F ? 1e3 : 0.0);
      const double next = c + dear * static_cast<double>(glm::distance(surface.points[v], p));
      if (next >= cost[n]) continue;
      cost[n] = next;
      from[n] = v;
      open.emplace(next, n);
    }
  }
  return seam;
}

}  // namespace dermis::sculpt
