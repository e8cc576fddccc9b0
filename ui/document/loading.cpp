#include "ui/document/loading.h"

#include <algorithm>
#include <array>

#include "core/base/file_reference.h"
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

void Loading::openModel(const ModelSource& source) {
  if (!m_document.isReady() && !source.path.empty()) return openAtStart({source.path});
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

void Loading::applyPreset(const std::string& preset, const QStringList& slots_) {
  if (slots_.isEmpty()) return;
  const std::string path = builtinName(preset) ? preset : std::filesystem::absolute(preset).string();
  run(
      QStringLiteral("preset/") + slots_.join(QLatin1Char('/')), tr("Loading preset"),
      [path](const ResolveOptions& options, Warnings& warnings) -> Result<ResolvedMaterial> {
        Result<Material> material = loadPreset(path, warnings);
        if (!material) return tl::unexpected(material.error());
        return decodeMaps(*material, nullptr, options, warnings);
      },
      [this, slots_, path](ResolvedMaterial&& material) {
        m_document.applyMaterial(slots_, material, path);
        if (!builtinName(path)) Q_EMIT fileUsed(QString::fromStdString(path));
        Q_EMIT finished();
      });
}

void Loading::revertToPreset(const QStringList& slots_) {
  struct Wanted {
    QString slot;
    std::shared_ptr<const Material> preset;  ///< null: what stands in the file is not known yet
    std::string path;
  };
  std::vector<Wanted> all;
  for (const QString& slot : slots_) {
    const SlotLook* look = m_document.slotLook(slot);
    if (look == nullptr || !look->binding) continue;
    const std::shared_ptr<const Material> preset = look->binding->missing ? nullptr : look->preset;
    if (preset || !look->binding->presetPath.empty()) all.push_back({slot, preset, look->binding->presetPath});
  }
  if (all.empty()) return;
  using Presets = std::vector<std::pair<QString, ResolvedMaterial>>;
  run(
      QStringLiteral("preset/") + slots_.join(QLatin1Char('/')), tr("Reverting"),
      [all, model = m_document.model()](const ResolveOptions& options, Warnings& warnings) -> Result<Presets> {
        Presets presets;
        for (const Wanted& wanted : all) {
          Result<Material> material =
              wanted.preset ? Result<Material>(*wanted.preset) : loadPreset(wanted.path, warnings);
          if (!material) return tl::unexpected(material.error());
          Result<ResolvedMaterial> decoded = decodeMaps(*material, model, options, warnings);
          if (!decoded) return tl::unexpected(decoded.error());
          presets.emplace_back(wanted.slot, std::move(*decoded));
        }
        return presets;
      },
      [this](Presets&& presets) { m_document.revertToPreset(presets); });
}

void Loading::setEnvironment(const EnvironmentSource& source) {
  const QString name = source.path.empty() ? QString::fromStdString(source.builtin) : fileName(source.path);
  run(
      QStringLiteral("environment"), tr("Loading %1").arg(name),
      [source](const ResolveOptions& options, Warnings& warnings) {
        return resolveEnvironment(source, {}, options, warnings);
      },
      [this, source](std::shared_ptr<const EnvironmentImages>&& images) {
        // It may have been turned while the file was read.
        const EnvironmentSource& now = m_document.scene().environment;
        EnvironmentSource next = source;
        next.rotationDegrees = now.rotationDegrees;
        next.exposureStops = now.exposureStops;
        next.background = now.background;
        m_document.setEnvironment(next, std::move(images));
        if (!source.path.empty()) Q_EMIT fileUsed(QString::fromStdString(source.path));
        Q_EMIT finished();
      });
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

bool Loading::savePreset(const QString& slot, const std::filesystem::path& path, const std::string& name) {
  const SlotLook* look = m_document.slotLook(slot);
  if (look == nullptr) return false;
  const std::filesystem::path file = std::filesystem::absolute(path);
  Material material = look->worn.material;
  if (!name.empty()) material.name = name;
  if (material.name.empty()) material.name = file.stem().string();
  if (const Result<void> saved = dermis::savePreset(file, material); !saved) {
    Q_EMIT message(MessageKind::Error, QString::fromStdString(saved.error().message));
    return false;
  }
  m_document.markPresetSaved(slot, file, material.name);
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
