// Thumbnails of presets, drawn by the program itself (`dermis thumbnails`) in a process of low priority, kept on disk.
#pragma once

#include <QImage>
#include <QObject>
#include <QProcess>
#include <QSet>
#include <QTimer>
#include <deque>
#include <functional>
#include <vector>

#include "ui/browse/preset_library.h"

namespace dermis {

class ThumbnailMaker : public QObject {
  Q_OBJECT
 public:
  static constexpr int kSide = 128;
  /// So long after the last change nothing is begun: who types a name or starts the program comes first.
  static constexpr int kWaitMs = 1500;

  static constexpr int kYieldMs = 1000;

  explicit ThumbnailMaker(QObject* parent = nullptr);
  ~ThumbnailMaker() override;

  /// Null where there is none yet.
  [[nodiscard]] QImage find(const PresetEntry& entry) const;
  /// The keys that this names come before the others. Asked each time that some are begun.
  void preferShown(std::function<QSet<QString>()> shown) { m_shown = std::move(shown); }
  /// Those without a thumbnail are drawn, in this order; what waited before is forgotten.
  void want(const std::vector<PresetEntry>& entries);
  void cancel();
  /// While held nothing is drawn: the editor's own loading and baking come first.
  void hold(bool held);
  /// Something is being edited: what is being drawn stands still until kYieldMs after the last call. Its pictures would
  /// come half as often on software OpenGL, whatever the priority.
  void yield();
  /// Off: what is there is shown, nothing is drawn.
  void setEnabled(bool enabled);
  [[nodiscard]] int waiting() const { return static_cast<int>(m_queue.size() + m_current.size()); }

 Q_SIGNALS:
  void made(const QString& key);
  /// `waiting` is 0 when all are drawn.
  void progressed(int done, int waiting);

 private:
  struct Order {
    QString key, path;
  };
  void next();
  void readMade();
  void finished(bool crashed);
  [[nodiscard]] bool isBeingDrawn(const QString& key) const;
  void signalProcess(int signal);

  QString m_folder;
  QString m_program;
  std::function<QSet<QString>()> m_shown;
  std::deque<Order> m_queue;
  std::vector<Order> m_current;  ///< asked of the process and not there yet
  QSet<QString> m_failed;
  QProcess m_process{this};
  QTimer m_later;
  QTimer m_yielding;
  int m_done = 0;
  bool m_enabled = true;
  bool m_held = false;
};

}  // namespace dermis
