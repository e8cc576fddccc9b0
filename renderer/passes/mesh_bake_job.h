// Baking a scene's model beside the frames.
#pragma once

#include <functional>
#include <memory>

#include "core/bake/mesh_bake.h"
#include "core/scene/resolved_scene.h"
#include "gl/job_queue.h"

namespace dermis {

/// Whether some material looks at what is baked: those whose light goes through a body.
[[nodiscard]] bool usesMeshBake(const ResolvedScene& scene);

/// By slot: false for what light passes (lenses, blended materials).
[[nodiscard]] std::vector<bool> castingSlots(const ResolvedScene& scene);

/// How the scene's model is baked for it, without a cache folder.
[[nodiscard]] MeshBakeOptions meshBakeOptions(const ResolvedScene& scene);

/// The bake of the scene on screen, and the one on its way.
class MeshBakes {
 public:
  /// Queues a job where the scene needs what isn't there.
  void want(const ResolvedScene& scene, const std::filesystem::path& cacheFolder, gl::JobQueue& jobs);
  /// Forgets what was asked for: the next scene with another model asks again.
  void cancelled() { m_wanted = {}; }

  /// What belongs to the scene's vertices; null where nothing is known yet.
  [[nodiscard]] std::shared_ptr<const MeshBake> of(const ResolvedScene& scene) const;
  /// Grows whenever a bake is complete.
  [[nodiscard]] std::uint64_t revision() const { return m_revision; }

 private:
  struct Key {
    std::shared_ptr<const Model> model;
    float millimetresPerUnit = 0.0F;
    std::vector<bool> casting;
    bool operator==(const Key&) const = default;
  };
  Key m_wanted, m_bakedOf;
  std::shared_ptr<const MeshBake> m_bake;
  std::uint64_t m_revision = 0;
};

}  // namespace dermis
