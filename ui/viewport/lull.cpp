#include "ui/viewport/lull.h"

#include <QAbstractEventDispatcher>
#include <algorithm>

namespace dermis {
namespace {

constexpr double kShare = 0.125;
constexpr int kLongestMs = 40;
constexpr int kOwnWakes = 3;  // the timer, the picture that has just been composed, another timer

}  // namespace

Lull::Lull(QObject* parent) : QObject(parent) {
  m_timer.setSingleShot(true);
  connect(&m_timer, &QTimer::timeout, this, &Lull::elapsed);
  connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::awake, this, [this] { ++m_wakes; });
}

void Lull::start(double pictureMs) {
  m_pictureMs = pictureMs;
  // The picture that asks is not on the screen yet, and what composes it may take longer than the lull.
  const auto begin = [this] {
    m_since.start();
    m_wakes = 0;
    m_timer.start(std::min(static_cast<int>(kShare * m_pictureMs), kLongestMs));
  };
  QTimer::singleShot(0, this, begin);
}

void Lull::elapsed() {
  if (m_wakes > kOwnWakes && static_cast<double>(m_since.elapsed()) < m_pictureMs) {
    m_wakes = 0;
    m_timer.start();
  } else {
    Q_EMIT quiet();
  }
}

}  // namespace dermis
