#include "ui/rows/search_field.h"

#include <QKeyEvent>

#include "ui/theme/icons.h"

namespace dermis {

SearchField::SearchField(const QString& name, const QString& id, QWidget* parent) : QLineEdit(parent) {
  setObjectName(id);
  setAccessibleName(name);
  setPlaceholderText(name);
  setToolTip(tr("%1; Esc empties it").arg(name));
  setClearButtonEnabled(true);
  addAction(themeIcon("search"), QLineEdit::LeadingPosition);
}

void SearchField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && !text().isEmpty())
    clear();
  else
    QLineEdit::keyPressEvent(event);
}

}  // namespace dermis
