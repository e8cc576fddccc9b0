// The images a frame is drawn into, made again when size or use changes.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/base/result.h"
#include "gl/gl_objects.h"
#include "renderer.h"

namespace dermis {

/// What surface.frag writes, by location.
enum class SceneImage { Beauty, Diffuse, Specular, Normal, Data, ProfileId };
inline constexpr std::size_t kSceneImageCount = 6;
/// A set of them, as bits; Beauty is always in it.
using SceneImages = unsigned;
[[nodiscard]] constexpr SceneImages bitOf(SceneImage image) { return 1U << static_cast<unsigned>(image); }
inline constexpr SceneImages kBeautyOnly = bitOf(SceneImage::Beauty);
/// Where an AOV is found.
[[nodiscard]] SceneImage sceneImageOf(Aov aov);

class RenderTargets {
 public:
  /// Makes what is needed and isn't there. `precise` images are 32-bit float, for exports; else RGBA16F.
  /// `multisampled`: four samples a pixel besides. True where images that had content were replaced. Errors: Runtime.
  [[nodiscard]] Result<bool> prepare(glm::ivec2 size, SceneImages images, bool precise, bool multisampled);
  /// Makes the sums, zeroed by the first sample written. Errors: Runtime.
  [[nodiscard]] Result<void> prepareSums();

  /// Makes what surfacePassDeferred draws into first. Errors: Runtime.
  [[nodiscard]] Result<void> prepareSurfaces();

  [[nodiscard]] glm::ivec2 size() const { return m_size; }
  [[nodiscard]] SceneImages images() const { return m_images; }
  [[nodiscard]] bool precise() const { return m_precise; }

  [[nodiscard]] const gl::Framebuffer& scene() const { return m_scene; }
  [[nodiscard]] const gl::Framebuffer& multisampled() const { return m_multisampled; }
  [[nodiscard]] const gl::Framebuffer& surfaces() const { return m_surfaces; }        ///< with the scene's depth
  [[nodiscard]] const gl::Framebuffer& beautyAlone() const { return m_beautyAlone; }  ///< without it, to read it
  /// Coordinates and normal, tangent, depth: on the units that surface.frag reads them from.
  void bindSurfaces() const;
  [[nodiscard]] const gl::Texture& image(SceneImage image) const {
    return m_imagesOf.at(static_cast<std::size_t>(image));
  }
  [[nodiscard]] const gl::Texture& sum(SceneImage image) const { return m_sums.at(static_cast<std::size_t>(image)); }
  [[nodiscard]] const gl::Framebuffer& sumBuffer(SceneImage image) const {
    return m_sumBuffers.at(static_cast<std::size_t>(image));
  }
  /// Draws into all images of the frame, or into the radiance ones only (what blends).
  void drawToAll() const;
  void drawToRadiance() const;
  void drawToBeauty() const;

 private:
  glm::ivec2 m_size{0};
  SceneImages m_images = 0;
  bool m_precise = false;
  bool m_hasMultisampled = false;
  std::array<gl::Texture, kSceneImageCount> m_imagesOf, m_sums;
  std::array<gl::Framebuffer, kSceneImageCount> m_sumBuffers;
  gl::Texture m_depth, m_msColour, m_msDepth;
  gl::Texture m_surface, m_tangent;
  gl::Framebuffer m_scene, m_multisampled, m_surfaces, m_beautyAlone;
};

}  // namespace dermis
