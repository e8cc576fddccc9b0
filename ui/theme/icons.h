// The icons: simple strokes on a 16 × 16 grid, drawn in the colour of the text around them.
#pragma once

#include <QIcon>

namespace dermis {

/// The icon of resources/icons/NAME.svg; an empty one where there is none.
[[nodiscard]] QIcon themeIcon(const char* name);

}  // namespace dermis
