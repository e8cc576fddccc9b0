#include "core/builtin/head/half_edges.h"

#include <algorithm>
#include <unordered_map>

namespace dermis::sculpt {
namespace {

std::uint64_t directed(std::uint32_t from, std::uint32_t to) { return static_cast<std::uint64_t>(from) << 32U | to; }

}  // namespace

HalfEdges::HalfEdges(const Surface& surface) : points(surface.points), m_leaving(surface.points.size(), kNone) {
  std::unordered_map<std::uint64_t, std::uint32_t> edges;
  edges.reserve(surface.triangles.size() * 3);
  for (const glm::uvec3& triangle : surface.triangles)
    for (int i = 0; i < 3; ++i) {
      const auto h = static_cast<std::uint32_t>(m_origin.size());
      m_origin.push_back(triangle[i]);
      m_leaving[triangle[i]] = h;
      edges.emplace(directed(triangle[i], triangle[(i + 1) % 3]), h);
    }
  m_twin.resize(m_origin.size());
  for (std::uint32_t h = 0; h < count(); ++h) m_twin[h] = edges.at(directed(to(h), from(h)));
}

Surface HalfEdges::compacted() const {
  Surface surface;
  std::vector<std::uint32_t> number(points.size(), kNone);
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (!vertexAlive(v)) continue;
    number[v] = static_cast<std::uint32_t>(surface.points.size());
    surface.points.push_back(points[v]);
  }
  for (std::uint32_t h = 0; h < count(); h += 3)
    if (alive(h)) surface.triangles.emplace_back(number[m_origin[h]], number[m_origin[h + 1]], number[m_origin[h + 2]]);
  return surface;
}

int HalfEdges::valence(std::uint32_t v) const {
  int n = 0;
  round(v, [&](std::uint32_t) { ++n; });
  return n;
}

bool HalfEdges::adjacent(std::uint32_t a, std::uint32_t b) const {
  bool found = false;
  round(a, [&](std::uint32_t h) { found = found || to(h) == b; });
  return found;
}

void HalfEdges::pair(std::uint32_t a, std::uint32_t b) {
  m_twin[a] = b;
  m_twin[b] = a;
}

std::uint32_t HalfEdges::split(std::uint32_t h) {
  // Triangles (a b c) and (b a d) become (a m c), (m b c), (m a d), (b m d).
  const std::uint32_t g = m_twin[h], n0 = next(h), n1 = next(g), p1 = previous(g);
  const std::uint32_t a = from(h), b = to(h), c = across(h), d = across(g);
  const std::uint32_t beyondBc = m_twin[n0], beyondDb = m_twin[p1];
  const auto m = static_cast<std::uint32_t>(points.size());
  const std::uint32_t h2 = count(), g3 = h2 + 3;
  points.push_back(0.5F * (points[a] + points[b]));
  m_origin.insert(m_origin.end(), {m, b, c, b, m, d});
  m_twin.resize(m_origin.size());
  m_origin[n0] = m;
  m_origin[g] = m;
  pair(h, g);
  pair(h2, g3);
  pair(n0, h2 + 2);
  pair(p1, g3 + 1);
  pair(h2 + 1, beyondBc);
  pair(g3 + 2, beyondDb);
  (void)n1;
  m_leaving.push_back(h2);
  m_leaving[b] = h2 + 1;
  return m;
}

bool HalfEdges::canCollapse(std::uint32_t h) const {
  const std::uint32_t a = from(h), b = to(h), c = across(h), d = across(m_twin[h]);
  if (c == d || valence(c) <= 3 || valence(d) <= 3) return false;
  int shared = 0;
  round(a, [&](std::uint32_t e) { shared += to(e) != b && adjacent(to(e), b) ? 1 : 0; });
  return shared == 2;
}

void HalfEdges::collapse(std::uint32_t h) {
  const std::uint32_t g = m_twin[h], b = to(h), a = from(h), c = across(h), d = across(g);
  std::vector<std::uint32_t> leavingA;
  round(a, [&](std::uint32_t e) { leavingA.push_back(e); });
  for (const std::uint32_t e : leavingA) m_origin[e] = b;
  const std::uint32_t intoC = m_twin[previous(h)], fromC = m_twin[next(h)];  // b→c and c→b beyond the triangle
  const std::uint32_t fromD = m_twin[next(g)], intoD = m_twin[previous(g)];
  pair(intoC, fromC);
  pair(fromD, intoD);
  m_leaving[b] = intoC;
  m_leaving[c] = fromC;
  m_leaving[d] = fromD;
  m_leaving[a] = kNone;
  for (const std::uint32_t e : {h, g})
    for (std::uint32_t i = 0; i < 3; ++i) m_origin[e / 3 * 3 + i] = kNone;
}

void HalfEdges::flip(std::uint32_t h) {
  // Triangles (a b c) and (b a d) become (d c a) and (c d b).
  const std::uint32_t g = m_twin[h], n0 = next(h), p0 = previous(h), n1 = next(g), p1 = previous(g);
  const std::uint32_t a = from(h), b = to(h), c = across(h), d = across(g);
  const std::uint32_t ca = m_twin[p0], ad = m_twin[n1], db = m_twin[p1], bc = m_twin[n0];
  m_origin[h] = d;
  m_origin[n0] = c;
  m_origin[p0] = a;
  m_origin[g] = c;
  m_origin[n1] = d;
  m_origin[p1] = b;
  pair(n0, ca);
  pair(p0, ad);
  pair(n1, db);
  pair(p1, bc);
  m_leaving[a] = p0;
  m_leaving[b] = p1;
  m_leaving[c] = n0;
  m_leaving[d] = n1;
}

}  // namespace dermis::sculpt
