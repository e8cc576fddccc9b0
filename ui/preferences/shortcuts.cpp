#include "ui/preferences/shortcuts.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <algorithm>

namespace dermis {
namespace {

constexpr const char* kHeading = "shortcutHeading";
constexpr const char* kFlying = "shortcutWhileFlying";

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
    if (!action->isSeparator() && !label.isEmpty()) take(action, path);
  }
}

void Shortcuts::take(QAction* action, const QString& heading) {
  Entry entry;
  entry.id = action->objectName();
  entry.menu = heading;
  entry.label = plainLabel(action->text());
  entry.action = action;
  entry.standard = action->shortcuts();
  entry.whileFlying = action->property(kFlying).toBool();
  m_entries << entry;
  const QVariant stored = QSettings().value(settingsKey(entry.id));
  if (stored.isValid()) action->setShortcuts({QKeySequence::fromString(stored.toString(), QKeySequence::PortableText)});
}

void Shortcuts::list(QAction* action, const QString& heading, bool whileFlying) {
  action->setProperty(kHeading, heading);
  action->setProperty(kFlying, whileFlying);
}

void Shortcuts::collectLoose(const QWidget& window) {
  for (QAction* action : window.findChildren<QAction*>()) {
    const QString heading = action->property(kHeading).toString();
    if (heading.isEmpty()) continue;
    const auto same = std::ranges::find(m_entries, action->objectName(), &Entry::id);
    if (same == m_entries.end()) {
      take(action, heading);
    } else {
      same->others << action;
      action->setShortcuts(same->action->shortcuts());
    }
  }
}

bool Shortcuts::isChanged(const Entry& entry) const {
  return entry.action && entry.action->shortcuts() != entry.standard;
}

QString Shortcuts::ownerOf(const QKeySequence& keys, const Entry& except) const {
  if (keys.isEmpty()) return {};
  for (const Entry& entry : m_entries) {
    if (!entry.action || entry.id == except.id || entry.whileFlying != except.whileFlying) continue;
    for (const QKeySequence& other : entry.action->shortcuts())
      // "Ctrl+K" would keep "Ctrl+K, S" from ever being heard.
      if (other.matches(keys) != QKeySequence::NoMatch || keys.matches(other) != QKeySequence::NoMatch)
        return entry.label;
  }
  return {};
}

QString Shortcuts::set(const Entry& entry, const QKeySequence& keys) {
  if (!entry.action) return {};
  if (const QString owner = ownerOf(keys, entry); !owner.isEmpty())
    return tr("%1 belongs to “%2” already; give that one other keys first.")
        .arg(keys.toString(QKeySequence::NativeText), owner);
  apply(entry, keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys});
  store(entry);
  Q_EMIT changed();
  return {};
}

QString Shortcuts::reset(const Entry& entry) {
  if (!entry.action) return {};
  for (const QKeySequence& keys : entry.standard)
    if (const QString owner = ownerOf(keys, entry); !owner.isEmpty())
      return tr("%1 belongs to “%2” now; reset that one first.").arg(keys.toString(QKeySequence::NativeText), owner);
  apply(entry, entry.standard);
  store(entry);
  Q_EMIT changed();
  return {};
}

void Shortcuts::resetAll() {
  for (const Entry& entry : m_entries) {
    if (entry.action) apply(entry, entry.standard);
    QSettings().remove(settingsKey(entry.id));
  }
  Q_EMIT changed();
}

void Shortcuts::apply(const Entry& entry, const QList<QKeySequence>& keys) {
  entry.action->setShortcuts(keys);
  for (const QPointer<QAction>& other : entry.others)
    if (other) other->setShortcuts(keys);
}

void Shortcuts::store(const Entry& entry) {
  QSettings settings;
  if (isChanged(entry))
    settings.setValue(settingsKey(entry.id), entry.action->shortcut().toString(QKeySequence::PortableText));
  else
    settings.remove(settingsKey(entry.id));
}

}  // namespace dermis
