// The light around the scene, resident on the GPU and ready to sample.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/bake/harmonics.h"
#include "core/scene/resolved_scene.h"
#include "gl/gl_objects.h"
#include "gl/job_queue.h"
#include "lighting/environment_bake.h"

namespace dermis {

/// The three cube maps of lighting/environment.glsl. Multiply what they hold by scale() to get radiance:
/// `u_environment_scale.x = exp2(exposure_stops) * scale()`; u_environment_from_world turns world directions by
/// −rotation_degrees about +Y (see environmentFromWorld).
class EnvironmentMap {
 public:
  static constexpr GLuint kPrefilteredUnit = 16, kIrradianceUnit = 17, kSharpUnit = 20;

  void bind() const;
  [[nodiscard]] float scale() const { return m_scale; }
  [[nodiscard]] const EnvironmentFigures& figures() const { return m_figures; }
  [[nodiscard]] std::size_t bytes() const;
  /// Of what the cubes hold, in the environment's own axes.
  [[nodiscard]] const Harmonics<glm::vec3>& harmonics() const { return m_harmonics; }

  [[nodiscard]] const gl::Texture& prefiltered() const { return m_prefiltered; }
  [[nodiscard]] const gl::Texture& irradiance() const { return m_irradiance; }
  [[nodiscard]] const gl::Texture& sharp() const { return m_sharp; }

 private:
  friend class EnvironmentUpload;
  gl::Texture m_prefiltered, m_irradiance, m_sharp;
  float m_scale = 1.0F;
  Harmonics<glm::vec3> m_harmonics{};
  EnvironmentFigures m_figures;
};

/// Rotation that takes world directions into the environment's own: turning the environment by `rotationDegrees` about
/// +Y (counter-clockwise seen from above) is looking it up turned the other way.
[[nodiscard]] glm::mat4 environmentFromWorld(float rotationDegrees);

/// Called on the GL thread with the complete map, its figures and warnings.
using EnvironmentReady = std::function<void(std::shared_ptr<const EnvironmentMap>, Warnings)>;

/// Bakes (or reads from the disk cache) on worker threads and uploads in slices; calls `ready` at the end. Dropping the
/// job cancels the workers: whoever holds the last map keeps it.
[[nodiscard]] std::unique_ptr<gl::Job> makeEnvironmentJob(std::shared_ptr<const EnvironmentImages> images,
                                                          EnvironmentBakeOptions options, EnvironmentReady ready);

/// The same at once, for tests and command-line bakes.
[[nodiscard]] Result<std::shared_ptr<const EnvironmentMap>> makeEnvironmentMap(
    const std::shared_ptr<const EnvironmentImages>& images, const EnvironmentBakeOptions& options, Warnings& warnings);

}  // namespace dermis
