#include "ui/browse/preset_library.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include "core/base/file_reference.h"
#include "core/io/asset_loader.h"
#include "core/material/builtin_presets.h"
#include "core/material/preset_io.h"
#include "core/material/preset_tags.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/text.h"
#include "ui/translation.h"

namespace dermis {
namespace {

constexpr int kSettleMs = 150;

QString thumbnailKey(const Material& material) {
  QCryptographicHash hash(QCryptographicHash::Sha1);
  // Another program may draw the same preset otherwise.
  static const std::string kProgram = AssetCache::fileKey(toPath(QCoreApplication::applicationFilePath()));
  hash.addData(QByteArray(DERMIS_VERSION));
  hash.addData(QByteArray::fromStdString(kProgram));
  hash.addData(QByteArray::fromStdString(writePreset(material, {})));
  for (const TextureBinding& map : material.textures)
    if (map.present() && !namesNoFile(map.path)) hash.addData(QByteArray::fromStdString(AssetCache::mapKey(map.path)));
  return QString::fromLatin1(hash.result().toHex());
}

PresetEntry makeEntry(const QString& path, const QString& name, Material material) {
  PresetEntry entry;
  entry.path = path;
  entry.name = name;
  entry.tags << tableText(shadingModelRow(material.model).label)
             << (entry.isBuiltin() ? PresetLibrary::tr("built in") : PresetLibrary::tr("mine"));
  for (const std::string& tag : presetTags(material)) entry.tags << text(tag);
  entry.key = thumbnailKey(material);
  entry.material = std::move(material);
  return entry;
}

/// A file of that name which isn't there yet, beside others of one folder; `own` may be there.
QString freeFile(const QString& folder, const QString& name, const QString& own = {}) {
  const QString stem = fileNameOf(name);
  QString path = folder + QLatin1Char('/') + stem + QStringLiteral(".json");
  for (int i = 2; QFile::exists(path) && path != own; ++i)
    path = QStringLiteral("%1/%2 %3.json").arg(folder, stem).arg(i);
  return path;
}

}  // namespace

QString userPresetFolder() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/presets");
  QDir().mkpath(folder);
  return folder;
}

bool PresetEntry::isBuiltin() const { return builtinName(path.toStdString()).has_value(); }

PresetLibrary::PresetLibrary(QObject* parent) : QObject(parent) {
  // An editor that saves makes several changes at once.
  m_soon.setSingleShot(true);
  m_soon.setInterval(kSettleMs);
  connect(&m_soon, &QTimer::timeout, this, &PresetLibrary::refresh);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] { m_soon.start(); });
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] { m_soon.start(); });
}

void PresetLibrary::setFolders(const QStringList& folders) {
  m_folders = QStringList{userPresetFolder()} + folders;
  m_folders.removeDuplicates();
  refresh();
}

void PresetLibrary::refresh() {
  m_entries.clear();
  addBuiltins();
  QStringList watched;
  for (const QString& folder : m_folders) {
    if (QDir(folder).exists()) watched << folder;
    for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
      watched << file.absoluteFilePath();
      addFile(file.absoluteFilePath());
    }
  }
  const QStringList before = m_watcher.files() + m_watcher.directories();
  QStringList gone, come;
  for (const QString& path : before)
    if (!watched.contains(path)) gone << path;
  for (const QString& path : watched)
    if (!before.contains(path)) come << path;
  if (!gone.isEmpty()) m_watcher.removePaths(gone);
  if (!come.isEmpty()) m_watcher.addPaths(come);
  Q_EMIT changed();
}

void PresetLibrary::addBuiltins() {
  static const std::vector<PresetEntry> kBuiltins = [] {
    std::vector<PresetEntry> entries;
    Warnings ignored;
    for (const BuiltinPreset& preset : builtinPresets())
      if (Result<Material> material = loadBuiltinPreset(preset.id, ignored))
        entries.push_back(makeEntry(text(builtinReference(preset.id)), tableText(preset.name), std::move(*material)));
    return entries;
  }();
  m_entries = kBuiltins;
}

void PresetLibrary::addFile(const QString& path) {
  const QString state = text(AssetCache::fileKey(toPath(path)));
  if (const auto known = m_known.find(state); known != m_known.end()) {
    m_entries.push_back(*known);
    return;
  }
  Warnings ignored;
  // A file that isn't a preset simply isn't listed: opening it by hand says why.
  Result<Material> material = loadPreset(toPath(path), ignored);
  if (!material) return;
  const QString name = material->name.empty() ? QFileInfo(path).completeBaseName() : text(material->name);
  m_entries.push_back(makeEntry(path, name, std::move(*material)));
  m_known.insert(state, m_entries.back());
}

const PresetEntry* PresetLibrary::find(const QString& path) const {
  const auto found = std::ranges::find(m_entries, path, &PresetEntry::path);
  return found == m_entries.end() ? nullptr : &*found;
}

QStringList PresetLibrary::tags() const {
  QStringList tags;
  for (const PresetEntry& entry : m_entries) tags << entry.tags;
  tags.removeDuplicates();
  tags.sort(Qt::CaseInsensitive);
  return tags;
}

Result<QString> PresetLibrary::duplicate(const PresetEntry& entry) {
  Material material = entry.material;
  material.name = tr("%1 copy").arg(entry.name).toStdString();
  QString path = freeFile(userPresetFolder(), text(material.name));
  if (const Result<void> saved = savePreset(toPath(path), material); !saved) return tl::unexpected(saved.error());
  refresh();
  return path;
}

Result<QString> PresetLibrary::rename(const PresetEntry& entry, const QString& name) {
  const QString old = entry.path;
  const Material before = entry.material;
  Material material = before;
  material.name = name.toStdString();
  QString path = freeFile(QFileInfo(old).path(), name, old);
  if (path == old && material == before) return path;
  if (const Result<void> saved = savePreset(toPath(path), material); !saved) return tl::unexpected(saved.error());
  if (path != old && !QFile::remove(old)) {
    refresh();
    return runtimeError(old.toStdString() + " could not be removed; the preset is there under both names");
  }
  Q_EMIT rewritten(old, path, before, material);
  refresh();
  return path;
}

Result<void> PresetLibrary::setTags(const PresetEntry& entry, const QStringList& tags) {
  const Material before = entry.material;
  Material material = before;
  const QString path = entry.path;
  std::vector<std::string> words;
  for (const QString& tag : tags)
    if (!tag.simplified().isEmpty()) words.push_back(tag.simplified().toStdString());
  setPresetTags(material, words);
  Result<void> saved = savePreset(toPath(path), material);
  if (!saved) return saved;
  Q_EMIT rewritten(path, path, before, material);
  refresh();
  return saved;
}

Result<void> PresetLibrary::moveToTrash(const PresetEntry& entry) {
  const QString path = entry.path;
  if (!QFile::moveToTrash(path))
    return runtimeError(path.toStdString() +
                        " could not be moved to the trash: there is none on that disk, or the folder is read-only");
  refresh();
  return {};
}

}  // namespace dermis
