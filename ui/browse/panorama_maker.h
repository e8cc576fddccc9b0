// Thumbnails of environments, decoded or painted beside the event loop, kept on disk.
#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QThreadPool>
#include <atomic>

namespace dermis {

class PanoramaMaker : public QObject {
  Q_OBJECT
 public:
  PanoramaMaker(QSize size, QObject* parent = nullptr);
  /// Waits for the one that is being decoded.
  ~PanoramaMaker() override;

  /// Of a file, or of a light that the program carries, "builtin:NAME". Null where it has to be made first; made()
  /// follows, unless it can't be read.
  QImage find(const QString& environment);
  /// What is left waits no longer.
  void cancel();
  [[nodiscard]] int waiting() const { return m_waiting; }

 Q_SIGNALS:
  void made(const QString& environment);
  void progressed(int waiting);

 private:
  [[nodiscard]] QString cacheFile(const QString& environment) const;

  QSize m_size;
  QString m_folder;
  QThreadPool m_pool;
  QHash<QString, bool> m_asked;  ///< by the file's state: so that what can't be read is tried once
  std::atomic<int> m_round = 0;
  int m_waiting = 0;
};

}  // namespace dermis
