// The selected preset's file: copied, renamed, tagged, thrown away, and the menu for all that.
#include <QDesktopServices>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QUrl>

#include "ui/browse/preset_list.h"
#include "ui/docks/presets_panel.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/text.h"
#include "ui/theme/icons.h"

namespace dermis {

const PresetEntry* PresetsPanel::selected() const { return m_library.find(m_list->currentPath()); }

void PresetsPanel::tell(const Error& error) { Q_EMIT m_loading.message(MessageKind::Error, text(error.message)); }

void PresetsPanel::duplicateSelected() {
  const PresetEntry* entry = selected();
  if (entry == nullptr) return;
  const Result<QString> path = m_library.duplicate(*entry);
  if (!path) {
    tell(path.error());
    return;
  }
  select(*path);
}

void PresetsPanel::renameSelected(const QString& name) {
  const PresetEntry* entry = selected();
  if (entry == nullptr || entry->isBuiltin() || name.simplified().isEmpty()) return;
  const Result<QString> path = m_library.rename(*entry, name.simplified());
  if (!path)
    tell(path.error());
  else
    select(*path);
}

void PresetsPanel::setTagsOfSelected(const QStringList& tags) {
  const PresetEntry* entry = selected();
  if (entry == nullptr || entry->isBuiltin()) return;
  if (const Result<void> done = m_library.setTags(*entry, tags); !done) tell(done.error());
}

void PresetsPanel::trashSelected() {
  const PresetEntry* entry = selected();
  if (entry == nullptr || entry->isBuiltin()) return;
  const QString name = entry->name;
  if (const Result<void> done = m_library.moveToTrash(*entry); !done)
    tell(done.error());
  else
    Q_EMIT m_loading.message(MessageKind::Info, tr("%1 is in the trash").arg(name));
}

void PresetsPanel::askName() {
  const PresetEntry* entry = selected();
  if (entry == nullptr || entry->isBuiltin()) return;
  bool agreed = false;
  const QString name =
      QInputDialog::getText(this, tr("Rename preset"), tr("Name"), QLineEdit::Normal, entry->name, &agreed);
  if (agreed) renameSelected(name);
}

void PresetsPanel::askTags() {
  const PresetEntry* entry = selected();
  if (entry == nullptr || entry->isBuiltin()) return;
  bool agreed = false;
  // The first two say what is known without them.
  const QString tags = QInputDialog::getText(this, tr("Tags"), tr("Words, separated by commas"), QLineEdit::Normal,
                                             entry->tags.mid(2).join(QStringLiteral(", ")), &agreed);
  if (agreed) setTagsOfSelected(tags.split(QLatin1Char(',')));
}

void PresetsPanel::fillMenu(QMenu* menu) {
  const PresetEntry* entry = selected();
  if (entry == nullptr) return;
  const bool own = !entry->isBuiltin();
  const auto add = [&](const char* icon, const QString& label, auto slot, bool enabled) {
    QAction* action = menu->addAction(themeIcon(icon), label, this, slot);
    action->setEnabled(enabled);
  };
  add("check", tr("&Apply to %1").arg(m_document.editedSlots().join(QStringLiteral(", "))),
      &PresetsPanel::applySelected, true);
  QMenu* slots = menu->addMenu(tr("Apply to slo&t"));
  for (const QString& slot : m_document.slotNames())
    connect(slots->addAction(slot), &QAction::triggered, this,
            [this, slot, path = entry->path] { apply(path, {slot}); });
  menu->addSeparator();
  const auto compare = [&](const QString& label, const char* name, bool left) {
    QAction* action =
        menu->addAction(label, this, [this, left, path = entry->path] { Q_EMIT compareRequested(path, left); });
    action->setObjectName(QLatin1String(name));
  };
  compare(tr("&Compare with this"), "presets.compare", false);
  compare(tr("Compare &others with this (left side)"), "presets.compareLeft", true);
  menu->addSeparator();
  add("add", tr("&Duplicate"), &PresetsPanel::duplicateSelected, true);
  add("material", tr("&Rename…"), &PresetsPanel::askName, own);
  add("preset", tr("Ta&gs…"), &PresetsPanel::askTags, own);
  add("remove", tr("Move to &trash"), &PresetsPanel::trashSelected, own);
  menu->addSeparator();
  const QString folder = own ? QFileInfo(entry->path).path() : userPresetFolder();
  connect(menu->addAction(themeIcon("folder"), tr("Show &folder")), &QAction::triggered, this,
          [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
}

}  // namespace dermis
