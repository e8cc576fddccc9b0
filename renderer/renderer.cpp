#include "renderer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "frame.h"
#include "gl/debug_output.h"
#include "gl/job_queue.h"
#include "gl/shader_library.h"
#include "passes/displacement.h"
#include "passes/scene_resources.h"
#include "passes/shadow_pass.h"
#include "passes/subsurface_pass.h"
#include "passes/surface_pass.h"
#include "passes/vertex_light.h"

namespace dermis {

namespace {

constexpr std::array<std::pair<Aov, std::string_view>, 11> kAovs = {{{Aov::Beauty, "beauty"},
                                                                     {Aov::Diffuse, "diffuse"},
                                                                     {Aov::DiffuseScattered, "diffuse_scattered"},
                                                                     {Aov::Specular, "specular"},
                                                                     {Aov::Transmission, "transmission"},
                                                                     {Aov::Thickness, "thickness"},
                                                                     {Aov::Normal, "normal"},
                                                                     {Aov::Occlusion, "occlusion"},
                                                                     {Aov::ProfileId, "profile_id"},
                                                                     {Aov::Energy, "energy"},
                                                                     {Aov::Depth, "depth"}}};

std::string glString(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text != nullptr ? text : "";
}

class GlRenderer final : public Renderer {
 public:
  GlRenderer(const RendererOptions& options, GlInfo info)
      : m_info(std::move(info)),
        m_hasWindow(options.platform == RendererOptions().platform),
        m_debug(options.failOnGlError),
        m_resources(options, m_info.software),
        m_frame(m_shaders, m_messages, m_info.software, !m_hasWindow) {
    if (options.timePassesAlone) m_frame.timePassesAlone();
  }

  void setScene(std::shared_ptr<const ResolvedScene> scene) override {
    if (m_resources.setScene(std::move(scene), m_jobs)) ++m_sceneRevision;
    queuePrograms();
  }

  bool renderFrame(const FrameRequest& request) override {
    const std::uint64_t revision = uploadScene();
    return m_frame.draw(request, m_resources, revision, m_statistics);
  }
  bool beginFrame(const FrameRequest& request) override {
    const std::uint64_t revision = uploadScene();
    return m_frame.begin(request, m_resources, revision, m_statistics);
  }
  bool beginningIsDrawn() const override { return m_frame.beginningIsDrawn(); }

  bool lightIsPending() const override { return m_frame.lightIsPending(); }

  bool accumulating() const override { return m_frame.accumulating(); }
  void restartAccumulation() override { m_frame.restart(); }

  bool runJobs(double budgetMs) override {
    Warnings messages;
    const bool left = m_jobs.run(budgetMs, messages);
    for (const std::string& message : messages) m_messages.say(message);
    if (m_failed.empty() && !messages.empty()) m_failed = messages.front();
    return left;
  }
  bool jobsAreQueued() const override { return !m_jobs.idle(); }
  bool drawable() const override { return m_jobs.onlyLastLeft(); }
  std::pair<std::string, double> jobProgress() const override { return m_jobs.progress(); }
  void cancelJobs() override {
    m_jobs.cancel();
    m_resources.jobsCancelled();
  }
  Result<void> finishJobs() override {
    Result<void> finished = m_jobs.finish();
    // What went wrong in an earlier runJobs() is told here too: whoever finishes wants to know that all is there.
    const std::string failed = std::exchange(m_failed, {});
    if (finished && !failed.empty()) return runtimeError(failed);
    return finished;
  }

  Image readAov(Aov aov) override { return m_frame.readAov(aov); }
  void keepAovs(const std::vector<Aov>& aovs) override {
    SceneImages images = kBeautyOnly;
    for (const Aov aov : aovs) images |= bitOf(sceneImageOf(aov));
    m_frame.keep(images);
    queuePrograms(images != kBeautyOnly);
  }
  Image readDisplay(const ViewSettings& view, PixelType type) override { return readView(Aov::Beauty, view, type); }
  Image readView(Aov aov, const ViewSettings& view, PixelType type) override {
    return m_frame.readView(aov, m_resources.scene(), view, type);
  }
  std::optional<glm::vec3> pickPosition(glm::ivec2 pixel) override { return m_frame.pickPosition(pixel); }
  std::optional<PixelReadout> readPixel(glm::ivec2 pixel, const ViewSettings& view) override {
    return m_frame.readPixel(pixel, view);
  }

  const GlInfo& glInfo() const override { return m_info; }
  RenderStatistics statistics() const override {
    RenderStatistics statistics = m_statistics;
    statistics.programsCompiled = m_shaders.compileCount();
    statistics.environmentsBaked = m_resources.environmentsBaked();
    statistics.environmentsFromCache = m_resources.environmentsFromCache();
    statistics.meshesBaked = m_resources.meshBakeRevision();
    statistics.displayProgramsBuilt = m_frame.displayProgramsBuilt();
    statistics.glErrors = m_debug.count();
    return statistics;
  }
  std::vector<PassTime> passTimes() const override { return m_frame.passTimes(); }
  Warnings takeMessages() override {
    for (const std::string& message : m_resources.takeEnvironmentWarnings()) m_messages.say(message);
    for (const std::string& message : m_debug.take()) m_messages.say("OpenGL: " + message);
    return m_messages.take();
  }
  void reloadChangedShaders() override {
    Warnings messages;
    m_messages.clear();
    if (m_shaders.reloadChanged(messages)) ++m_shaderRevision;
    for (const std::string& message : messages) m_messages.say(message);
  }

 private:
  /// Sends what the scene has got since the last frame; a number that changes with whatever changes the picture.
  std::uint64_t uploadScene() {
    Warnings messages;
    m_resources.upload(m_statistics, messages);
    for (const std::string& message : messages) m_messages.say(message);
    return m_sceneRevision + m_resources.environmentRevision() + m_resources.meshBakeRevision() +
           m_resources.textureRevision() + m_shaderRevision;
  }

  /// Compiles what the scene's materials need, one program a slice, before the first frame asks for it: in a window
  /// that is a moving one on software GL, so what still ones need comes last.
  void queuePrograms(bool withAovs = false) {
    if (m_resources.scene() == nullptr) return;
    std::vector<gl::ProgramSources> both, still, moving;
    const ResolvedScene& scene = *m_resources.scene();
    const bool deferred = m_info.software && deferringPays(scene);
    const bool castShadows =
        std::ranges::any_of(scene.scene.lights, [](const Light& light) { return light.enabled && light.shadow; });
    for (std::size_t i = 0; i < scene.slots.size(); ++i) {
      const std::optional<int> maps = m_info.software ? std::optional<int>(presentMaps(scene, i)) : std::nullopt;
      const ShadingModel model = scene.slots[i].material.model;
      const bool blended = isBlended(scene.slots[i].material);
      const bool mayDisplace = canDisplace(scene, i);
      const bool tiled = readsTiles(scene, i);
      const bool cutOuts = hasCutOuts(scene.slots[i].material);
      const gl::ProgramSources surface =
          withTiles(surfaceProgram(model, surfaceOutputs(scene, withAovs, blended), maps), tiled);
      // A picture that moves or doesn't, drawn in two steps.
      const auto twoSteps = [&](bool move, std::vector<gl::ProgramSources>& list) {
        list.push_back(deferredProgram(scene, i, move, surfaceOutputs(scene, withAovs, false)));
        list.push_back(geometryProgram(move, false));
        if (mayDisplace) list.push_back(withTiles(geometryProgram(move, true), tiled));
      };
      if (deferred && !blended) {
        twoSteps(false, still);
        if (m_hasWindow && !withAovs) twoSteps(true, moving);
      } else {
        both.push_back(surface);
        if (mayDisplace) both.push_back(tessellated(surface));
      }
      both.push_back(vertexLightProgram(scene, i, false));
      if (deferred && m_hasWindow) moving.push_back(vertexLightProgram(scene, i, true));
      if (castShadows) both.push_back(withTiles(casterProgram(cutOuts), cutOuts && tiled));
      if (mayDisplace) both.push_back(withTiles(displacedCasterProgram(), tiled));
    }
    // Without a window what spreads the light is compiled when it is drawn: a picture of one sample takes the other
    // one.
    if (m_hasWindow && (isSplit(scene) || withAovs)) {
      const std::size_t profiles = profileCount(scene);
      for (gl::ProgramSources& sources : subsurfacePrograms(DiffusionQuality::Disc, profiles))
        still.push_back(std::move(sources));
      for (gl::ProgramSources& sources : subsurfacePrograms(DiffusionQuality::Separable, profiles))
        moving.push_back(std::move(sources));
    }
    std::vector<gl::ProgramSources> wanted;
    for (const auto* list : {&moving, &both, &still})
      for (const gl::ProgramSources& sources : *list)
        if (!m_shaders.has(sources) && std::find(wanted.begin(), wanted.end(), sources) == wanted.end())
          wanted.push_back(sources);
    if (wanted.empty()) return;
    auto step = [this, wanted, next = std::size_t{0}]() mutable -> Result<bool> {
      auto program = m_shaders.program(wanted[next++]);
      if (!program) return tl::unexpected(program.error());
      return next == wanted.size();
    };
    m_jobs.add("programs", gl::makeJob("Preparing shaders", std::move(step)));
  }

  GlInfo m_info;
  bool m_hasWindow;
  gl::DebugOutput m_debug;
  MessageLog m_messages;
  gl::ShaderLibrary m_shaders;
  SceneResources m_resources;
  mutable Frame m_frame;  ///< collecting the timers' results changes it
  std::string m_failed;   ///< the first job's error that finishJobs() has not told yet
  gl::JobQueue m_jobs;    ///< after what its jobs work on, so that it goes first
  RenderStatistics m_statistics;
  std::uint64_t m_sceneRevision = 0, m_shaderRevision = 0;
};

}  // namespace

std::string_view toString(Aov aov) { return kAovs.at(static_cast<std::size_t>(aov)).second; }

std::vector<Aov> allAovs() {
  std::vector<Aov> aovs;
  aovs.reserve(kAovs.size());
  for (const auto& [aov, name] : kAovs) aovs.push_back(aov);
  return aovs;
}

GlInfo currentGlInfo(const std::string& platform) {
  GlInfo info{glString(GL_VENDOR), glString(GL_RENDERER), glString(GL_VERSION), platform, false};
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"})
    info.software = info.software || info.renderer.find(name) != std::string::npos;
  return info;
}

Result<std::unique_ptr<Renderer>> Renderer::create(const RendererOptions& options) {
  const int version = epoxy_gl_version();
  GLint profile = 0;
  if (version >= 45) glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  if (version < 45)
    return runtimeError("OpenGL 4.5 is needed and this driver offers " + std::to_string(version / 10) + "." +
                        std::to_string(version % 10) +
                        "; install a newer driver, or run with LIBGL_ALWAYS_SOFTWARE=1 for Mesa's software renderer.");
  GlInfo info = currentGlInfo(options.platform);
  info.software = options.software.value_or(info.software);
  return std::make_unique<GlRenderer>(options, std::move(info));
}

}  // namespace dermis
