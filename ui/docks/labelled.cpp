#include "ui/docks/labelled.h"

#include <QHBoxLayout>
#include <QLabel>

#include "ui/theme/metrics.h"

namespace dermis {

QWidget* labelled(const QString& label, QWidget* control, QWidget* parent) {
  auto* row = new QWidget(parent);
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(metrics::kDotWidth, 0, 0, 0);
  line->setSpacing(0);
  auto* name = new QLabel(label, row);
  name->setFixedSize(metrics::kLabelWidth, metrics::kControlHeight);
  name->setBuddy(control);
  control->setParent(row);
  line->addWidget(name);
  line->addWidget(control, 1);
  return row;
}

}  // namespace dermis
