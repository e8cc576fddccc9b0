#include "ui/theme/strips.h"

#include <QFrame>
#include <QVBoxLayout>

namespace dermis {

QVBoxLayout* flushColumn(QWidget* owner) {
  auto* column = new QVBoxLayout(owner);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  return column;
}

QFrame* toolStrip(QWidget* parent) {
  auto* strip = new QFrame(parent);
  strip->setProperty("toolStrip", true);
  return strip;
}

}  // namespace dermis
