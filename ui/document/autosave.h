// Unsaved work is kept in a file of its own while it is unsaved, written beside the event loop.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/file_lock.h"
#include "core/scene/recovery_io.h"
#include "ui/document/loading.h"

namespace dermis {

/// What an editor that is gone left behind. Whoever holds this holds its lock: no other editor offers it.
struct LostWork {
  std::filesystem::path path;
  Recovery recovery;
  std::shared_ptr<FileLock> lock;
};

/// Latest first. Files of editors that still run are passed over, those that can't be read told of in `warnings`.
[[nodiscard]] std::vector<LostWork> findLostWork(const std::filesystem::path& folder, Warnings& warnings);
/// Deletes it for good.
void discardLostWork(const LostWork& work);

/// Each editor writes a file of its own in the folder and holds a lock beside it.
class Autosave : public QObject {
  Q_OBJECT
 public:
  static constexpr int kDefaultIntervalMs = 2000;

  Autosave(Document& document, std::filesystem::path folder, QObject* parent = nullptr);
  /// Waits for what is being written and leaves it there: only discard() says that nothing is needed any more.
  ~Autosave() override;

  void setIntervalMs(int milliseconds) { m_intervalMs = milliseconds; }
  /// Goes on in the file of lost work that the document now holds.
  void adopt(LostWork work);
  /// The work is saved or given up: the file goes.
  void discard();
  /// Where the work is kept; empty while there is nothing unsaved.
  [[nodiscard]] std::filesystem::path file() const { return m_lock ? m_file : std::filesystem::path(); }

 Q_SIGNALS:
  void message(dermis::MessageKind kind, const QString& sentence);
  /// A complete file has been written.
  void written();

 private:
  void schedule();
  void refreshModified();
  void write();
  void finished(const Result<void>& result);
  Result<void> takeFile();
  void removeFile();

  Document& m_document;
  std::filesystem::path m_folder;
  std::filesystem::path m_file;
  std::shared_ptr<FileLock> m_lock;
  QThreadPool m_pool;
  QTimer m_timer;
  int m_intervalMs = kDefaultIntervalMs;
  bool m_dirty = false;
  bool m_writing = false;
  bool m_failed = false;  ///< said so already
};

}  // namespace dermis
