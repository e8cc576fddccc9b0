#include "ui/main_window/layouts.h"

#include <QInputDialog>
#include <QMenu>
#include <QSettings>

#include "ui/main_window/dock_layout.h"

namespace dermis {
namespace {
const QString kGroup = QStringLiteral("layouts");

/// Any text as a key of the settings: a slash would be a group.
QString keyOf(const QString& name) { return kGroup + QLatin1Char('/') + QString::fromLatin1(name.toUtf8().toHex()); }
}  // namespace

Layouts::Layouts(DockLayout& docks, QWidget* window) : QObject(window), m_docks(docks), m_window(window) {}

QStringList Layouts::names() {
  QSettings settings;
  settings.beginGroup(kGroup);
  QStringList names;
  for (const QString& key : settings.childKeys()) names << QString::fromUtf8(QByteArray::fromHex(key.toLatin1()));
  names.sort(Qt::CaseInsensitive);
  return names;
}

void Layouts::save(const QString& name) { QSettings().setValue(keyOf(name), m_docks.state()); }

void Layouts::use(const QString& name) { m_docks.setState(QSettings().value(keyOf(name)).toByteArray()); }

void Layouts::remove(const QString& name) { QSettings().remove(keyOf(name)); }

void Layouts::askName() {
  bool agreed = false;
  const QString name =
      QInputDialog::getText(m_window, tr("Save layout"), tr("Name of the layout"), QLineEdit::Normal, {}, &agreed)
          .simplified();
  if (agreed && !name.isEmpty()) save(name);
}

void Layouts::fillMenu(QMenu* menu) {
  QMenu* layouts = menu->addMenu(tr("&Layouts"));
  layouts->setProperty("changing", true);
  connect(layouts, &QMenu::aboutToShow, this, [this, layouts] {
    layouts->clear();
    for (const QString& name : names())
      connect(layouts->addAction(name), &QAction::triggered, this, [this, name] { use(name); });
    if (layouts->isEmpty()) layouts->addAction(tr("None saved yet"))->setEnabled(false);
    layouts->addSeparator();
    connect(layouts->addAction(tr("&Save layout…")), &QAction::triggered, this, &Layouts::askName);
    QMenu* remove = layouts->addMenu(tr("&Delete"));
    remove->setEnabled(!names().isEmpty());
    for (const QString& name : names())
      connect(remove->addAction(name), &QAction::triggered, this, [name] { Layouts::remove(name); });
  });
}

}  // namespace dermis
