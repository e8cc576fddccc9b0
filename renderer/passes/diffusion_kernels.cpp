#include "passes/diffusion_kernels.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/scene/mean_albedo.h"
#include "passes/uniform_blocks.h"

namespace dermis {

namespace {

bool diffuses(const Material& material) {
  return material.model == ShadingModel::Skin || material.model == ShadingModel::Eye;
}

/// Mean of the channels that spread at all.
double meanOf(const glm::dvec3& values, const glm::dvec3& spreading) {
  const double total = spreading.x + spreading.y + spreading.z;
  return total > 0.0 ? glm::dot(values, spreading) / total : 0.0;
}

/// The table of profiles.glsl.
void fillTable(DiffusionKernel& kernel, const DiffusionProfile& profile, const glm::dvec3& spreading, double extent) {
  constexpr double kLast = kProfileTableSize - 1;
  const glm::dvec3 direct = profile.direct();
  const glm::dvec3 rest = glm::max(1.0 - direct, 1e-12);
  const auto radiusAt = [&](double i) { return extent * std::pow(i / kLast, 4.0); };
  for (std::size_t i = 0; i < kProfileTableSize; ++i) {
    // r R(r) is finite at 0, but R itself needn't be.
    const double r = std::max(radiusAt(static_cast<double>(i)), 1e-9 * extent);
    const glm::dvec3 density = spreading * r * profile.value(r) / rest;
    kernel.densities.at(i) = glm::vec4(density, 0.0F);
  }
  // The radii of equal shares: the mean's distribution on a finer grid, read the other way round.
  constexpr int kFine = 8;
  const auto within = [&](double r) { return meanOf((profile.radialCdf(r) - direct) / rest, spreading); };
  const double all = within(extent);
  double lowRadius = 0.0, low = 0.0;
  std::size_t next = 0;
  for (int i = 1; i <= kFine * static_cast<int>(kLast); ++i) {
    const double highRadius = radiusAt(static_cast<double>(i) / kFine);
    const double high = within(highRadius) / all;
    for (; next < kProfileTableSize; ++next) {
      const double share = static_cast<double>(next) / kLast;
      if (share > high && i < kFine * static_cast<int>(kLast)) break;
      const double at = high > low ? std::clamp((share - low) / (high - low), 0.0, 1.0) : 0.0;
      kernel.radii.at(next).x = static_cast<float>(lowRadius + at * (highRadius - lowRadius));
    }
    lowRadius = highRadius;
    low = high;
  }
  for (std::size_t i = 0; i + 1 < kProfileTableSize; ++i)
    kernel.radii.at(i).y = kernel.radii.at(i + 1).x - kernel.radii.at(i).x;
}

/// Cells for two passes: the borders grow as a power of their number, which leaves the least error of a step edge with
/// few taps for profiles of both families.
void fillCells(DiffusionKernel& kernel, const DiffusionProfile& profile, const glm::dvec3& spreading, double extent) {
  constexpr double kPower = 2.5, kCutOff = 0.005;
  const glm::dvec3 direct = profile.direct();
  const glm::dvec3 rest = glm::max(1.0 - direct, 1e-12);
  const auto beyond = [&](double x) { return (1.0 - profile.edgeSpread(x)) / rest; };
  double low = 0.0, high = extent;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (meanOf(beyond(middle), spreading) > kCutOff ? low : high) = middle;
  }
  const double reach = 0.5 * (low + high);
  constexpr double kCells = 2.0 * kSideTaps + 1.0;
  glm::dvec3 last(0.5), sum(0.0);
  std::array<glm::dvec3, kSideTaps + 1> shares{};
  std::array<double, kSideTaps + 2> borders{};
  for (std::size_t i = 0; i <= kSideTaps; ++i) {
    borders.at(i + 1) = reach * std::pow((2.0 * static_cast<double>(i) + 1.0) / kCells, kPower);
    const glm::dvec3 next = beyond(borders.at(i + 1));
    shares.at(i) = (i == 0 ? 2.0 : 1.0) * (last - next) * spreading;
    sum += (i == 0 ? 1.0 : 2.0) * shares.at(i);
    last = next;
  }
  // The middle cell's half width stands where the others have their beginning.
  borders[0] = borders[1];
  for (std::size_t i = 0; i <= kSideTaps; ++i)
    kernel.cells.at(i) = glm::vec4(shares.at(i) / glm::max(sum, 1e-12), borders.at(i));
  kernel.cells.back().w = static_cast<float>(borders.back());
}

}  // namespace

std::size_t profileCount(const ResolvedScene& scene) {
  const auto count = std::count_if(scene.slots.begin(), scene.slots.end(),
                                   [](const ResolvedMaterial& slot) { return diffuses(slot.material); });
  return std::min(static_cast<std::size_t>(count), kMaxProfiles);
}

DiffusionKernel makeDiffusionKernel(const DiffusionProfile& profile) {
  DiffusionKernel kernel;
  const glm::dvec3 extents = profile.extent();
  const double extent = std::max({extents.x, extents.y, extents.z});
  const glm::dvec3 direct = profile.direct();
  if (!(extent > 0.0)) return kernel;
  const glm::dvec3 spreading(extents.x > 0.0 ? 1.0 : 0.0, extents.y > 0.0 ? 1.0 : 0.0, extents.z > 0.0 ? 1.0 : 0.0);
  kernel.direct = glm::vec4(glm::mix(glm::dvec3(1.0), direct, spreading), extent);
  const glm::dvec3 lengths = profile.lengths();
  kernel.tolerance = static_cast<float>(std::max({lengths.x, lengths.y, lengths.z}));
  fillTable(kernel, profile, spreading, extent);
  fillCells(kernel, profile, spreading, extent);
  return kernel;
}

glm::vec3 DiffusionKernels::meanAlbedo(const ResolvedScene& scene, std::size_t slot) {
  const ResolvedMaterial& material = scene.slots[slot];
  const MeanOf of{material.images.at(static_cast<std::size_t>(TextureSlot::Albedo)), scene.model,
                  material.material.texture(TextureSlot::Albedo)};
  if (!(of == m_meansOf[slot])) {
    m_meansOf[slot] = of;
    m_means[slot] = meanOfAlbedoMap(scene, slot);
  }
  return material.material.parameters.baseAlbedo.rgb * m_means[slot];
}

std::uint64_t DiffusionKernels::update(const ResolvedScene& scene, Warnings& messages) {
  const std::size_t slots = scene.slots.size();
  m_meansOf.resize(slots);
  m_means.resize(slots, glm::vec3(1.0F));
  m_ids.assign(slots, 0);
  std::vector<Used> wanted;
  for (std::size_t i = 0; i < slots; ++i) {
    const Material& material = scene.slots[i].material;
    if (!diffuses(material)) continue;
    const Used used{DiffusionProfile::of(material, meanAlbedo(scene, i)),
                    material.parameters.subsurfaceBoundaryColor.rgb};
    if (wanted.size() < kMaxProfiles) {
      wanted.push_back(used);
      m_ids[i] = static_cast<int>(wanted.size());
      continue;
    }
    // No place of its own: one that is the same will do.
    const auto same = std::find(wanted.begin(), wanted.end(), used);
    if (same != wanted.end()) {
      m_ids[i] = static_cast<int>(same - wanted.begin()) + 1;
    } else {
      messages.push_back("\"" + scene.model->slots[i].name + "\" is drawn without diffusion: a scene can have " +
                         std::to_string(kMaxProfiles) + " materials with different diffusion; give some the same.");
    }
  }

  std::uint64_t made = 0;
  if (!m_buffer) {
    m_buffer = gl::Buffer::writable("diffusion profiles", sizeof(ProfileBlock));
    m_table = gl::Texture::create({.format = GL_RGBA32F,
                                   .width = static_cast<int>(kProfileTableSize),
                                   .height = 2 * static_cast<int>(kMaxProfiles),
                                   .label = "diffusion profiles"});
    m_table.setFilter(GL_NEAREST, GL_NEAREST);
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i < m_used.size() && m_used[i] == wanted[i]) continue;
    const DiffusionKernel kernel = makeDiffusionKernel(wanted[i].profile);
    m_block.direct.at(i) = kernel.direct;
    m_block.boundary.at(i) = glm::vec4(wanted[i].boundary, kernel.tolerance);
    for (std::size_t k = 0; k < kernel.cells.size(); ++k)
      m_block.cells.at(i * kernel.cells.size() + k) = kernel.cells.at(k);
    for (const auto* row : {&kernel.densities, &kernel.radii})
      glTextureSubImage2D(m_table.id(), 0, 0, static_cast<GLint>(2 * i + (row == &kernel.radii ? 1 : 0)),
                          static_cast<GLsizei>(kProfileTableSize), 1, GL_RGBA, GL_FLOAT, row->data());
    ++made;
  }
  if (made > 0) m_buffer.update(0, bytesOf(m_block));
  m_used = std::move(wanted);
  return made;
}

float DiffusionKernels::reachMm() const {
  float reach = 0.0F;
  for (std::size_t i = 0; i < m_used.size(); ++i) reach = std::max(reach, m_block.direct.at(i).w);
  return reach;
}

void DiffusionKernels::bind() const {
  m_buffer.bindUniform(kProfileBinding);
  m_table.bind(kProfileTableUnit);
}

}  // namespace dermis
