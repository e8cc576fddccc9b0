// The images a frame is drawn into, made again when size or use changes.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "core/base/result.h"
#include "gl/gl_objects.h"
#include "passes/camera_matrices.h"
#include "renderer.h"

namespace dermis {

/// The images of a frame. surface.frag writes the first eight, by location; the subsurface pass the last two.
///   Beauty        the picture; until the subsurface pass only what doesn't go through the body
///   Entering      light that goes into the body; a the share that diffuses
///   Exit          what leaving multiplies it by; a the energy
///   Geometry      vertex normal on the octahedron, profile id, thickness in mm
///   Specular, Transmission
///   Normal        shading normal, coverage
///   Data          occlusion, depth along the view in scene units, thickness in mm, coverage
///   Diffuse       the body's light as if it left where it entered
///   Scattered     as it leaves after diffusion
enum class SceneImage { Beauty, Entering, Exit, Geometry, Specular, Transmission, Normal, Data, Diffuse, Scattered };
inline constexpr std::size_t kSceneImageCount = 10, kSurfaceImageCount = 8;
/// A set of them, as bits; Beauty is always in it.
using SceneImages = unsigned;
[[nodiscard]] constexpr SceneImages bitOf(SceneImage image) { return 1U << static_cast<unsigned>(image); }
inline constexpr SceneImages kBeautyOnly = bitOf(SceneImage::Beauty);
/// What the subsurface pass works on.
inline constexpr SceneImages kSplit =
    kBeautyOnly | bitOf(SceneImage::Entering) | bitOf(SceneImage::Exit) | bitOf(SceneImage::Geometry);
/// What is blended over.
inline constexpr SceneImages kRadiances = kBeautyOnly | bitOf(SceneImage::Specular) | bitOf(SceneImage::Transmission) |
                                          bitOf(SceneImage::Diffuse) | bitOf(SceneImage::Scattered);
/// Where an AOV is found.
[[nodiscard]] SceneImage sceneImageOf(Aov aov);

class RenderTargets {
 public:
  /// Makes what is needed and isn't there. The images hold the part of a picture of `size` that `window` names; where
  /// it isn't all of it, one more holds the whole beauty. `precise` images are 32-bit float, for exports; else RGBA16F.
  /// `multisampled`: four samples a pixel besides. True where images that had content were replaced. Errors: Runtime.
  [[nodiscard]] Result<bool> prepare(glm::ivec2 size, const PixelArea& window, SceneImages images, bool precise,
                                     bool multisampled);
  /// Makes the sums of these images, zeroed by the first sample written. Errors: Runtime.
  [[nodiscard]] Result<void> prepareSums(SceneImages images);

  /// Makes what the first of two diffusion passes writes. Errors: Runtime.
  [[nodiscard]] Result<void> prepareSpread();
  /// Makes what geometryPass draws into. Errors: Runtime.
  [[nodiscard]] Result<void> prepareSurfaces(bool moving);
  /// Gives back what the last two made: a picture that has all its samples shows none of it.
  void releaseWork();

  /// The picture's.
  [[nodiscard]] glm::ivec2 size() const { return m_size; }
  /// What the images hold of it (OpenEXR's data window).
  [[nodiscard]] const PixelArea& dataWindow() const { return m_window; }
  [[nodiscard]] bool isCropped() const { return m_window.extent() != m_size; }
  [[nodiscard]] SceneImages images() const { return m_images; }
  [[nodiscard]] bool has(SceneImage image) const { return (m_images & bitOf(image)) != 0; }
  [[nodiscard]] bool split() const { return (m_images & kSplit) == kSplit; }
  [[nodiscard]] bool precise() const { return m_precise; }

  [[nodiscard]] const gl::Framebuffer& scene() const { return m_scene; }
  [[nodiscard]] const gl::Framebuffer& multisampled() const { return m_multisampled; }
  /// With the scene's depth.
  [[nodiscard]] const gl::Framebuffer& surfaces(bool moving) const {
    return (moving ? m_movingSurfaces : m_stillSurfaces).framebuffer;
  }
  /// What the subsurface pass makes of what the surface pass wrote (beauty, diffuse, scattered by location), with the
  /// depth that both its test and its shaders read and nothing writes.
  [[nodiscard]] const gl::Framebuffer& composed() const { return m_composed; }
  [[nodiscard]] const gl::Framebuffer& spreading() const { return m_spreading; }
  [[nodiscard]] const gl::Texture& spread() const { return m_spread; }
  [[nodiscard]] const gl::Texture& depth() const { return m_depth; }
  /// Coordinates and normal, tangent, depth: on the units that surface.frag reads them from.
  void bindSurfaces(bool moving) const;
  [[nodiscard]] const gl::Texture& image(SceneImage image) const {
    return m_imagesOf.at(static_cast<std::size_t>(image));
  }
  /// The same of the whole picture; where images are cropped there is none but the beauty.
  [[nodiscard]] const gl::Texture& whole(SceneImage image) const {
    return !isCropped() ? this->image(image) : image == SceneImage::Beauty ? m_picture : m_none;
  }
  [[nodiscard]] const gl::Framebuffer& pictureBuffer() const { return m_pictureBuffer; }
  [[nodiscard]] const gl::Texture& sum(SceneImage image) const { return m_sums.at(static_cast<std::size_t>(image)); }
  [[nodiscard]] const gl::Framebuffer& sumBuffer(SceneImage image) const {
    return m_sumBuffers.at(static_cast<std::size_t>(image));
  }
  [[nodiscard]] bool summed(SceneImage image) const { return static_cast<bool>(sum(image)); }
  /// With depth: beauty, diffuse, scattered, specular, transmission by location, as far as they are there.
  [[nodiscard]] const gl::Framebuffer& radiances() const { return m_radiances; }
  /// Eight bits a channel, as a display takes them; made at the first call.
  [[nodiscard]] const gl::Framebuffer& encoded();
  [[nodiscard]] const gl::Texture& encodedImage() const { return m_encoded; }
  /// Draws into all images that the surface pass writes, or into the picture alone.
  void drawToAll() const;
  void drawToBeauty() const;

 private:
  /// With depth.
  [[nodiscard]] gl::Framebuffer framebufferOf(std::span<const SceneImage> images, const char* label) const;

  glm::ivec2 m_size{0};
  PixelArea m_window;
  SceneImages m_images = 0;
  bool m_precise = false;
  bool m_hasMultisampled = false;
  std::array<gl::Texture, kSceneImageCount> m_imagesOf, m_sums;
  std::array<gl::Framebuffer, kSceneImageCount> m_sumBuffers;
  gl::Texture m_depth, m_msColour, m_msDepth;
  gl::Texture m_spread, m_encoded, m_picture, m_none;
  gl::Texture m_surface, m_tangent, m_far;
  struct SurfaceImages {
    gl::Texture sky, bounce, gradients;
    gl::Framebuffer framebuffer;
  };
  SurfaceImages m_movingSurfaces, m_stillSurfaces;
  gl::Framebuffer m_scene, m_multisampled, m_composed, m_radiances, m_spreading, m_encoding, m_pictureBuffer;
};

}  // namespace dermis
