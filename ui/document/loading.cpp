#include "ui/document/loading.h"

#include <algorithm>
#include <array>

#include "core/base/file_reference.h"
#include "core/builtin/default_look.h"
#include "core/light_rig/rig_io.h"
#include "core/material/preset_io.h"
#include "core/scene/scene_io.h"
#include "ui/document/loading_run.h"
#include "ui/document/material_images.h"

namespace dermis {
namespace {

constexpr std::array<std::string_view, 10> kModelEndings = {".obj", ".gltf", ".glb", ".fbx",   ".ply",
                                                            ".stl", ".dae",  ".3ds", ".blend", ".x3d"};
constexpr std::array<std::string_view, 2> kEnvironmentEndings = {".hdr", ".exr"};
constexpr std::array<std::string_view, 8> kImageEndings = {".png",  ".jpg", ".jpeg", ".tif",
                                                           ".tiff", ".tga", ".bmp",  ".webp"};

template <std::size_t N>
bool has(const std::array<std::string_view, N>& endings, const std::string& ending) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

template <std::size_t N>
void appendPatterns(QStringList& patterns, const std::array<std::string_view, N>& endings) {
  for (const std::string_view ending : endings)
    patterns << QLatin1Char('*') + QString::fromUtf8(ending.data(), static_cast<qsizetype>(ending.size()));
}

QString fileName(const std::filesystem::path& path) { return QString::fromStdString(path.filename().string()); }

}  // namespace

FileKind fileKind(const std::filesystem::path& path) {
  const std::string ending = QString::fromStdString(path.extension().string()).toLower().toStdString();
  if (ending == ".dermis") return FileKind::Scene;
  if (ending == ".json") return isRigFile(path) ? FileKind::Environment : FileKind::Preset;
  if (has(kModelEndings, ending)) return FileKind::Model;
  if (has(kEnvironmentEndings, ending)) return FileKind::Environment;
  if (has(kImageEndings, ending)) return FileKind::Image;
  return FileKind::Unknown;
}

QString namePatterns(FileKind kind) {
  QStringList patterns;
  switch (kind) {
    case FileKind::Scene:
      patterns << QStringLiteral("*.dermis");
      break;
    case FileKind::Preset:
      patterns << QStringLiteral("*.json");
      break;
    case FileKind::Model:
      appendPatterns(patterns, kModelEndings);
      break;
    case FileKind::Environment:
      patterns << QStringLiteral("*.json");
      [[fallthrough]];
    case FileKind::Image:
      appendPatterns(patterns, kEnvironmentEndings);
      appendPatterns(patterns, kImageEndings);
      break;
    case FileKind::Unknown:
      patterns << QStringLiteral("*");
      break;
  }
  return patterns.join(QLatin1Char(' '));
}

Loading::Loading(Document& document, TaskRunner& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {}

void Loading::tellWarnings(const Warnings& warnings) {
  for (const std::string& warning : warnings) Q_EMIT message(MessageKind::Warning, QString::fromStdString(warning));
}

void Loading::newScene() {
  run(
      QStringLiteral("scene"), tr("Preparing the scene"),
      [](const ResolveOptions& options, Warnings& warnings) {
        return resolveScene(defaultLook(), {}, options, warnings);
      },
      [this](ResolvedScene&& resolved) {
        m_document.replace(resolved, {});
        Q_EMIT finished();
      });
}

void Loading::openScene(const std::filesystem::path& path) {
  run(
      QStringLiteral("scene"), tr("Opening %1").arg(fileName(path)),
      [path](const ResolveOptions& options, Warnings& warnings) -> Result<ResolvedScene> {
        Result<Scene> scene = loadScene(path, warnings);
        if (!scene) return tl::unexpected(scene.error());
        return resolveScene(*scene, std::filesystem::absolute(path).parent_path(), options, warnings);
      },
      [this, path](ResolvedScene&& resolved) {
        m_document.replace(resolved, std::filesystem::absolute(path));
        Q_EMIT fileUsed(QString::fromStdString(std::filesystem::absolute(path).string()));
        Q_EMIT finished();
      });
}

void Loading::openUnsaved(const Scene& scene, const std::filesystem::path& path, std::function<void()> done) {
  run(
      QStringLiteral("scene"), tr("Recovering the scene"),
      [scene](const ResolveOptions& options, Warnings& warnings) { return resolveScene(scene, {}, options, warnings); },
      [this, path, done = std::move(done)](ResolvedScene&& resolved) {
        m_document.replace(resolved, path);
        m_document.markUnsaved();
        done();
        Q_EMIT finished();
      });
}

void Loading::openModel(const ModelSource& source) {
  Scene only;
  only.model = source;
  if (!source.path.empty()) only.model.path = std::filesystem::absolute(source.path).string();
  const QString name = source.path.empty() ? QString::fromStdString(source.builtin) : fileName(source.path);
  run(
      QStringLiteral("scene"), tr("Loading %1").arg(name),
      [only](const ResolveOptions& given, Warnings& warnings) {
        ResolveOptions options = given;
        options.importedMaterials = true;
        return resolveScene(only, {}, options, warnings);
      },
      [this, only](ResolvedScene&& resolved) {
        m_document.openModel(only.model, resolved.model, std::move(resolved.slots));
        if (!only.model.path.empty()) {
          Q_EMIT fileUsed(QString::fromStdString(only.model.path));
          Q_EMIT modelOpened(fileName(only.model.path), QString::fromStdString(resolved.model->unitSource));
        }
        Q_EMIT message(MessageKind::Info,
                       tr("%1: %2 mm tall (%3)")
                           .arg(QString::fromStdString(only.model.path.empty() ? only.model.builtin : only.model.path))
                           .arg(static_cast<double>((resolved.model->bounds.max.y - resolved.model->bounds.min.y) *
                                                    m_document.millimetresPerUnit()),
                                0, 'f', 1)
                           .arg(QString::fromStdString(resolved.model->unitSource)));
        Q_EMIT finished();
      });
}

void Loading::applyPreset(const std::string& preset, const QString& slot) {
  if (m_document.slotLook(slot) == nullptr) return;
  const std::string path = builtinName(preset) ? preset : std::filesystem::absolute(preset).string();
  run(
      QStringLiteral("preset/") + slot, tr("Loading preset"),
      [path](const ResolveOptions& options, Warnings& warnings) -> Result<ResolvedMaterial> {
        Result<Material> material = loadPreset(path, warnings);
        if (!material) return tl::unexpected(material.error());
        return decodeMaps(*material, nullptr, options, warnings);
      },
      [this, slot, path](ResolvedMaterial&& material) {
        m_document.applyMaterial(slot, material, path);
        if (!builtinName(path)) Q_EMIT fileUsed(QString::fromStdString(path));
        Q_EMIT finished();
      });
}

void Loading::revertToPreset(const QString& slot) {
  const SlotLook* look = m_document.slotLook(slot);
  if (look == nullptr || !look->preset) return;
  run(
      QStringLiteral("preset/") + slot, tr("Reverting"),
      [preset = *look->preset, model = m_document.model()](const ResolveOptions& options, Warnings& warnings) {
        return decodeMaps(preset, model, options, warnings);
      },
      [this, slot](ResolvedMaterial&& material) { m_document.revertToPreset(slot, material); });
}

void Loading::setEnvironment(const EnvironmentSource& source) {
  const QString name = source.path.empty() ? QString::fromStdString(source.builtin) : fileName(source.path);
  run(
      QStringLiteral("environment"), tr("Loading %1").arg(name),
      [source](const ResolveOptions& options, Warnings& warnings) {
        return resolveEnvironment(source, {}, options, warnings);
      },
      [this, source](std::shared_ptr<const EnvironmentImages>&& images) {
        m_document.setEnvironment(source, std::move(images));
        if (!source.path.empty()) Q_EMIT fileUsed(QString::fromStdString(source.path));
        Q_EMIT finished();
      });
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
  run(
      QStringLiteral("scene"), tr("Preparing the scene"),
      [scenePath, model, environment](const ResolveOptions& given, Warnings& warnings) -> Result<ResolvedScene> {
        Scene scene = defaultLook();
        if (!scenePath.empty()) {
          Result<Scene> loaded = loadScene(scenePath, warnings);
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
      [this, scenePath, presets](ResolvedScene&& resolved) {
        m_document.replace(resolved, scenePath);
        for (const std::filesystem::path& preset : presets) applyPreset(preset.string(), m_document.currentSlot());
        Q_EMIT finished();
      },
      // Whatever is wrong with the files, there is a picture.
      [this] { newScene(); });
}

bool Loading::saveScene(const std::filesystem::path& path) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  if (const Result<void> saved = dermis::saveScene(file, m_document.sceneForSaving()); !saved) {
    Q_EMIT message(MessageKind::Error, QString::fromStdString(saved.error().message));
    return false;
  }
  m_document.markSaved(file);
  Q_EMIT fileUsed(QString::fromStdString(file.string()));
  Q_EMIT message(MessageKind::Info, tr("Saved %1").arg(QString::fromStdString(file.string())));
  return true;
}

bool Loading::savePreset(const QString& slot, const std::filesystem::path& path) {
  const SlotLook* look = m_document.slotLook(slot);
  if (look == nullptr) return false;
  const std::filesystem::path file = std::filesystem::absolute(path);
  Material material = look->worn.material;
  if (material.name.empty()) material.name = file.stem().string();
  if (const Result<void> saved = dermis::savePreset(file, material); !saved) {
    Q_EMIT message(MessageKind::Error, QString::fromStdString(saved.error().message));
    return false;
  }
  m_document.markPresetSaved(slot, file);
  Q_EMIT presetSaved(QString::fromStdString(file.string()));
  Q_EMIT message(MessageKind::Info, tr("Saved %1").arg(QString::fromStdString(file.string())));
  return true;
}

bool Loading::saveRig(const LightRig& rig, const std::filesystem::path& path) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  if (const Result<void> saved = dermis::saveRig(file, rig); !saved) {
    Q_EMIT message(MessageKind::Error, QString::fromStdString(saved.error().message));
    return false;
  }
  Q_EMIT message(MessageKind::Info, tr("Saved %1").arg(QString::fromStdString(file.string())));
  return true;
}

}  // namespace dermis
