// A window with its frame where it can be seen.
#pragma once

class QWidget;

namespace dermis {

/// Makes a window smaller and moves it until its frame lies within its screen; what fits, or fills the screen, stays.
void keepOnScreen(QWidget& window);

}  // namespace dermis
