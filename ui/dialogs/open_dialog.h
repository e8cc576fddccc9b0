// How dialogs come up.
#pragma once

class QDialog;

namespace dermis {

/// Shows a dialog over its window and deletes it when it is closed. Whoever asked for it gets an answer at once: a
/// screen reader's press on a menu would wait for the dialog's end otherwise.
void openDialog(QDialog* dialog);

}  // namespace dermis
