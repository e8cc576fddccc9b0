#include "ui/document/map_watcher.h"

#include <QFileInfo>

#include "core/base/file_reference.h"
#include "core/io/udim.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"

namespace dermis {
namespace {

constexpr int kPauseMs = 120;  ///< a program writes a file in several goes
constexpr int kAttempts = 8;   ///< readings of a file that no longer changes, before it counts as broken

}  // namespace

MapWatcher::MapWatcher(Document& document, Loading& loading, QObject* parent)
    : QObject(parent), m_document(document), m_loading(loading) {
  m_soon.setSingleShot(true);
  m_soon.setInterval(kPauseMs);
  connect(&m_soon, &QTimer::timeout, this, &MapWatcher::look);
  const auto soon = [this] { m_soon.start(); };
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, soon);
  // A file that is renamed over another one is a new file: only its folder tells of it.
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, soon);
  connect(&m_loading, &Loading::mapReread, this, &MapWatcher::takeResult);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Material) followDocument();
  });
  followDocument();
}

MapWatcher::State MapWatcher::stateOf(const std::string& path) const {
  const auto file = m_files.find(path);
  return file == m_files.end() ? State::Good : file->second.state;
}

void MapWatcher::followDocument() {
  std::map<std::string, bool> worn;  // path → has a picture
  for (const QString& slot : m_document.slotNames()) {
    const ResolvedMaterial& material = m_document.slotLook(slot)->worn;
    for (std::size_t i = 0; i < kTextureSlotCount; ++i) {
      const std::string& path = material.material.textures.at(i).path;
      if (path.empty() || namesNoFile(path)) continue;
      worn[path] = worn[path] || material.images.at(i) != nullptr;
    }
  }
  bool changed = std::erase_if(m_files, [&](const auto& entry) { return !worn.contains(entry.first); }) > 0;
  for (const auto& [path, hasPicture] : worn) {
    const auto [file, added] = m_files.try_emplace(path);
    if (!added) continue;
    changed = true;
    const std::string key = AssetCache::mapKey(path);
    file->second = {key, key, hasPicture ? State::Good : key.empty() ? State::Missing : State::Broken, 0};
  }
  if (changed) watch();
}

void MapWatcher::watch() {
  QStringList wanted;
  for (const auto& [path, file] : m_files) {
    const QFileInfo info(QString::fromStdString(path));
    if (info.exists()) wanted << info.filePath();
    for (const UdimTile& tile : udimTiles(path))
      if (const QString one = QString::fromStdString(tile.file.string()); !wanted.contains(one)) wanted << one;
    if (QFileInfo::exists(info.path()) && !wanted.contains(info.path())) wanted << info.path();
  }
  const QStringList now = m_watcher.files() + m_watcher.directories();
  QStringList gone, added;
  for (const QString& path : now)
    if (!wanted.contains(path)) gone << path;
  for (const QString& path : wanted)
    if (!now.contains(path)) added << path;
  if (!gone.isEmpty()) m_watcher.removePaths(gone);
  if (!added.isEmpty()) m_watcher.addPaths(added);
}

void MapWatcher::look() {
  bool again = false, told = false;
  for (auto& [path, file] : m_files) {
    const std::string key = AssetCache::mapKey(path);
    const bool settled = key == file.seenKey;
    file.seenKey = key;
    if (key.empty()) {
      told = told || file.state != State::Missing;
      file.state = State::Missing;
      file.readKey.clear();
      continue;
    }
    if (key == file.readKey && (file.failures == 0 || file.failures >= kAttempts)) continue;
    if (!settled) {
      again = true;
      continue;
    }
    if (key != file.readKey) file.failures = 0;
    file.readKey = key;
    m_loading.rereadMap(path, file.failures + 1 == kAttempts);
  }
  watch();  // a replaced file has lost its watch
  if (again) m_soon.start();
  if (told) Q_EMIT stateChanged();
}

void MapWatcher::takeResult(const QString& path, bool good) {
  const auto file = m_files.find(path.toStdString());
  if (file == m_files.end()) return;
  const State before = file->second.state;
  file->second.failures = good ? 0 : file->second.failures + 1;
  if (good) file->second.state = State::Good;
  // It may still be being written, without a change of its size or time yet.
  if (!good && file->second.failures < kAttempts) m_soon.start();
  if (!good && file->second.failures >= kAttempts) file->second.state = State::Broken;
  if (file->second.state != before) Q_EMIT stateChanged();
}

}  // namespace dermis
