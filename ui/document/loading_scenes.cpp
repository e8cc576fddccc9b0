// Whole scenes: new ones, opened ones, recovered ones, those of pictures, and what the command line names.
#include "core/builtin/default_look.h"
#include "core/scene/scene_io.h"
#include "ui/document/loading_run.h"
#include "ui/text.h"

namespace dermis {

template <class Work, class Done>
void Loading::runScene(const QString& title, Work work, Done done, std::function<void()> failed) {
  run(
      QStringLiteral("scene"), title, std::move(work),
      [this, edits = m_document.edits(), done = std::move(done)](ResolvedScene&& resolved) {
        const bool editedSince = m_document.isModified() && m_document.edits() != edits;
        if (editedSince && m_mayDiscard && !m_mayDiscard()) return;
        done(std::move(resolved));
        Q_EMIT finished();
      },
      std::move(failed));
}

void Loading::prepareFirst() {
  if (!m_document.isReady() && !m_tasks.busy(QStringLiteral("scene"))) newScene();
}

void Loading::cancel() {
  m_tasks.cancelAll();
  prepareFirst();
}

void Loading::newScene() {
  runScene(
      tr("Preparing the scene"),
      [](const ResolveOptions& options, Warnings& warnings) {
        return resolveScene(defaultLook(), {}, options, warnings);
      },
      [this](ResolvedScene&& resolved) {
        m_document.replace(resolved, {});
        Q_EMIT framingWanted();
      },
      {});
}

void Loading::openScene(const std::filesystem::path& path) {
  runScene(
      tr("Opening %1").arg(pathText(path.filename())),
      [path](const ResolveOptions& options, Warnings& warnings) -> Result<ResolvedScene> {
        Result<Scene> scene = loadScene(path, warnings, MissingPresets::Keep);
        if (!scene) return tl::unexpected(scene.error());
        return resolveScene(*scene, std::filesystem::absolute(path).parent_path(), options, warnings);
      },
      [this, path](ResolvedScene&& resolved) {
        m_document.replace(resolved, std::filesystem::absolute(path));
        Q_EMIT fileUsed(pathText(std::filesystem::absolute(path)));
      },
      [this] { prepareFirst(); });
}

void Loading::openUnsaved(const Scene& scene, const std::filesystem::path& path, std::function<void()> done) {
  runScene(
      tr("Recovering the scene"),
      [scene](const ResolveOptions& options, Warnings& warnings) { return resolveScene(scene, {}, options, warnings); },
      [this, path, done = std::move(done)](ResolvedScene&& resolved) {
        m_document.replace(resolved, path);
        m_document.markUnsaved();
        done();
      },
      [this] { prepareFirst(); });
}

void Loading::openPictureScene(const std::filesystem::path& picture, const std::string& sceneText) {
  runScene(
      tr("Opening the scene of %1").arg(pathText(picture.filename())),
      [picture, sceneText](const ResolveOptions& options, Warnings& warnings) -> Result<ResolvedScene> {
        const std::filesystem::path folder = std::filesystem::absolute(picture).parent_path();
        const Result<Scene> scene = readScene(sceneText, picture.string(), folder, warnings, MissingPresets::Keep);
        if (!scene) return tl::unexpected(scene.error());
        return resolveScene(*scene, folder, options, warnings);
      },
      [this](ResolvedScene&& resolved) { m_document.replace(resolved, {}); }, [this] { prepareFirst(); });
}

void Loading::openAtStart(const std::vector<std::filesystem::path>& files) {
  std::filesystem::path scenePath, model, environment;
  std::vector<std::filesystem::path> presets;
  for (const std::filesystem::path& file : files) {
    switch (fileKind(file)) {
      case FileKind::Scene:
        scenePath = std::filesystem::absolute(file);
        break;
      case FileKind::Model:
        model = std::filesystem::absolute(file);
        break;
      case FileKind::Environment:
      case FileKind::Image:
        environment = std::filesystem::absolute(file);
        break;
      case FileKind::Preset:
        presets.push_back(file);
        break;
      case FileKind::Unknown:
        Q_EMIT message(
            MessageKind::Error,
            tr("%1 is no scene, model, preset or environment by its name").arg(QString::fromStdString(file.string())));
    }
  }
  runScene(
      tr("Preparing the scene"),
      [scenePath, model, environment](const ResolveOptions& given, Warnings& warnings) -> Result<ResolvedScene> {
        Scene scene = defaultLook();
        if (!scenePath.empty()) {
          Result<Scene> loaded = loadScene(scenePath, warnings, MissingPresets::Keep);
          if (!loaded) return tl::unexpected(loaded.error());
          scene = std::move(*loaded);
        }
        ResolveOptions options = given;
        if (!model.empty()) {
          scene.model = ModelSource{model.string(), {}, {}, std::nullopt};
          if (scenePath.empty()) scene.materials.clear();
          scene.camera.reset();
          options.importedMaterials = true;
        }
        if (!environment.empty()) {
          scene.environment.path = environment.string();
          scene.environment.builtin.clear();
          scene.environment.rig.reset();
        }
        return resolveScene(scene, scenePath.parent_path(), options, warnings);
      },
      [this, scenePath, model, environment, presets](ResolvedScene&& resolved) {
        m_document.replace(resolved, scenePath);
        if (scenePath.empty() || !model.empty()) Q_EMIT framingWanted();
        for (const std::filesystem::path& file : {environment, model, scenePath})
          if (!file.empty()) Q_EMIT fileUsed(pathText(file));
        if (!model.empty()) Q_EMIT modelOpened(pathText(model.filename()), text(m_document.model()->unitSource));
        for (const std::filesystem::path& preset : presets) applyPreset(preset.string(), {m_document.currentSlot()});
      },
      // Whatever is wrong with the files, there is a picture.
      [this] { newScene(); });
}

}  // namespace dermis
