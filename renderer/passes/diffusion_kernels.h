// The diffusion profiles of a scene's materials as the shaders read them: resources/shaders/subsurface/profiles.glsl.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/material/diffusion_profile.h"
#include "core/scene/resolved_scene.h"
#include "gl/gl_objects.h"

namespace dermis {

inline constexpr unsigned kProfileBinding = 4, kProfileTableUnit = 26;
inline constexpr std::size_t kMaxProfiles = 16;
inline constexpr std::size_t kSideTaps = 6;
inline constexpr std::size_t kProfileTableSize = 1024;

/// std140 twin of ProfileBlock.
struct ProfileBlock {
  std::array<glm::vec4, kMaxProfiles> direct{};
  std::array<glm::vec4, kMaxProfiles> boundary{};
  std::array<glm::vec4, kMaxProfiles*(kSideTaps + 2)> cells{};
};

/// One profile's numbers.
struct DiffusionKernel {
  glm::vec4 direct{1.0F, 1.0F, 1.0F, 0.0F};
  float tolerance = 0.0F;
  std::array<glm::vec4, kSideTaps + 2> cells{};
  std::array<glm::vec4, kProfileTableSize> densities{}, radii{};  ///< the two rows of the table
};
/// How many materials of a scene have a profile of their own.
[[nodiscard]] std::size_t profileCount(const ResolvedScene& scene);

[[nodiscard]] DiffusionKernel makeDiffusionKernel(const DiffusionProfile& profile);

class DiffusionKernels {
 public:
  /// Looks at the scene's materials and makes again what has changed. Returns how many kernels were made.
  std::uint64_t update(const ResolvedScene& scene, Warnings& messages);

  /// The profile id of a slot: 0 where its material doesn't diffuse, else 1 + its profile's index.
  [[nodiscard]] int id(std::size_t slot) const { return m_ids.at(slot); }
  /// meanAlbedo() of core/scene, of the scene that update() saw last; each map is looked at once.
  [[nodiscard]] glm::vec3 meanAlbedo(const ResolvedScene& scene, std::size_t slot);
  /// Profiles in use.
  [[nodiscard]] std::size_t count() const { return m_used.size(); }
  /// The radius that holds all profiles, mm.
  [[nodiscard]] float reachMm() const;
  void bind() const;

 private:
  struct Used {
    DiffusionProfile profile;
    glm::vec3 boundary{1.0F};
    bool operator==(const Used&) const = default;
  };
  /// What the mean of a slot's albedo map was taken of.
  struct MeanOf {
    std::shared_ptr<const Image> image;
    std::shared_ptr<const Model> model;
    TextureBinding binding;
    bool operator==(const MeanOf&) const = default;
  };
  std::vector<Used> m_used;
  std::vector<int> m_ids;
  std::vector<MeanOf> m_meansOf;
  std::vector<glm::vec3> m_means;
  ProfileBlock m_block;
  gl::Buffer m_buffer;
  gl::Texture m_table;
};

}  // namespace dermis
