#include "ui/jobs/time_left.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace dermis {

void TimeLeft::update(const QString& title, double fraction, double seconds) {
  if (title != m_title || fraction < m_fraction) {
    m_title = title;
    m_firstFraction = fraction;
    m_firstSeconds = seconds;
  }
  m_fraction = fraction;
  m_seconds = seconds;
}

QString TimeLeft::text() const {
  constexpr double kSecondsToWatch = 1.5, kShareToSee = 0.03;
  const double watched = m_seconds - m_firstSeconds;
  const double done = m_fraction - m_firstFraction;
  if (m_title.isEmpty() || watched < kSecondsToWatch || done < kShareToSee) return {};
  const double left = watched * (1.0 - m_fraction) / done;
  const auto words = [](const char* sentence, double number) {
    return QCoreApplication::translate("TimeLeft", sentence).arg(static_cast<int>(number));
  };
  // Rounded up, and coarser the longer it takes: a number that jumps is no help.
  if (left < 10.0) return words(QT_TRANSLATE_NOOP("TimeLeft", "about %1 s left"), std::ceil(std::max(left, 1.0)));
  if (left < 90.0) return words(QT_TRANSLATE_NOOP("TimeLeft", "about %1 s left"), 5.0 * std::ceil(left / 5.0));
  return words(QT_TRANSLATE_NOOP("TimeLeft", "about %1 min left"), std::ceil(left / 60.0));
}

}  // namespace dermis
