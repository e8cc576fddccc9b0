#include "ui/preferences/shortcuts.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

namespace dermis {
namespace {

QString settingsKey(const QString& id) { return QStringLiteral("shortcuts/") + id; }

/// "&Save scene as…\tCtrl" → "Save scene as".
QString plainLabel(QString label) {
  label = label.section(QLatin1Char('\t'), 0, 0);
  label.replace(QStringLiteral("&&"), QStringLiteral("\x01")).remove(QLatin1Char('&'));
  label.replace(QLatin1Char('\x01'), QLatin1Char('&'));
  return label.remove(QStringLiteral("…"));
}

}  // namespace

void Shortcuts::collect(QMenuBar* menus) {
  for (const QAction* top : menus->actions())
    if (top->menu() != nullptr) collect(top->menu(), plainLabel(top->text()));
}

void Shortcuts::collect(const QMenu* menu, const QString& path) {
  if (menu->property("changing").toBool()) return;
  for (QAction* action : menu->actions()) {
    const QString label = plainLabel(action->text());
    if (action->menu() != nullptr) {
      collect(action->menu(), path + QStringLiteral(" › ") + label);
      continue;
    }
    if (action->isSeparator() || label.isEmpty()) continue;
    Entry entry;
    entry.id = action->objectName();
    entry.menu = path;
    entry.label = label;
    entry.action = action;
    entry.standard = action->shortcuts();
    m_entries << entry;
    const QVariant stored = QSettings().value(settingsKey(entry.id));
    if (stored.isValid())
      action->setShortcuts({QKeySequence::fromString(stored.toString(), QKeySequence::PortableText)});
  }
}

bool Shortcuts::isChanged(const Entry& entry) const {
  return entry.action && entry.action->shortcuts() != entry.standard;
}

QString Shortcuts::ownerOf(const QKeySequence& keys, const QAction* except) const {
  if (keys.isEmpty()) return {};
  if (const auto reserved = m_reserved.find(keys); reserved != m_reserved.end()) return *reserved;
  for (const Entry& entry : m_entries) {
    if (!entry.action || entry.action == except) continue;
    for (const QKeySequence& other : entry.action->shortcuts())
      // "Ctrl+K" would keep "Ctrl+K, S" from ever being heard.
      if (other.matches(keys) != QKeySequence::NoMatch || keys.matches(other) != QKeySequence::NoMatch)
        return entry.label;
  }
  return {};
}

QString Shortcuts::set(const Entry& entry, const QKeySequence& keys) {
  if (!entry.action) return {};
  if (const QString owner = ownerOf(keys, entry.action); !owner.isEmpty())
    return tr("%1 belongs to “%2” already; give that one other keys first.")
        .arg(keys.toString(QKeySequence::NativeText), owner);
  entry.action->setShortcuts(keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys});
  store(entry);
  Q_EMIT changed();
  return {};
}

QString Shortcuts::reset(const Entry& entry) {
  if (!entry.action) return {};
  for (const QKeySequence& keys : entry.standard)
    if (const QString owner = ownerOf(keys, entry.action); !owner.isEmpty())
      return tr("%1 belongs to “%2” now; reset that one first.").arg(keys.toString(QKeySequence::NativeText), owner);
  entry.action->setShortcuts(entry.standard);
  store(entry);
  Q_EMIT changed();
  return {};
}

void Shortcuts::resetAll() {
  for (const Entry& entry : m_entries) {
    if (entry.action) entry.action->setShortcuts(entry.standard);
    QSettings().remove(settingsKey(entry.id));
  }
  Q_EMIT changed();
}

void Shortcuts::store(const Entry& entry) {
  QSettings settings;
  if (isChanged(entry))
    settings.setValue(settingsKey(entry.id), entry.action->shortcut().toString(QKeySequence::PortableText));
  else
    settings.remove(settingsKey(entry.id));
}

}  // namespace dermis
