// Numbers as people type them: comma or point, with a unit. What the program shows has a point in every locale, as in
// files and papers: what is read in one place can be typed in another.
#pragma once

#include <QString>
#include <optional>

namespace dermis {

/// The number in a text such as "0,45", " 1.2 mm", "0.5 cm", "1.234,5" or "3e-2", in units of `unit` (empty: a plain
/// number, where "45 %" is 0.45). Nothing where there is no number, or where its unit measures something else.
[[nodiscard]] std::optional<double> parseNumber(const QString& text, const QString& unit = {});

/// "1 234 567": a comma or a point between groups would be a decimal sign to somebody.
[[nodiscard]] QString groupedNumber(quint64 number);

}  // namespace dermis
