#include "lighting/environment_map.h"

#include <atomic>
#include <chrono>
#include <future>
#include <glm/gtc/matrix_transform.hpp>
#include <thread>
#include <utility>

#include "core/base/background.h"
#include "lighting/spherical_harmonics.h"

namespace dermis {
namespace {

GLenum formatOf(TexelStorage storage) {
  return storage == TexelStorage::Float ? GL_RGBA32F : storage == TexelStorage::Half ? GL_RGBA16F : GL_RGB9_E5;
}

gl::Texture makeCube(const CubeTexels& texels, std::string label, bool array) {
  gl::TextureSpec spec;
  spec.target = array ? GL_TEXTURE_CUBE_MAP_ARRAY : GL_TEXTURE_CUBE_MAP;
  spec.format = formatOf(texels.storage);
  spec.width = spec.height = texels.faceSize;
  spec.depth = texels.layers;
  spec.levels = texels.levels;
  spec.label = std::move(label);
  gl::Texture texture = gl::Texture::create(spec);
  // Lookups name a whole level themselves.
  texture.setFilter(texels.levels > 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR, GL_LINEAR);
  texture.setWrap(GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

/// Uploads a baked environment piece by piece.
class EnvironmentUpload {
 public:
  explicit EnvironmentUpload(std::shared_ptr<const BakedEnvironment> baked)
      : m_baked(std::move(baked)), m_map(std::make_shared<EnvironmentMap>()) {
    m_map->m_scale = m_baked->scale;
    m_map->m_figures = m_baked->figures;
    m_map->m_harmonics = harmonicsOfIrradiance(m_baked->irradiance);
    m_map->m_sharp = makeCube(m_baked->sharp, "environment, sharp", false);
    m_map->m_prefiltered = makeCube(m_baked->prefiltered, "environment, prefiltered", true);
    m_map->m_irradiance = makeCube(m_baked->irradiance, "environment, irradiance", false);
    m_parts = {Part{&m_baked->prefiltered, &m_map->m_prefiltered}, Part{&m_baked->irradiance, &m_map->m_irradiance},
               Part{&m_baked->sharp, &m_map->m_sharp}};
    for (const Part& part : m_parts) m_total += part.texels->bytes.size();
  }

  /// Uploads about `maximumBytes` more; true when complete.
  bool step(std::size_t maximumBytes) {
    std::size_t sent = 0;
    while (m_part < m_parts.size() && sent < maximumBytes) sent += uploadFace();
    m_sent += sent;
    return m_part == m_parts.size();
  }
  [[nodiscard]] double fraction() const { return static_cast<double>(m_sent) / static_cast<double>(m_total); }
  [[nodiscard]] std::shared_ptr<const EnvironmentMap> map() const { return m_map; }
  [[nodiscard]] const Warnings& warnings() const { return m_baked->warnings; }

 private:
  struct Part {
    const CubeTexels* texels;
    gl::Texture* texture;
  };

  std::size_t uploadFace() {
    const CubeTexels& texels = *m_parts[m_part].texels;
    const auto n = static_cast<std::size_t>(texels.size(m_level));
    const std::size_t faceBytes = n * n * bytesPerTexel(texels.storage);
    const GLenum format = texels.storage == TexelStorage::SharedExponent ? GL_RGB : GL_RGBA;
    const GLenum type = texels.storage == TexelStorage::Float  ? GL_FLOAT
                        : texels.storage == TexelStorage::Half ? GL_HALF_FLOAT
                                                               : GL_UNSIGNED_INT_5_9_9_9_REV;
    m_parts[m_part].texture->uploadLayer(m_level, m_face, format, type, texels.bytes.data() + m_offset);
    m_offset += faceBytes;
    if (++m_face == 6 * texels.layers) {
      m_face = 0;
      if (++m_level == texels.levels) {
        m_level = 0;
        m_offset = 0;
        ++m_part;
      }
    }
    return faceBytes;
  }

  std::shared_ptr<const BakedEnvironment> m_baked;
  std::shared_ptr<EnvironmentMap> m_map;
  std::array<Part, 3> m_parts{};
  std::size_t m_part = 0, m_offset = 0, m_sent = 0, m_total = 0;
  int m_level = 0, m_face = 0;
};

namespace {

/// Waits for the workers without holding the GL thread, then uploads in slices.
class EnvironmentJob final : public gl::Job {
 public:
  EnvironmentJob(std::shared_ptr<const EnvironmentImages> images, EnvironmentBakeOptions options,
                 EnvironmentReady ready)
      : m_text("Preparing " + (images->name.empty() ? std::string("the environment") : images->name)),
        m_ready(std::move(ready)),
        m_baked(std::async(std::launch::async, [this, images = std::move(images), options = std::move(options)] {
          giveWay();
          return bakeEnvironment(*images, options, m_stop.get_token(), &m_progress);
        })) {}
  ~EnvironmentJob() override {
    m_stop.request_stop();
    if (m_baked.valid()) m_baked.wait();
  }
  EnvironmentJob(const EnvironmentJob&) = delete;
  EnvironmentJob& operator=(const EnvironmentJob&) = delete;

  Result<bool> step() override {
    if (!m_upload) {
      // A short wait, so that running the job to its end doesn't spin.
      if (m_baked.wait_for(std::chrono::milliseconds(4)) != std::future_status::ready) return false;
      auto baked = m_baked.get();
      if (!baked) return tl::unexpected(baked.error());
      m_upload.emplace(std::move(*baked));
      return false;
    }
    constexpr std::size_t kSliceBytes = std::size_t{6} << 20U;
    if (!m_upload->step(kSliceBytes)) return false;
    m_ready(m_upload->map(), m_upload->warnings());
    return true;
  }
  std::string text() const override { return m_text; }
  double fraction() const override { return m_upload ? 0.9 + 0.1 * m_upload->fraction() : 0.9 * m_progress.load(); }

 private:
  std::string m_text;
  EnvironmentReady m_ready;
  std::stop_source m_stop;
  BakeProgress m_progress = 0.0F;
  std::optional<EnvironmentUpload> m_upload;
  std::future<Result<std::shared_ptr<const BakedEnvironment>>> m_baked;
};

}  // namespace

void EnvironmentMap::bind() const {
  m_prefiltered.bind(kPrefilteredUnit);
  m_irradiance.bind(kIrradianceUnit);
  m_sharp.bind(kSharpUnit);
}

std::size_t EnvironmentMap::bytes() const { return m_prefiltered.bytes() + m_irradiance.bytes() + m_sharp.bytes(); }

glm::mat4 environmentFromWorld(float rotationDegrees) {
  return glm::rotate(glm::mat4(1.0F), glm::radians(-rotationDegrees), glm::vec3(0.0F, 1.0F, 0.0F));
}

std::unique_ptr<gl::Job> makeEnvironmentJob(std::shared_ptr<const EnvironmentImages> images,
                                            EnvironmentBakeOptions options, EnvironmentReady ready) {
  return std::make_unique<EnvironmentJob>(std::move(images), std::move(options), std::move(ready));
}

Result<std::shared_ptr<const EnvironmentMap>> makeEnvironmentMap(const std::shared_ptr<const EnvironmentImages>& images,
                                                                 const EnvironmentBakeOptions& options,
                                                                 Warnings& warnings) {
  auto baked = bakeEnvironment(*images, options);
  if (!baked) return tl::unexpected(baked.error());
  warnings.insert(warnings.end(), (*baked)->warnings.begin(), (*baked)->warnings.end());
  EnvironmentUpload upload(std::move(*baked));
  while (!upload.step(SIZE_MAX)) {
  }
  return upload.map();
}

}  // namespace dermis
