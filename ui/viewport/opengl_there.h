// Whether there is OpenGL for a window at all.
#pragma once

#include <QString>

namespace dermis {

/// Why no viewport can be made on this display, in one sentence; empty where one can. To be asked before there is one:
/// Qt 6.4 shows no window around an OpenGL widget that gets no context, it dereferences null.
[[nodiscard]] QString openGlProblem();

}  // namespace dermis
