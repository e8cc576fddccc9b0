// The library's face: a Renderer draws a ResolvedScene with the GL context that is current.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/scene/resolved_scene.h"

namespace dermis {

/// Images of the frame that can be looked at or saved by name. Aov::Beauty is the picture.
/// Diffuse is the body's light as if it left where it entered, DiffuseScattered as it leaves after diffusion; Thickness
/// is in mm; Energy is the share of a uniform white environment that a pixel returns.
enum class Aov {
  Beauty,
  Diffuse,
  DiffuseScattered,
  Specular,
  Transmission,
  Thickness,
  Normal,
  Occlusion,
  ProfileId,
  Energy,
  Depth
};
[[nodiscard]] std::string_view toString(Aov aov);  ///< "beauty", "diffuse", …, "profile_id"
[[nodiscard]] std::vector<Aov> allAovs();

/// What the GL context is.
struct GlInfo {
  std::string vendor, renderer, version, platform;  ///< platform: "EGL surfaceless", "EGL device", "widget"
  bool software = false;                            ///< llvmpipe, softpipe, swrast
};
/// Of the calling thread's current context.
[[nodiscard]] GlInfo currentGlInfo(const std::string& platform);

struct RendererOptions {
  std::filesystem::path cacheFolder;  ///< for baked environments and models; empty: no disk cache
  bool bakeMeshes = false;            ///< thickness and hidden sky of models, as a job, where a material uses them
  bool failOnGlError = false;         ///< tests: any GL error or high-severity debug message is recorded as a failure
  std::string platform = "widget";
  int maximumTextureSize = 0;    ///< larger maps are averaged down, with a message; 0: what the driver takes
  std::optional<bool> software;  ///< tests: overrides what the driver's name says, and with it how edges are smoothed
  bool timePassesAlone = false;  ///< benchmarks: each pass is waited for, and its CPU time is that of all threads
};

/// Things of known reflectance in the lower left of the picture, lit as if they stood in the middle of the model: to
/// judge light and exposure by. Drawn over the picture, nothing shadows them.
struct ReferenceObjects {
  bool balls = false;  ///< a grey one (albedo 0.18) and a chrome one
  bool chart = false;  ///< the 24 patches of a colour chart, facing the camera
  bool operator==(const ReferenceObjects&) const = default;
};

/// One frame to draw.
struct FrameRequest {
  glm::ivec2 size{1280, 720};
  Camera camera;
  ViewSettings view;      ///< transform, display, exposure; "Raw" writes scene-linear values
  Aov aov = Aov::Beauty;  ///< what is displayed
  bool moving = false;    ///< something is being dragged: one cheap anti-aliased frame, no accumulation
  int targetSamples = 64;
  bool withoutSubsurface = false;  ///< light leaves where it entered, to see what diffusion does
  bool exactDisplay = false;       ///< exports: OCIO's exact program rather than the baked LUT
  bool eightBits = false;          ///< of which only eight bits a channel are wanted: half floats hold its radiance
  double seconds = 0.0;            ///< time for the lights' animation
  unsigned framebuffer = 0;        ///< GL framebuffer to put the displayed picture in; 0 without a window: none
  glm::ivec2 displaySize{0};       ///< of that framebuffer, where the picture is drawn smaller and enlarged; 0: size
  glm::ivec2 displayColumns{0};    ///< from, up to: the framebuffer's columns that are drawn; 0, 0: all of them
  unsigned verticesAtOnce = 0;     ///< whose light is computed in one call at most (see lightIsPending); 0: all
  ReferenceObjects references;
};

/// Counters of what was really done, for tests and the statistics line; cumulative since create().
struct RenderStatistics {
  std::uint64_t frames = 0, programsCompiled = 0, texturesUploaded = 0, geometryUploads = 0, environmentsBaked = 0,
                environmentsFromCache = 0, meshesBaked = 0, uniformBlocksUploaded = 0, displayProgramsBuilt = 0,
                glErrors = 0;
  std::uint64_t texturesReleased = 0, shadowMapsDrawn = 0, diffusionKernelsMade = 0;
  std::uint64_t surfacesKept = 0;  ///< moving frames that shaded what the one before had rasterised
  std::uint64_t coarseFrames = 0;  ///< moving frames of fewer triangles than the model has
  std::size_t residentTextures = 0, triangles = 0;
  int samples = 0, targetSamples = 0;  ///< of the picture shown last
  glm::ivec2 pictureSize{0};           ///< pixels that the picture shown last was drawn with
};

/// What one pixel of the picture holds.
struct PixelReadout {
  glm::vec4 radiance{0.0F};          ///< scene-linear Rec.709, premultiplied, mean of the samples so far
  glm::vec3 display{0.0F};           ///< the same as encoded by the view, 0..1
  std::optional<float> thicknessMm;  ///< where the shading model uses one
};

/// GPU and CPU milliseconds of one pass of the last frame; CPU is the time to submit it unless passes are timed alone.
struct PassTime {
  std::string name;
  double gpuMs = 0.0, cpuMs = 0.0;
};

class Renderer {
 public:
  /// Needs a current GL context. Errors: Runtime, where it isn't GL 4.5 core or better.
  [[nodiscard]] static Result<std::unique_ptr<Renderer>> create(const RendererOptions& options);
  virtual ~Renderer() = default;

  /// What to draw from now on. Cheap: compares with what is resident; uploads happen in the next frame or as jobs.
  virtual void setScene(std::shared_ptr<const ResolvedScene> scene) = 0;

  /// Draws one frame (or adds one sample to it) into request.framebuffer. Returns false where the scene isn't drawable,
  /// and where light is pending.
  virtual bool renderFrame(const FrameRequest& request) = 0;
  /// Draws the first half of that frame, up to the shaded surface. renderFrame() with the same request then draws the
  /// rest, and with another, or another scene, all of its own. A host whose driver computes on the CPU answers somebody
  /// in between. False where there is nothing to draw, and where light is pending.
  virtual bool beginFrame(const FrameRequest& request) = 0;
  /// Whether the driver has drawn that half: what is left will not wait for it.
  [[nodiscard]] virtual bool beginningIsDrawn() const = 0;
  /// The last call has computed light for request.verticesAtOnce, more of them want it, and nothing was drawn: ask for
  /// the same frame again. A light that changes before all have it is computed for all at once, so that a hand that
  /// keeps turning it sees pictures.
  [[nodiscard]] virtual bool lightIsPending() const = 0;
  /// True while renderFrame would add to the picture: fewer samples than asked for.
  [[nodiscard]] virtual bool accumulating() const = 0;
  /// Forgets accumulated samples.
  virtual void restartAccumulation() = 0;

  /// Runs queued GPU jobs (environment bakes, program warm-up) for about `budgetMs`, at least one slice; true while
  /// some are left. The last complete environment stays in use until the next one is complete.
  virtual bool runJobs(double budgetMs) = 0;
  [[nodiscard]] virtual bool jobsAreQueued() const = 0;
  /// Whether programs and environment are there: jobs that are left only make the picture better.
  [[nodiscard]] virtual bool drawable() const = 0;
  /// 0..1 of the job in progress and what it is; empty text when idle.
  [[nodiscard]] virtual std::pair<std::string, double> jobProgress() const = 0;
  /// Drops queued jobs: the last complete environment stays.
  virtual void cancelJobs() = 0;
  /// Completes all jobs now (command line, tests). Errors: Runtime, a shader that doesn't compile.
  [[nodiscard]] virtual Result<void> finishJobs() = 0;

  /// The accumulated image, linear Rec.709, Float: RGBA premultiplied for Beauty, RGB or one channel for the others.
  [[nodiscard]] virtual Image readAov(Aov aov) = 0;
  /// AOVs kept while accumulating (Beauty always is). Changing the set restarts accumulation.
  virtual void keepAovs(const std::vector<Aov>& aovs) = 0;
  /// The accumulated beauty through the request's view, U8 or U16 RGBA, alpha unassociated, top row first.
  [[nodiscard]] virtual Image readDisplay(const ViewSettings& view, PixelType type) = 0;
  /// The same for any image that is kept, as the window shows it: radiance through the view, numbers as false colours
  /// (valueRange in colour/false_colour.h says what they stand for).
  [[nodiscard]] virtual Image readView(Aov aov, const ViewSettings& view, PixelType type) = 0;

  /// World position under a pixel (counted from the top left) of the last frame; nothing where there is only sky.
  [[nodiscard]] virtual std::optional<glm::vec3> pickPosition(glm::ivec2 pixel) = 0;

  /// What a pixel (counted from the top left) of the last frame holds; nothing outside it, and nothing while another
  /// picture is half drawn.
  [[nodiscard]] virtual std::optional<PixelReadout> readPixel(glm::ivec2 pixel, const ViewSettings& view) = 0;

  [[nodiscard]] virtual const GlInfo& glInfo() const = 0;
  [[nodiscard]] virtual RenderStatistics statistics() const = 0;
  [[nodiscard]] virtual std::vector<PassTime> passTimes() const = 0;
  /// Messages since the last call: shader errors with file:line, textures reduced, GL debug messages.
  [[nodiscard]] virtual Warnings takeMessages() = 0;
  /// Where DERMIS_SHADER_DIR is set: recompiles what changed on disk; keeps the last good program.
  virtual void reloadChangedShaders() = 0;
};

/// The views the display offers: those of the active OCIO config and the seeds' own ("Raw", "Thesis", "Gamma 2.2").
struct DisplayViews {
  std::vector<std::string> displays, views;
  std::string defaultDisplay, defaultView;
};
/// Errors: Input, a broken $OCIO.
[[nodiscard]] Result<DisplayViews> displayViews();

}  // namespace dermis
