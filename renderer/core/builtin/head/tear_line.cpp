#include "core/builtin/head/tear_line.h"

#include <array>
#include <cmath>

#include "core/builtin/head/asymmetry.h"
#include "core/builtin/head/eyes.h"
#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {
namespace {

constexpr int kAcross = 4;                  // quads from the eyeball to the lid
constexpr float kFrom = -9.4F, kTo = 9.8F;  // mm outwards of the eye's middle: the eyeball still faces ahead

/// A point over the front of the eyeball, `off` mm before it along the view from the front.
glm::vec3 overEye(float x, float y, float off) {
  return kEyeCentre + glm::vec3(x, y, frontOfEye(std::sqrt(x * x + y * y)) + off);
}

/// Height of the lower lid's margin `off` mm before the eyeball: where the fissure ends and the lid begins.
float marginHeight(const Sculpt& sculpt, float x, float off) {
  constexpr int kHalvings = 14;
  const float edge = sculpt.lids().lowerEdge(x);
  float lid = edge - 2.5F, open = edge + 1.5F;
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = 0.5F * (lid + open);
    (sculpt(overEye(x, middle, off)) < 0.0F ? lid : open) = middle;
  }
  return 0.5F * (lid + open);
}

using Section = std::array<glm::vec3, kAcross + 1>;

/// From the eyeball down to the lid's margin, hollow between them. `fullness` 0..1.
Section sectionAt(const Sculpt& sculpt, float x, float fullness) {
  constexpr float kHeight = 0.34F, kDepth = 0.55F, kFilm = 0.04F, kNear = 0.3F;
  const float corner = marginHeight(sculpt, x, kNear), out = kNear + kDepth * fullness;
  const glm::vec3 top = overEye(x, corner + kHeight * fullness, kFilm);
  const glm::vec3 foot = overEye(x, marginHeight(sculpt, x, out) + kFilm * fullness, out);
  const glm::vec3 hollow = glm::mix(0.5F * (top + foot), overEye(x, corner, kFilm), 0.75F);
  Section section{};
  for (int i = 0; i <= kAcross; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(kAcross);
    section.at(static_cast<std::size_t>(i)) = squared(1.0F - t) * top + 2.0F * t * (1.0F - t) * hollow + t * t * foot;
  }
  return section;
}

void addStrip(Model& model, const std::vector<Section>& sections, bool left) {
  const auto first = static_cast<std::uint32_t>(model.positions.size());
  const std::size_t last = sections.size() - 1;
  for (std::size_t s = 0; s <= last; ++s)
    for (std::size_t i = 0; i <= kAcross; ++i) {
      const glm::vec3 along = sections[std::min(s + 1, last)].at(i) - sections[s == 0 ? 0 : s - 1].at(i);
      const glm::vec3 down = sections[s].at(std::min<std::size_t>(i + 1, kAcross)) - sections[s].at(i == 0 ? 0 : i - 1);
      glm::vec3 p = sections[s].at(i), normal = glm::normalize(glm::cross(down, along));
      if (!left) {
        p.x = -p.x;
        normal.x = -normal.x;
      }
      model.positions.push_back(asymmetrical(p));
      model.normals.push_back(normal);
      model.uvs.emplace_back(static_cast<float>(s) / static_cast<float>(last), static_cast<float>(i) / kAcross);
    }
  constexpr std::uint32_t kRow = kAcross + 1;
  for (std::uint32_t s = 0; s < last; ++s)
    for (std::uint32_t i = 0; i < kAcross; ++i) {
      const std::uint32_t a = first + s * kRow + i, b = a + 1, c = a + kRow, d = c + 1;
      if (left)
        model.indices.insert(model.indices.end(), {a, b, d, a, d, c});
      else
        model.indices.insert(model.indices.end(), {a, d, b, a, c, d});
    }
}

}  // namespace

Model makeTearLine(const Sculpt& sculpt, int pieces) {
  std::vector<Section> sections;
  for (int s = 0; s <= pieces; ++s) {
    const float x = glm::mix(kFrom, kTo, static_cast<float>(s) / static_cast<float>(pieces));
    sections.push_back(sectionAt(sculpt, x, ramp(kFrom, kFrom + 3.0F, x) * fade(kTo - 3.0F, kTo, x)));
  }
  Model model;
  model.slots.push_back({"lens", Material{}});
  for (const bool left : {true, false}) addStrip(model, sections, left);
  for (const glm::vec3& p : model.positions) model.bounds.grow(p);
  model.tangents.resize(model.positions.size(), glm::vec4(0.0F));
  model.parts = {{0, 0, static_cast<std::uint32_t>(model.indices.size())}};
  return model;
}

}  // namespace dermis::sculpt
