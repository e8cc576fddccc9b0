// From scene-linear Rec.709 to a display, through OpenColorIO or one of the curves that always exist.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace dermis {

/// A texture that an exact program needs. Values are 32-bit floats.
struct DisplayTexture {
  std::string samplerName;  ///< as the GLSL text declares it
  int dimensions = 2;       ///< 1, 2 or 3
  int width = 1, height = 1, depth = 1;
  int channels = 3;      ///< 1 or 3
  bool nearest = false;  ///< else linear
  std::vector<float> values;
};

/// GLSL 4.0 text that defines `vec4 displayExact(vec4 scene_linear_rec709)`, and what it samples.
struct DisplayProgram {
  std::string glsl;
  std::vector<DisplayTexture> textures;
};

/// A view baked to a cube of edge³ RGB half floats behind a logarithmic shaper, red fastest: what the interactive
/// picture uses. displayBaked() in lighting-free GLSL is displayBakedGlsl().
struct DisplayLut {
  int edge = 0;
  std::vector<float> rgb;  ///< edge³ · 3
};

/// One view of the active config (or a curve of our own), made ready once.
class DisplayTransform {
 public:
  /// `display` and `view` as in scene files, case-insensitive. Where the active config lacks the view (or display), a
  /// warning says so and the config's default one is taken. "Raw", "Thesis" and "Gamma 2.2" always exist.
  /// Errors: Input, a broken $OCIO or a config that cannot make this view.
  [[nodiscard]] static Result<std::shared_ptr<const DisplayTransform>> create(std::string_view display,
                                                                              std::string_view view,
                                                                              Warnings& warnings);
  virtual ~DisplayTransform() = default;

  [[nodiscard]] virtual const std::string& display() const = 0;  ///< the name that was found
  [[nodiscard]] virtual const std::string& view() const = 0;
  [[nodiscard]] virtual bool isRaw() const = 0;  ///< writes scene-linear values as they are

  /// True where a few arithmetic instructions do it exactly (Raw, sRGB, Thesis, Gamma 2.2): no LUT is worth it then.
  [[nodiscard]] virtual bool isSimple() const = 0;

  /// The exact program.
  [[nodiscard]] virtual const DisplayProgram& exactProgram() const = 0;
  /// The baked one; baked at the first call (about 0.03 s) unless an earlier program left it in the user's cache; empty
  /// where isSimple().
  [[nodiscard]] virtual const DisplayLut& lut() const = 0;
  /// The exact transform on the CPU, in place: `count` RGBA pixels, alpha untouched. Safe from any thread.
  virtual void apply(float* rgba, std::size_t count) const = 0;
};

/// GLSL that defines `vec3 displayBaked(vec3 scene_linear_rec709)` with `uniform sampler3D u_display_lut` on `unit`.
[[nodiscard]] std::string displayBakedGlsl(unsigned unit);

/// How the texels of a map become linear Rec.709.
struct TextureColour {
  enum class Decode {
    Srgb,     ///< upload with an sRGB format
    Linear,   ///< as stored
    Convert,  ///< call convert() on the CPU
  };
  Decode decode = Decode::Linear;
  std::shared_ptr<const void> processor;  ///< for convert
  /// In place, `count` RGBA float pixels to linear Rec.709.
  void convert(float* rgba, std::size_t count) const;
};

/// What a slot's `color_space` asks for: "srgb", "linear", "raw", a colour space or role of the active config
/// (case-insensitive), or empty: sRGB for 8-bit colour maps, else linear. Unknown names: a warning, and as if empty.
/// Errors: Input, a broken $OCIO.
[[nodiscard]] Result<TextureColour> textureColour(std::string_view colorSpace, bool isColourSlot, bool isFloat,
                                                  Warnings& warnings);

}  // namespace dermis
