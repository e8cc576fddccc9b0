#include "ui/document/autosave.h"

#include <QDateTime>
#include <QUuid>
#include <algorithm>

#include "ui/jobs/task_runner.h"
#include "ui/text.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".dermis";

fs::path lockOf(const fs::path& file) { return fs::path(file).replace_extension(".lock"); }

}  // namespace

std::vector<LostWork> findLostWork(const fs::path& folder, Warnings& warnings) {
  std::vector<LostWork> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::path& path = entry.path();
    // A name that begins with a dot is a temporary file of a writer that was stopped.
    if (path.extension() != kEnding || path.filename().string().starts_with('.')) continue;
    std::optional<FileLock> lock = FileLock::tryLock(lockOf(path));
    if (!lock) continue;
    if (!fs::exists(path, error)) {  // its owner has just put it away
      lock->removeFile();
      continue;
    }
    Result<Recovery> recovery = loadRecovery(path, warnings);
    if (!recovery) {
      warnings.push_back(recovery.error().message);
      continue;
    }
    found.push_back({path, std::move(*recovery), std::make_shared<FileLock>(std::move(*lock))});
  }
  std::ranges::sort(found, std::ranges::greater(), [](const LostWork& w) { return w.recovery.savedAtMilliseconds; });
  return found;
}

void discardLostWork(const LostWork& work) {
  std::error_code ignored;
  fs::remove(work.path, ignored);
  if (work.lock) work.lock->removeFile();
}

Autosave::Autosave(Document& document, fs::path folder, QObject* parent)
    : QObject(parent), m_document(document), m_folder(std::move(folder)) {
  m_pool.setMaxThreadCount(1);
  m_timer.setSingleShot(true);
  connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
  connect(&m_document, &Document::changed, this, [this] {
    if (m_document.isModified()) schedule();
  });
  // An edit that makes the document modified tells of its change before it tells of that.
  connect(&m_document, &Document::titleChanged, this, &Autosave::refreshModified);
}

Autosave::~Autosave() { m_pool.waitForDone(); }

void Autosave::refreshModified() {
  if (m_document.isModified())
    schedule();
  else
    discard();
}

void Autosave::schedule() {
  m_dirty = true;
  // Not started anew by every edit: a hand that never rests is saved too.
  if (!m_timer.isActive() && !m_writing) m_timer.start(m_intervalMs);
}

Result<void> Autosave::takeFile() {
  if (m_lock) return {};
  std::error_code error;
  fs::create_directories(m_folder, error);
  m_file = m_folder / (QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString() + kEnding);
  std::optional<FileLock> lock = FileLock::tryLock(lockOf(m_file));
  if (!lock) return runtimeError(m_folder.string() + " cannot be written; check the disk and who owns the folder");
  m_lock = std::make_shared<FileLock>(std::move(*lock));
  return {};
}

void Autosave::write() {
  m_dirty = false;
  if (const Result<void> taken = takeFile(); !taken) {
    finished(taken);
    return;
  }
  m_writing = true;
  Recovery recovery{m_document.sceneForSaving(), m_document.path(), QDateTime::currentMSecsSinceEpoch()};
  m_pool.start([this, file = m_file, recovery = std::move(recovery)] {
    const Result<void> result = [&]() -> Result<void> {
      try {
        return saveRecovery(file, recovery);
      } catch (const std::exception& error) {
        return runtimeError(file.string() + " could not be written: " + reasonOf(error));
      }
    }();
    QMetaObject::invokeMethod(
        this,
        [this, result] {
          m_writing = false;
          finished(result);
        },
        Qt::QueuedConnection);
  });
}

void Autosave::finished(const Result<void>& result) {
  if (!result) {
    if (!m_failed)
      Q_EMIT message(MessageKind::Error,
                     tr("Unsaved work cannot be kept safe: %1. Save the scene elsewhere; the editor goes on trying.")
                         .arg(text(result.error().message)));
    m_dirty = true;
  } else {
    if (m_failed) Q_EMIT message(MessageKind::Info, tr("Unsaved work is kept safe again."));
    Q_EMIT written();
  }
  m_failed = !result;
  if (!m_document.isModified())
    discard();
  else if (m_dirty && !m_timer.isActive())
    m_timer.start(m_intervalMs);
}

void Autosave::adopt(LostWork work) {
  discard();
  m_file = std::move(work.path);
  m_lock = std::move(work.lock);
  if (m_document.isModified()) schedule();
}

void Autosave::discard() {
  m_timer.stop();
  m_dirty = false;
  if (m_writing) m_pool.waitForDone();
  removeFile();
}

void Autosave::removeFile() {
  if (!m_lock) return;
  std::error_code ignored;
  fs::remove(m_file, ignored);
  m_lock->removeFile();
  m_lock.reset();
  m_file.clear();
}

}  // namespace dermis
