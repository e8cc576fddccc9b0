#include "ui/main_window/keep_on_screen.h"

#include <QScreen>
#include <QWidget>
#include <algorithm>

namespace dermis {

void keepOnScreen(QWidget& window) {
  if ((window.windowState() & (Qt::WindowMaximized | Qt::WindowFullScreen | Qt::WindowMinimized)) != 0) return;
  const QRect screen = window.screen()->availableGeometry(), frame = window.frameGeometry();
  // Somebody may spread a window over several screens.
  if (window.screen()->availableVirtualGeometry().contains(frame)) return;
  const QSize border = frame.size() - window.size();
  window.resize(window.size().boundedTo(screen.size() - border));
  const QSize size = window.size() + border;
  const auto within = [](int at, int from, int most) { return std::clamp(at, from, std::max(most, from)); };
  window.move(within(frame.x(), screen.x(), screen.x() + screen.width() - size.width()),
              within(frame.y(), screen.y(), screen.y() + screen.height() - size.height()));
}

}  // namespace dermis
