#include "ui/preferences/list_keys.h"

#include <QAction>
#include <QCoreApplication>
#include <QWidget>

#include "ui/preferences/shortcuts.h"

namespace dermis {
namespace {

QAction* keyOf(QWidget* list, const QString& id, const QString& label, const QKeySequence& keys) {
  auto* action = new QAction(label, list);
  action->setObjectName(id);
  action->setShortcut(keys);
  action->setShortcutContext(Qt::WidgetShortcut);
  list->addAction(action);
  Shortcuts::list(action, QCoreApplication::translate("ListKeys", "In lists"));
  return action;
}

}  // namespace

QAction* renameKey(QWidget* list) {
  return keyOf(list, QStringLiteral("list.rename"), QCoreApplication::translate("ListKeys", "Rename"),
               QKeySequence(Qt::Key_F2));
}

QAction* duplicateKey(QWidget* list) {
  return keyOf(list, QStringLiteral("list.duplicate"), QCoreApplication::translate("ListKeys", "Duplicate"),
               QKeySequence(QStringLiteral("Ctrl+D")));
}

QAction* removeKey(QWidget* list) {
  return keyOf(list, QStringLiteral("list.remove"), QCoreApplication::translate("ListKeys", "Remove"),
               QKeySequence(QKeySequence::Delete));
}

}  // namespace dermis
