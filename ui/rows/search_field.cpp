#include "ui/rows/search_field.h"

#include <QAbstractButton>
#include <QKeyEvent>

#include "ui/theme/icons.h"

namespace dermis {

SearchField::SearchField(const QString& name, const QString& id, QWidget* parent) : QLineEdit(parent) {
  setObjectName(id);
  setAccessibleName(name);
  setPlaceholderText(name);
  setToolTip(tr("%1; Esc empties it").arg(name));
  setClearButtonEnabled(true);
  addAction(themeIcon("search"), QLineEdit::LeadingPosition)->setText(name);
  // Qt gives the buttons inside a line edit no name.
  for (QAbstractButton* button : findChildren<QAbstractButton*>())
    if (button->text().isEmpty()) button->setAccessibleName(tr("%1: empty the field").arg(name));
}

void SearchField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && !text().isEmpty())
    clear();
  else
    QLineEdit::keyPressEvent(event);
}

}  // namespace dermis
