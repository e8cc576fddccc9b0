#include "ui/browse/preset_library.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QSet>
#include <QStandardPaths>
#include <algorithm>
#include <iterator>
#include <optional>

#include "core/base/file_reference.h"
#include "core/io/asset_loader.h"
#include "core/material/builtin_presets.h"
#include "core/material/preset_io.h"
#include "core/material/preset_tags.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/text.h"
#include "ui/thumbnails.h"
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

const std::vector<PresetEntry>& builtins() {
  static const std::vector<PresetEntry> kBuiltins = [] {
    std::vector<PresetEntry> entries;
    Warnings ignored;
    for (const BuiltinPreset& preset : builtinPresets())
      if (Result<Material> material = loadBuiltinPreset(preset.id, ignored))
        entries.push_back(makeEntry(text(builtinReference(preset.id)), tableText(preset.name), std::move(*material)));
    return entries;
  }();
  return kBuiltins;
}

QString nameOf(const Material& material, const QString& path) {
  return material.name.empty() ? QFileInfo(path).completeBaseName() : text(material.name);
}

/// A file that isn't a preset simply isn't listed: opening it by hand says why.
std::optional<PresetEntry> readEntry(const QString& path) {
  Warnings ignored;
  Result<Material> material = loadPreset(toPath(path), ignored);
  if (!material) return std::nullopt;
  const QString name = nameOf(*material, path);
  PresetEntry entry = makeEntry(path, name, std::move(*material));
  entry.ball = materialBall(entry.material, PresetEntry::kBall);
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

PresetLibrary::PresetLibrary(QObject* parent) : QObject(parent), m_entries(builtins()) {
  // An editor that saves makes several changes at once.
  m_soon.setSingleShot(true);
  m_soon.setInterval(kSettleMs);
  connect(&m_soon, &QTimer::timeout, this, &PresetLibrary::refresh);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] { m_soon.start(); });
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] { m_soon.start(); });
  connect(&m_tasks, &TaskRunner::problem, this, &PresetLibrary::problem);
}

void PresetLibrary::setFolders(const QStringList& folders) {
  m_folders = QStringList{userPresetFolder()} + folders;
  m_folders.removeDuplicates();
  refresh();
}

void PresetLibrary::refresh() {
  // One lane: what an older reading finds is no longer wanted.
  m_tasks.run(
      QStringLiteral("presets"), tr("Reading presets"),
      [folders = m_folders, known = m_known](const std::stop_token& stop) { return read(folders, known, stop); },
      [this](Found found) { take(std::move(found)); });
}

PresetLibrary::Found PresetLibrary::read(const QStringList& folders, const Known& known, const std::stop_token& stop) {
  Found found;
  for (const QString& folder : folders) {
    if (QDir(folder).exists()) found.watched << folder;
    for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
      if (stop.stop_requested()) return {};
      const QString path = file.absoluteFilePath();
      found.watched << path;
      const QString state = text(AssetCache::fileKey(toPath(path)));
      std::optional<PresetEntry> entry;
      if (const auto before = known.find(state); before != known.end())
        entry = *before;
      else
        entry = readEntry(path);
      if (!entry) continue;
      found.entries.push_back(*entry);
      found.known.insert(state, *entry);
    }
  }
  return found;
}

void PresetLibrary::take(Found found) {
  watch(found.watched);
  m_known = std::move(found.known);
  std::vector<PresetEntry> entries = builtins();
  std::ranges::move(found.entries, std::back_inserter(entries));
  const auto same = [](const PresetEntry& a, const PresetEntry& b) {
    return a.path == b.path && a.name == b.name && a.tags == b.tags && a.key == b.key;
  };
  if (std::ranges::equal(entries, m_entries, same)) return;
  m_entries = std::move(entries);
  Q_EMIT changed();
}

void PresetLibrary::watch(const QStringList& paths) {
  const auto without = [](const QStringList& all, const QStringList& some) {
    const QSet<QString> left(some.begin(), some.end());
    QStringList rest;
    for (const QString& each : all)
      if (!left.contains(each)) rest << each;
    return rest;
  };
  const QStringList before = m_watcher.files() + m_watcher.directories();
  if (const QStringList gone = without(before, paths); !gone.isEmpty()) m_watcher.removePaths(gone);
  if (const QStringList come = without(paths, before); !come.isEmpty()) m_watcher.addPaths(come);
}

void PresetLibrary::put(const QString& path, PresetEntry entry) {
  if (const auto found = std::ranges::find(m_entries, path, &PresetEntry::path); found != m_entries.end())
    *found = std::move(entry);
  else
    m_entries.push_back(std::move(entry));
  Q_EMIT changed();
  refresh();
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
  const QString name = text(material.name);
  put(path, makeEntry(path, name, std::move(material)));
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
  put(old, makeEntry(path, nameOf(material, path), material));
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
  put(path, makeEntry(path, nameOf(material, path), material));
  return saved;
}

Result<void> PresetLibrary::moveToTrash(const PresetEntry& entry) {
  const QString path = entry.path;
  if (!QFile::moveToTrash(path))
    return runtimeError(path.toStdString() +
                        " could not be moved to the trash: there is none on that disk, or the folder is read-only");
  std::erase_if(m_entries, [&](const PresetEntry& each) { return each.path == path; });
  Q_EMIT changed();
  refresh();
  return {};
}

}  // namespace dermis
