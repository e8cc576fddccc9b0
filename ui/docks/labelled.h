// A quiet label before a control, in the panels' columns: for controls that aren't values of the table.
#pragma once

#include <QWidget>

namespace dermis {

[[nodiscard]] QWidget* labelled(const QString& label, QWidget* control, QWidget* parent);

}  // namespace dermis
