// Whether there is OpenGL for a window at all, and how its pictures best get there.
#pragma once

#include <QString>

#include "ui/viewport/gl_widget.h"

namespace dermis {

/// Why no viewport can be made on this display, in one sentence; empty where one can. To be asked before there is one:
/// Qt 6.4 shows no window around an OpenGL widget that gets no context, it dereferences null.
[[nodiscard]] QString openGlProblem();

/// Copied where OpenGL is software, composed elsewhere; DERMIS_HOSTING=copied or =composed stands above that.
[[nodiscard]] Hosting hostingHere();

}  // namespace dermis
