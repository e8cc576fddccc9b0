// The picture on a display: exposure, view transform, dither.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "colour/display_transform.h"
#include "colour/false_colour.h"
#include "gl/gl_objects.h"
#include "gl/shader_library.h"
#include "passes/frame_context.h"

namespace dermis {

/// What is shown, and how.
struct DisplayInput {
  const gl::Texture* image = nullptr;   ///< premultiplied scene-linear radiance, a sum of samples
  float weight = 1.0F;                  ///< 1 / samples
  bool exact = false;                   ///< the view's own program rather than the baked LUT
  std::optional<PixelArea> edgeFilter;  ///< where stair steps are smoothed, pixels of the image
  bool straightAlpha = false;           ///< unassociated, for files; else premultiplied, for windows
  bool dither = false;                  ///< for 8-bit targets
  std::optional<PixelArea> shown;       ///< of the target; nothing else of it is touched
};

/// Keeps the views in use ready: their programs' text and textures.
class DisplayPass {
 public:
  /// Draws into the framebuffer that is bound, a pixel a texel of the image. Raw is drawn as it is: no exposure, no
  /// dither. False (and a message) where the view can't be made.
  bool draw(gl::ShaderLibrary& shaders, MessageLog& messages, const ViewSettings& view, const DisplayInput& input);

  /// Shows an image that is not radiance in the framebuffer that is bound. `range` is valueRange(aov, …).
  static void drawData(gl::ShaderLibrary& shaders, MessageLog& messages, Aov aov,
                       const std::optional<ValueRange>& range, const gl::Texture& image, float weight, glm::ivec2 size,
                       const PixelArea& shown);

  /// Shows a picture that draw() has encoded, bilinearly, in the framebuffer that is bound, of `size` pixels.
  static void enlarge(gl::ShaderLibrary& shaders, MessageLog& messages, const gl::Texture& encoded, glm::ivec2 size,
                      const PixelArea& shown);

  /// What draw() would show of one premultiplied scene value, 0..1 and unassociated, by the view's own program.
  [[nodiscard]] glm::vec3 encoded(const glm::vec4& scene, const ViewSettings& view, MessageLog& messages);

  [[nodiscard]] std::uint64_t built() const { return m_built; }

 private:
  struct View {
    std::shared_ptr<const DisplayTransform> transform;
    gl::Texture lut;
    std::vector<gl::Texture> textures;  ///< of the exact program
    bool exactReady = false;
  };
  bool drawAreas(gl::ShaderLibrary& shaders, MessageLog& messages, View& view, const ViewSettings& settings,
                 const DisplayInput& input, bool edgeFilter, std::span<const PixelArea> areas);
  View* viewFor(const ViewSettings& settings, MessageLog& messages);
  static void prepareExact(View& view);
  static void prepareLut(View& view);

  std::map<std::pair<std::string, std::string>, View> m_views;  ///< by display and view as asked for
  std::uint64_t m_built = 0;
};

}  // namespace dermis
