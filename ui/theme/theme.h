// The look of the chrome: neutral mid-dark grey, because colour is judged beside it; the accent only marks focus and
// selection.
#pragma once

class QApplication;

namespace dermis {

/// Sets style, palette, font and style sheet of the whole program.
void applyTheme(QApplication& application);

}  // namespace dermis
