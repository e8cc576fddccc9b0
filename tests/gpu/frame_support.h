// Scenes and a renderer for tests of the frame.
#pragma once

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

#include "core/scene/resolved_scene.h"
#include "gpu/gl_fixture.h"
#include "renderer.h"

namespace dermis::test {

/// A scene of `model` whose slots all wear `material`, in a constant world, without lights, seen along −Z by an
/// orthographic camera that shows −1..1.
[[nodiscard]] ResolvedScene sceneOf(Model model, const Material& material,
                                    const glm::vec3& environment = glm::vec3(1.0F));
[[nodiscard]] std::shared_ptr<const EnvironmentImages> constantWorld(const glm::vec3& radiance);

/// A model like `model`, of no vertices and triangles yet.
[[nodiscard]] Model emptied(Model model);
/// −1..1 in x and y at z = 0 like makePlane(), of n × n squares.
[[nodiscard]] Model planeOf(int n);

/// Shows its emission and nothing else: black under any light but for the reflection of the environment.
[[nodiscard]] Material emissive(const glm::vec3& radiance);
[[nodiscard]] Light pointLight(const glm::vec3& position, float intensity);
[[nodiscard]] Material materialOf(ShadingModel model);

/// An image of one pixel type from values 0..1 (or any, for floats), row by row from the top.
[[nodiscard]] std::shared_ptr<const Image> imageOf(int width, int height, int channels, PixelType type,
                                                   const std::vector<float>& values);
/// Puts a map into a slot of every material of the scene.
void setMap(ResolvedScene& scene, TextureSlot slot, std::shared_ptr<const Image> image,
            const TextureBinding& binding = {});

/// A float image's pixel, up to four channels.
[[nodiscard]] glm::vec4 pixel(const Image& image, int x, int y);
/// Largest difference of any value of two images of one size and type Float.
[[nodiscard]] float largestDifference(const Image& a, const Image& b);

/// A texture to draw into, in place of a window.
struct Window {
  explicit Window(glm::ivec2 size);
  [[nodiscard]] std::vector<std::uint8_t> read() const;  ///< RGBA, first row lowest
  gl::Texture texture;
  gl::Framebuffer framebuffer;
};

class FrameTest : public GlTest {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// A renderer of this test's own.
  void makeRenderer(RendererOptions options = {});
  /// Sets the scene and completes all jobs.
  void show(const ResolvedScene& scene);
  /// All samples of a still picture; returns the beauty.
  Image still(const ResolvedScene& scene, int samples = 1);
  /// What a window shows of a moving frame, RGBA, first row lowest; by a renderer of its own for that kind of driver.
  std::vector<std::uint8_t> movingPicture(const ResolvedScene& scene, bool software);
  [[nodiscard]] FrameRequest request(const ResolvedScene& scene, int samples = 1) const;

  glm::ivec2 m_size{48, 48};
  std::unique_ptr<Renderer> m_renderer;
};

MATCHER_P2(IsColour, expected, tolerance, "") {
  for (int c = 0; c < 3; ++c)
    if (std::abs(arg[c] - expected[c]) > tolerance) return false;
  return true;
}

}  // namespace dermis::test
