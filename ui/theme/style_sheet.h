// The style sheet: shapes and spacing; the colours follow theme.cpp's palette.
#pragma once

#include <QString>

namespace dermis {

[[nodiscard]] QString styleSheet(bool dark);

}  // namespace dermis
