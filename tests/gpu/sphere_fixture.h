// Renders the built-in sphere or plane through the whole Renderer and compares it pixel by pixel with a reference.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/resolved_scene.h"
#include "gpu/gl_fixture.h"
#include "reference/published.h"
#include "reference/sphere_view.h"
#include "renderer.h"

namespace dermis::test {

using reference::dvec3;

/// What a test varies.
struct Look {
  Material material;
  std::vector<Light> lights;
  std::shared_ptr<const EnvironmentImages> environment;
  Camera camera;
  int size = 96;
  bool plane = false;
  int samples = 1;  ///< one is at the pixels' centres, more are spread over them
};

/// The picture's linear values, top row first.
struct Picture {
  int size = 0;
  std::vector<glm::vec4> pixels;
  [[nodiscard]] glm::dvec4 at(int x, int y) const {
    return glm::dvec4(
        pixels.at(static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)));
  }
};

[[nodiscard]] std::shared_ptr<const EnvironmentImages> constantEnvironment(const glm::vec3& radiance);
/// Radiance base + x·d.x + y·d.y + z·d.z as a lat-long image: reference::linearSurroundings for the renderer.
[[nodiscard]] std::shared_ptr<const EnvironmentImages> linearEnvironment(const glm::vec3& base, const glm::vec3& x,
                                                                         const glm::vec3& y, const glm::vec3& z);

/// The same of any function of the direction.
[[nodiscard]] std::shared_ptr<const EnvironmentImages> environmentOf(
    const std::function<glm::vec3(const dvec3& direction)>& radiance);

[[nodiscard]] Camera perspectiveCamera();
[[nodiscard]] Camera orthographicCamera();

class SphereTest : public GlTest {
 protected:
  [[nodiscard]] static Picture render(const Look& look, Aov aov = Aov::Beauty);

  /// Every pixel whose n·v is above `leastCosine` against reference(n, v): at most `relative` off, per channel, give or
  /// take `absolute`.
  static void expectSphere(const Look& look, const std::function<dvec3(const dvec3& n, const dvec3& v)>& reference,
                           const std::string& what, double relative = 0.005, double leastCosine = 0.2,
                           double absolute = 1e-4);
};

}  // namespace dermis::test
