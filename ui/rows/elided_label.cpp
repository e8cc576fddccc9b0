#include "ui/rows/elided_label.h"

namespace dermis {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setMinimumWidth(40);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  setTextFormat(Qt::PlainText);
}

void ElidedLabel::setFullText(const QString& text) {
  m_full = text;
  setAccessibleName(text);
  fit();
}

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit();
}

void ElidedLabel::fit() { setText(fontMetrics().elidedText(m_full, Qt::ElideMiddle, width())); }

}  // namespace dermis
