// How long work still takes, guessed from how far it has come.
#pragma once

#include <QString>

namespace dermis {

class TimeLeft {
 public:
  /// Tells how far what is called `title` is, 0..1, `seconds` on any clock. A new title, or going back, starts anew.
  void update(const QString& title, double fraction, double seconds);
  /// Nothing to guess from.
  void clear() { m_title.clear(); }
  /// "about 40 s left"; empty while there is too little to go by.
  [[nodiscard]] QString text() const;

 private:
  QString m_title;
  double m_firstFraction = 0.0, m_firstSeconds = 0.0;
  double m_fraction = 0.0, m_seconds = 0.0;
};

}  // namespace dermis
