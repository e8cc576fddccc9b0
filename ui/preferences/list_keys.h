// The keys that lists have in common: they rename and remove what is selected while the list has the focus.
#pragma once

class QAction;
class QWidget;

namespace dermis {

/// F2, or what a person made of it; the caller connects triggered().
[[nodiscard]] QAction* renameKey(QWidget* list);
/// Ctrl+D, or what a person made of it.
[[nodiscard]] QAction* duplicateKey(QWidget* list);
/// Delete, or what a person made of it.
[[nodiscard]] QAction* removeKey(QWidget* list);

}  // namespace dermis
