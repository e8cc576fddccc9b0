// A window with its frame where it can be seen.
#pragma once

class QWidget;

namespace dermis {

/// Where a window's frame reaches beyond all screens, makes it smaller and moves it until it lies within its own; what
/// is maximised stays.
void keepOnScreen(QWidget& window);

}  // namespace dermis
