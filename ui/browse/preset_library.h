// The presets there are: those that the program carries, and the files of watched folders.
#pragma once

#include <QFileSystemWatcher>
#include <QHash>
#include <QImage>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <vector>

#include "core/base/result.h"
#include "core/material/material.h"
#include "ui/jobs/task_runner.h"

namespace dermis {

/// Where the user's presets are kept; made when it is first needed.
[[nodiscard]] QString userPresetFolder();

struct PresetEntry {
  static constexpr int kBall = 96;
  QString path;  ///< "builtin:NAME", or a file
  QString name;
  Material material;
  QStringList tags;  ///< the shading model, whose it is, and what its metadata say
  QString key;       ///< of all that makes its thumbnail: content, maps, version
  QImage ball;       ///< stands in for its thumbnail; of what is read beside the event loop
  [[nodiscard]] bool isBuiltin() const;
};

class PresetLibrary : public QObject {
  Q_OBJECT
 public:
  explicit PresetLibrary(QObject* parent = nullptr);
  /// Beside the user's own. All of them are read; `changed` tells when they are there.
  void setFolders(const QStringList& folders);
  [[nodiscard]] bool isReading() const { return m_tasks.busy(); }
  [[nodiscard]] const std::vector<PresetEntry>& entries() const { return m_entries; }
  /// Null where there is none.
  [[nodiscard]] const PresetEntry* find(const QString& path) const;
  [[nodiscard]] QStringList tags() const;

  // What is done with files. Each tells in one sentence what went wrong.
  /// A copy among the user's presets; returns its path.
  Result<QString> duplicate(const PresetEntry& entry);
  /// Gives preset and file another name; returns the new path.
  Result<QString> rename(const PresetEntry& entry, const QString& name);
  Result<void> setTags(const PresetEntry& entry, const QStringList& tags);
  Result<void> moveToTrash(const PresetEntry& entry);

 public Q_SLOTS:
  /// Reads the folders again, beside the event loop; files that have not changed since are not read.
  void refresh();

 Q_SIGNALS:
  void changed();
  void problem(const QString& sentence);
  /// A preset has another file and name, or other tags.
  void rewritten(const QString& from, const QString& to, const dermis::Material& before, const dermis::Material& after);

 private:
  using Known = QHash<QString, PresetEntry>;
  /// What lies in the folders.
  struct Found {
    std::vector<PresetEntry> entries;
    QStringList watched;
    Known known;
  };
  [[nodiscard]] static Found read(const QStringList& folders, const Known& known, const std::stop_token& stop);
  void take(Found found);
  void watch(const QStringList& paths);
  /// In place of the entry of that path, or at the end; the next reading finds its place.
  void put(const QString& path, PresetEntry entry);

  QStringList m_folders;
  std::vector<PresetEntry> m_entries;
  Known m_known;  ///< by path, modification time and size
  QFileSystemWatcher m_watcher;
  QTimer m_soon;
  TaskRunner m_tasks;
};

}  // namespace dermis
