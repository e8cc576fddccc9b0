// The look of the chrome: neutral greys, because colour is judged beside it; the accent only marks focus and selection.
#pragma once

class QApplication;

namespace dermis {

/// System: dark where the desktop's own colours were dark when the program started.
enum class ThemeChoice { Dark, Light, System };

/// Sets style, palette, font and style sheet of the whole program; may be called again.
void applyTheme(QApplication& application, ThemeChoice choice = ThemeChoice::Dark);

}  // namespace dermis
