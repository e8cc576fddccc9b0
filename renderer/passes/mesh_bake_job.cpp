#include "passes/mesh_bake_job.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <utility>

#include "core/base/background.h"
#include "passes/scene_resources.h"

namespace dermis {
namespace {

class MeshBakeJob final : public gl::Job {
 public:
  MeshBakeJob(std::shared_ptr<const Model> model, MeshBakeOptions options,
              std::function<void(std::shared_ptr<const MeshBake>)> ready)
      : m_ready(std::move(ready)) {
    options.stop = m_stop.get_token();
    options.progress = &m_progress;
    m_baked = std::async(std::launch::async, [model = std::move(model), options = std::move(options)] {
      giveWay();
      return bakeMesh(*model, options);
    });
  }
  ~MeshBakeJob() override {
    m_stop.request_stop();
    if (m_baked.valid()) m_baked.wait();
  }
  MeshBakeJob(const MeshBakeJob&) = delete;
  MeshBakeJob& operator=(const MeshBakeJob&) = delete;

  Result<bool> step() override {
    // A short wait, so that running the job to its end doesn't spin.
    if (m_baked.wait_for(std::chrono::milliseconds(4)) != std::future_status::ready) return false;
    auto baked = m_baked.get();
    if (!baked) return tl::unexpected(baked.error());
    m_ready(std::move(*baked));
    return true;
  }
  std::string text() const override { return "Measuring thickness and occlusion"; }
  double fraction() const override { return m_progress.load(); }

 private:
  std::function<void(std::shared_ptr<const MeshBake>)> m_ready;
  std::stop_source m_stop;
  std::atomic<float> m_progress = 0.0F;
  std::future<Result<std::shared_ptr<const MeshBake>>> m_baked;
};

}  // namespace

bool usesMeshBake(const ResolvedScene& scene) {
  return std::any_of(scene.slots.begin(), scene.slots.end(), [](const ResolvedMaterial& slot) {
    return slot.material.model == ShadingModel::Skin || slot.material.model == ShadingModel::Eye;
  });
}

std::vector<bool> castingSlots(const ResolvedScene& scene) {
  std::vector<bool> casting;
  for (const ResolvedMaterial& slot : scene.slots) casting.push_back(!isBlended(slot.material));
  return casting;
}

MeshBakeOptions meshBakeOptions(const ResolvedScene& scene) {
  MeshBakeOptions options;
  options.millimetresPerUnit = scene.millimetresPerUnit;
  options.castingSlots = castingSlots(scene);
  return options;
}

void MeshBakes::want(const ResolvedScene& scene, const std::filesystem::path& cacheFolder, gl::JobQueue& jobs) {
  constexpr const char* kJob = "mesh bake";
  if (scene.bake || !usesMeshBake(scene)) {
    jobs.cancel(kJob);
    m_wanted = {};
    return;
  }
  Key key{scene.model, scene.millimetresPerUnit, castingSlots(scene)};
  if (key == m_wanted) return;
  m_wanted = key;
  if (key == m_bakedOf) {
    jobs.cancel(kJob);  // back to the one in use before the other was ready
    return;
  }
  MeshBakeOptions options = meshBakeOptions(scene);
  options.cacheFolder = cacheFolder;
  jobs.addLast(kJob, std::make_unique<MeshBakeJob>(scene.model, std::move(options),
                                                   [this, key = std::move(key)](std::shared_ptr<const MeshBake> bake) {
                                                     m_bake = std::move(bake);
                                                     m_bakedOf = key;
                                                     ++m_revision;
                                                   }));
}

std::shared_ptr<const MeshBake> MeshBakes::of(const ResolvedScene& scene) const {
  if (scene.bake) return scene.bake;
  // Lengths would be wrong at another scale, and vertices not even there in another model.
  const bool fits = m_bakedOf.model == scene.model && m_bakedOf.millimetresPerUnit == scene.millimetresPerUnit;
  return fits && usesMeshBake(scene) ? m_bake : nullptr;
}

}  // namespace dermis
