// Numbers as people type them: comma or point, with a unit.
#pragma once

#include <QString>
#include <optional>

namespace dermis {

/// The number in a text such as "0,45", " 1.2 mm", "0.5 cm", "1.234,5" or "3e-2", in units of `unit` (empty: a plain
/// number, where "45 %" is 0.45). Nothing where there is no number, or where its unit measures something else.
[[nodiscard]] std::optional<double> parseNumber(const QString& text, const QString& unit = {});

}  // namespace dermis
