// The look of the chrome: neutral greys, because colour is judged beside it; the accent only marks focus and selection.
#pragma once

#include <functional>

class QApplication;

namespace dermis {

/// System: dark where the desktop's own colours are dark, also when they change.
enum class ThemeChoice { Dark, Light, System };

/// Sets style, palette, font and style sheet of the whole program; may be called again.
void applyTheme(QApplication& application, ThemeChoice choice = ThemeChoice::Dark);
/// For tests: what is asked whether the desktop is dark; empty: its palette.
void setSystemDarkProbe(std::function<bool()> probe);

}  // namespace dermis
