// The frame: read frame.cpp from top to bottom; frame_read_back.cpp reads what it left.
#pragma once

#include <optional>
#include <vector>

#include "gl/fence.h"
#include "gl/gl_objects.h"
#include "gl/gpu_timer.h"
#include "gl/shader_library.h"
#include "passes/display_pass.h"
#include "passes/frame_context.h"
#include "passes/render_targets.h"
#include "passes/scene_resources.h"
#include "passes/shadow_pass.h"
#include "passes/vertex_light.h"
#include "renderer.h"

namespace dermis {

class Frame {
 public:
  /// `crops`: keeps images of no more of a still picture than the model fills. Only for pictures that are read back.
  Frame(gl::ShaderLibrary& shaders, MessageLog& messages, bool software, bool crops);

  /// One frame, or one more sample of a still picture. `revision` changes with whatever changes the picture but camera,
  /// size and time. False where nothing can be drawn.
  bool draw(const FrameRequest& request, SceneResources& resources, std::uint64_t revision,
            RenderStatistics& statistics);

  /// The first half of what draw() would do: everything up to the shaded surface. draw() then does the rest, or all of
  /// it where it is asked for something else in between. False where there is nothing to draw, or where light is
  /// pending.
  bool begin(const FrameRequest& request, SceneResources& resources, std::uint64_t revision,
             RenderStatistics& statistics);
  /// Whether the driver has drawn what begin() asked for.
  [[nodiscard]] bool beginningIsDrawn() const { return m_begunFence.isPassed(); }

  void restart() {
    m_samples = m_summed = 0;
    m_isBegun = false;
  }
  [[nodiscard]] bool lightIsPending() const { return m_lightIsPending; }
  [[nodiscard]] bool accumulating() const { return m_samples < m_targetSamples; }
  void keep(SceneImages images) { m_kept = images | kBeautyOnly; }

  [[nodiscard]] Image readAov(Aov aov) const;
  [[nodiscard]] Image readView(Aov aov, const ResolvedScene* scene, const ViewSettings& view, PixelType type);
  [[nodiscard]] std::optional<glm::vec3> pickPosition(glm::ivec2 pixel) const;
  [[nodiscard]] std::optional<PixelReadout> readPixel(glm::ivec2 pixel, const ViewSettings& view);
  [[nodiscard]] std::vector<PassTime> passTimes();
  void timePassesAlone() { m_timer.timeAlone(); }
  [[nodiscard]] std::uint64_t displayProgramsBuilt() const { return m_display.built(); }

 private:
  /// What a still picture depends on: when any of it changes, its samples start again.
  struct StillKey {
    glm::ivec2 size{0};
    Camera camera;
    SceneImages images = 0;
    bool precise = false;
    double seconds = 0.0;
    bool withoutSubsurface = false;
    ReferenceObjects references;
    std::uint64_t revision = 0;
    bool operator==(const StillKey&) const = default;
  };

  /// What the images of a moving surface and the sky round it depend on: where none of it has changed since the last
  /// frame, because a material is being edited, they are kept.
  struct SurfaceKey {
    glm::ivec2 size{0};
    Camera camera;
    SceneImages images = 0;
    bool precise = false;
    std::uint64_t geometry = 0, light = 0, environment = 0;
    float rotationDegrees = 0.0F, exposureStops = 0.0F;
    Background background;
    int level = 0;
    std::vector<std::pair<DrawKind, bool>> slots;  ///< kind, whether back faces are culled
    bool operator==(const SurfaceKey&) const = default;
  };

  /// Targets, samples and camera of a frame; nothing where nothing can be drawn.
  [[nodiscard]] std::optional<FrameContext> prepare(const FrameRequest& request, SceneResources& resources,
                                                    std::uint64_t revision);
  [[nodiscard]] bool drawsSample(const FrameRequest& request) const { return request.moving || accumulating(); }
  /// The first half of a frame: what doesn't move with the camera, then the surface. False while light is pending.
  bool drawSurface(const FrameContext& frame, RenderStatistics& statistics);
  /// The second half: diffusion, and what stands behind and before the surface.
  void drawAround(const FrameContext& frame);
  /// Puts what was drawn of a picture into its place, and the sky around it.
  void completePicture(const FrameContext& frame);
  /// The level of the model's triangles that a frame is drawn with.
  [[nodiscard]] int levelFor(const FrameRequest& request, SceneResources& resources, const CameraMatrices& camera);
  FrameBlock uploadFrameBlock(const FrameContext& frame, RenderStatistics& statistics);
  void clear(const FrameContext& frame) const;
  /// Null where the surface's images have to be drawn each time.
  [[nodiscard]] std::optional<SurfaceKey> surfaceKey(const FrameContext& frame) const;
  void show(const FrameContext& frame, bool fromSums);
  /// Adds the images to the sums. False, with a message, where there is no memory for them.
  bool accumulate(const FrameContext& frame);
  /// m_samples of a still picture together; nothing where they aren't kept.
  [[nodiscard]] const gl::Texture& samplesOf(SceneImage image) const {
    return m_summed == m_samples ? m_targets.sum(image) : m_targets.whole(image);
  }

  gl::ShaderLibrary& m_shaders;
  MessageLog& m_messages;
  bool m_software, m_crops;
  RenderTargets m_targets;
  ShadowPass m_shadows;
  VertexLight m_vertexLight;
  DisplayPass m_display;
  gl::GpuTimer m_timer;
  gl::VertexArray m_noVertices;
  gl::Buffer m_frameBlockBuffer, m_sampleBlockBuffer, m_wholeBlockBuffer;
  std::vector<std::byte> m_frameBlockBytes;
  StillKey m_stillKey;
  bool m_isBegun = false;  ///< the surface of what m_stillKey asks for is drawn
  bool m_begunMoving = false;
  gl::Fence m_begunFence;
  std::optional<SurfaceKey> m_surfaceKey;  ///< of what the images of a moving surface hold
  SceneImages m_kept = kBeautyOnly;
  int m_samples = 0;  ///< of a still picture
  int m_summed = 0;   ///< of these, in the sums: all of them, or the only one still is the images
  int m_targetSamples = 1;
  std::vector<PixelArea> m_drawnOver;  ///< of a surface that is kept: where transparent parts stood over it
  bool m_surfacesAreKept = false;      ///< in the frame being drawn
  bool m_lightIsPending = false;
  CameraMatrices m_lastCamera;
  bool m_lastMultisampled = false;
  bool m_wasReduced = false;  ///< some frame before was drawn smaller than it was shown
  bool m_showsSums = false;   ///< what is shown is the mean of m_samples
};

}  // namespace dermis
