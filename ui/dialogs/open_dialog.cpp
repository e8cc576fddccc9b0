#include "ui/dialogs/open_dialog.h"

#include <QDialog>

namespace dermis {

void openDialog(QDialog* dialog) {
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

}  // namespace dermis
