// What the tip and "What is this?" of a row say that is not in the parameter table.
#pragma once

#include <QString>

namespace dermis {

class PropertyRow;

/// `meaning` is a sentence or two; the range and unit of the row's own editor are added, and its id.
void setRowHelp(PropertyRow& row, const QString& meaning);

}  // namespace dermis
