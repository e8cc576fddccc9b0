// The lights' depth maps: drawn when the light, the model or what is seen of it has moved out of what they cover.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "lighting/light_point.h"
#include "lighting/shadow_map.h"
#include "passes/frame_context.h"

namespace dermis {

inline constexpr unsigned kShadowBinding = 3;
inline constexpr std::size_t kMaxShadowViews = 7 * kMaxLights;  // one a light, then those of cubes

/// The C++ twin of ShadowBlock in shadows.glsl (std140).
struct ShadowBlock {
  glm::vec4 centre{0.0F};
  glm::vec4 filter{0.0F};
  std::array<glm::ivec4, kMaxLights> of{};
  std::array<ShadowViewBlock, kMaxShadowViews> views{};
};
static_assert(sizeof(ShadowBlock) == 32 + 16 * kMaxLights + 128 * kMaxShadowViews);

/// Which picture the maps are for.
struct ShadowSample {
  int index = 0;          ///< of the accumulated sample
  int count = 1;          ///< samples asked for; with one, area lights shine from their centres
  bool moving = false;    ///< maps are kept as long as they cover what is seen
  bool thorough = false;  ///< every sample draws every map anew; otherwise as many as there is time for, in turn
};

/// What draws a part into a map that isn't displaced.
[[nodiscard]] gl::ProgramSources casterProgram(bool hasCutOuts);

class ShadowPass {
 public:
  explicit ShadowPass(bool software);

  /// Chooses where each light shines from and draws the maps that are out of date. Leaves framebuffer, viewport and
  /// program changed, depth reversed as the frame has it.
  void draw(const FrameContext& frame, const ShadowSample& sample, RenderStatistics& statistics);
  /// The enabled lights, in order, as packLights counts them.
  [[nodiscard]] std::span<const LightPoint> points() const { return m_points; }
  /// Grows whenever a map is drawn or read otherwise.
  [[nodiscard]] std::uint64_t revision() const { return m_revision; }
  /// The block and the maps, on their binding and unit.
  void bind() const;

 private:
  struct Face {
    ShadowAxes axes;
    ShadowWindow window;
    ShadowView view;
    int layer = -1;
    bool drawn = false;
  };
  /// What decides which triangles hold light back, beside the model: what a part is and where its material is cut out.
  struct Caster {
    DrawKind kind = DrawKind::Opaque;
    bool hasCutOuts = false;
    std::vector<std::byte> material;
    const gl::Texture* albedo = nullptr;
    const gl::Texture* heights = nullptr;  ///< of a displaced one
    bool operator==(const Caster&) const = default;
  };

  void readGeometry(const FrameContext& frame);
  /// The point of light `index` in this sample, and whether its maps must be drawn from there.
  [[nodiscard]] LightPoint pointNow(const FrameContext& frame, const Light& light, std::size_t index,
                                    const ShadowSample& sample);
  void fit(const FrameContext& frame, const ShadowSample& sample, std::size_t light);
  void makeMaps(const FrameContext& frame, const ShadowSample& sample);
  void drawFace(const FrameContext& frame, Face& face, glm::vec2 shift, RenderStatistics& statistics);
  void upload(const ShadowSample& sample, float below);

  bool m_software;
  std::shared_ptr<const Model> m_model;  ///< the one m_geometry is of
  ShadowGeometry m_geometry;
  std::vector<Caster> m_casters;

  std::vector<LightPoint> m_points;
  std::vector<std::vector<Face>> m_faces;  ///< by light
  std::vector<bool> m_fresh;               ///< by light: draw it anew in this sample
  std::vector<int> m_taken;                ///< by light: points taken since the picture began
  std::uint64_t m_revision = 0;
  std::size_t m_turn = 0;  ///< the light that is next to be drawn anew

  gl::Texture m_maps;
  gl::Framebuffer m_framebuffer;
  gl::Buffer m_blockBuffer;
  std::vector<std::byte> m_blockBytes;
};

}  // namespace dermis
