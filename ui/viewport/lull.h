// When the next sample of a resting picture is drawn: as soon as nobody else needs the event loop.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace dermis {

/// On software GL a sample takes up to seconds. Without a lull between two of them each question of a screen reader,
/// and each move of the pointer, would wait for one.
class Lull : public QObject {
  Q_OBJECT
 public:
  explicit Lull(QObject* parent = nullptr);
  /// Waits an eighth of what a picture takes, and as long as the event loop is in use, but no longer than a picture.
  void start(double pictureMs);

 Q_SIGNALS:
  void quiet();

 private:
  void elapsed();

  QTimer m_timer;
  QElapsedTimer m_since;
  double m_pictureMs = 0.0;
  int m_wakes = 0;  ///< of the event loop, since the timer was started
};

}  // namespace dermis
