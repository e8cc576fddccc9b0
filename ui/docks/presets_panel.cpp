#include "ui/docks/presets_panel.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QDir>
#include <QFrame>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "core/base/file_reference.h"
#include "ui/browse/list_place.h"
#include "ui/browse/preset_list.h"
#include "ui/docks/panel.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/preferences/list_keys.h"
#include "ui/preferences/preferences.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"
#include "ui/theme/strips.h"
#include "ui/thumbnails.h"

namespace dermis {
namespace {
constexpr int kBall = 96;
const QString kSearchKey = QStringLiteral("presets/search");
const QString kTagKey = QStringLiteral("presets/tag");
const QString kScrollKey = QStringLiteral("presets/scroll");
const QString kSelectedKey = QStringLiteral("presets/selected");
}  // namespace

PresetsPanel::PresetsPanel(Document& document, Loading& loading, Preferences& preferences, QWidget* parent)
    : QWidget(parent), m_document(document), m_loading(loading), m_preferences(preferences) {
  setAttribute(Qt::WA_StyledBackground);  // the panel's grey, as for its neighbours
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  buildHead();
  m_list = new PresetList(this);
  m_place = std::make_unique<ListPlace>(*m_list, kScrollKey);
  column->addWidget(m_list, 1);
  m_nothing = new QLabel(this);
  m_nothing->setProperty("quiet", true);
  m_nothing->setAlignment(Qt::AlignCenter);
  m_nothing->setWordWrap(true);
  m_nothing->setMargin(metrics::kMargin);
  column->addWidget(m_nothing);
  buildFoot();

  connect(m_list, &QListWidget::itemActivated, this, &PresetsPanel::applySelected);
  connect(m_list, &QListWidget::currentItemChanged, this, &PresetsPanel::refreshButtons);
  connect(m_list, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
    QMenu menu;
    fillMenu(&menu);
    menu.exec(m_list->mapToGlobal(at));
  });
  connect(renameKey(m_list), &QAction::triggered, this, &PresetsPanel::askName);
  connect(removeKey(m_list), &QAction::triggered, this, &PresetsPanel::trashSelected);
  connect(m_search, &QLineEdit::textChanged, this, &PresetsPanel::filter);
  connect(m_tag, &QComboBox::activated, this, &PresetsPanel::filter);
  connect(&m_document, &Document::currentSlotChanged, this, &PresetsPanel::refreshWorn);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Material) refreshWorn();
  });
  connect(&m_loading, &Loading::presetSaved, &m_library, &PresetLibrary::refresh);
  connect(&m_library, &PresetLibrary::changed, this, &PresetsPanel::fill);
  connect(&m_library, &PresetLibrary::rewritten, this,
          [this](const QString& from, const QString& to, const Material& before, const Material& after) {
            m_document.presetRewritten(from.toStdString(), to.toStdString(), before, after);
          });
  connect(&m_thumbnails, &ThumbnailMaker::made, this, &PresetsPanel::showThumbnail);
  connect(&m_thumbnails, &ThumbnailMaker::progressed, this, &PresetsPanel::showProgress);
  connect(&m_preferences, &Preferences::changed, this,
          [this] { m_library.setFolders(m_preferences.values().presetFolders); });
  m_library.setFolders(m_preferences.values().presetFolders);
  restore();
}

PresetsPanel::~PresetsPanel() { remember(); }

void PresetsPanel::buildHead() {
  QFrame* head = toolStrip(this);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
  row->setSpacing(metrics::kGap);
  m_search = new QLineEdit(head);
  m_search->setObjectName(QStringLiteral("presets.search"));
  m_search->setPlaceholderText(tr("Search presets"));
  m_search->setAccessibleName(tr("Search presets"));
  m_search->setToolTip(tr("Words of a preset's name or tags"));
  m_search->setClearButtonEnabled(true);
  m_search->addAction(themeIcon("search"), QLineEdit::LeadingPosition);
  m_tag = new QComboBox(head);
  m_tag->setObjectName(QStringLiteral("presets.tag"));
  m_tag->setAccessibleName(tr("Tag"));
  m_tag->setToolTip(tr("Shows presets with one tag: a shading model, whose it is, or a tag of your own"));
  m_tag->setMinimumWidth(86);
  row->addWidget(m_search, 1);
  row->addWidget(m_tag);
  layout()->addWidget(head);
}

void PresetsPanel::buildFoot() {
  auto* column = qobject_cast<QVBoxLayout*>(layout());
  auto* busy = new QHBoxLayout();
  busy->setContentsMargins(metrics::kMargin, 0, metrics::kMargin, 0);
  m_progress = new QLabel(this);
  m_progress->setObjectName(QStringLiteral("presets.progress"));
  m_progress->setProperty("quiet", true);
  m_cancel = iconButton("close", tr("Stop drawing thumbnails"), this);
  m_cancel->setObjectName(QStringLiteral("presets.cancel"));
  busy->addWidget(m_progress, 1);
  busy->addWidget(m_cancel);
  column->addLayout(busy);
  connect(m_cancel, &QToolButton::clicked, &m_thumbnails, &ThumbnailMaker::cancel);
  showProgress(0, 0);

  auto* worn = new QHBoxLayout();
  worn->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kMargin, 0);
  worn->setSpacing(2);
  m_worn = new QLabel(this);
  m_worn->setObjectName(QStringLiteral("presets.worn"));
  m_worn->setTextFormat(Qt::PlainText);
  m_worn->setMinimumWidth(40);
  m_update = iconButton("save", tr("Update the preset with the slot's values"), this);
  m_update->setObjectName(QStringLiteral("presets.save"));
  m_revert = iconButton("reset", tr("Revert the slot to its preset"), this);
  m_revert->setObjectName(QStringLiteral("presets.revert"));
  worn->addWidget(m_worn, 1);
  worn->addWidget(m_update);
  worn->addWidget(m_revert);
  column->addLayout(worn);

  auto* foot = new QHBoxLayout();
  foot->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kMargin, metrics::kMargin);
  foot->setSpacing(metrics::kGap);
  m_apply = new QPushButton(tr("Apply"), this);
  m_apply->setObjectName(QStringLiteral("presets.apply"));
  m_apply->setToolTip(tr("Put the selected preset on the current slot"));
  auto* saveAs = iconButton("add", tr("Save the slot's material as a new preset…"), this);
  saveAs->setObjectName(QStringLiteral("presets.saveAs"));
  m_more = iconButton("chevron-down", tr("More for the selected preset"), this);
  m_more->setObjectName(QStringLiteral("presets.more"));
  m_more->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_more);
  m_more->setMenu(menu);
  foot->addWidget(m_apply, 1);
  foot->addWidget(saveAs);
  foot->addWidget(m_more);
  column->addLayout(foot);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    fillMenu(menu);
  });
  connect(m_apply, &QPushButton::clicked, this, &PresetsPanel::applySelected);
  connect(m_update, &QToolButton::clicked, this, &PresetsPanel::saveRequested);
  connect(m_revert, &QToolButton::clicked, this, &PresetsPanel::revert);
  connect(saveAs, &QToolButton::clicked, this, &PresetsPanel::saveAsRequested);
}

void PresetsPanel::fill() {
  const QString chosen = m_list->currentPath();
  m_place->hold();
  {
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    for (const PresetEntry& entry : m_library.entries()) {
      auto* item = new QListWidgetItem(entry.name, m_list);
      item->setData(PresetList::kPathRole, entry.path);
      item->setData(PresetList::kKeyRole, entry.key);
      item->setData(PresetList::kTagsRole, entry.tags);
      item->setData(PresetList::kNameRole, entry.name);
      item->setToolTip(QStringLiteral("%1\n%2\n%3").arg(entry.name, entry.tags.join(QStringLiteral(", ")), entry.path));
      const QImage picture = m_thumbnails.find(entry);
      item->setIcon(QIcon(QPixmap::fromImage(picture.isNull() ? materialBall(entry.material, kBall) : picture)));
      if (entry.path == chosen) m_list->setCurrentItem(item);
    }
  }
  const QString tag = m_tag->currentIndex() > 0 ? m_tag->currentText() : QString();
  m_tag->clear();
  m_tag->addItem(tr("All"));
  m_tag->addItems(m_library.tags());
  m_tag->setCurrentIndex(std::max(0, m_tag->findText(tag)));
  filter();
  refreshWorn();
  refreshButtons();
  m_place->settle();
  m_thumbnails.want(m_library.entries());
}

void PresetsPanel::filter() {
  const QStringList words = m_search->text().simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  const QString tag = m_tag->currentIndex() > 0 ? m_tag->currentText() : QString();
  bool any = false;
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem* item = m_list->item(i);
    const QStringList tags = item->data(PresetList::kTagsRole).toStringList();
    const QString all = item->data(PresetList::kNameRole).toString() + QLatin1Char(' ') + tags.join(QLatin1Char(' '));
    bool found = tag.isEmpty() || tags.contains(tag);
    for (const QString& word : words) found = found && all.contains(word, Qt::CaseInsensitive);
    item->setHidden(!found);
    any = any || found;
  }
  m_nothing->setVisible(!any);
  m_nothing->setText(tr("No preset matches."));
  if (m_restored) remember();
}

void PresetsPanel::refreshWorn() {
  const SlotLook* look = m_document.currentLook();
  const QString path = look != nullptr && look->binding ? text(look->binding->presetPath) : QString();
  const bool edited = look != nullptr && look->binding && look->binding->edited;
  const bool missing = look != nullptr && look->binding && look->binding->missing;
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem* item = m_list->item(i);
    const bool worn = !path.isEmpty() && item->data(PresetList::kPathRole).toString() == path;
    QFont font = m_list->font();
    font.setBold(worn);
    item->setFont(font);
    const QString name = item->data(PresetList::kNameRole).toString();
    item->setText(worn && edited ? tr("%1 *").arg(name) : name);
  }
  const QString name = look == nullptr                    ? QString()
                       : look->worn.material.name.empty() ? tr("no preset")
                                                          : text(look->worn.material.name);
  const QString line = look == nullptr ? QString()
                       : edited        ? tr("%1:  %2 *").arg(m_document.currentSlot(), name)
                                       : tr("%1:  %2").arg(m_document.currentSlot(), name);
  m_worn->setText(line);
  m_worn->setAccessibleName(line);
  m_worn->setToolTip(missing  ? tr("The preset %1 could not be read; put the file back and revert to it").arg(path)
                     : edited ? tr("The slot's values differ from its preset")
                              : QString());
  m_revert->setEnabled((edited || missing) && (look->preset || !path.isEmpty()));
  m_update->setEnabled(look != nullptr);
  refreshButtons();
}

void PresetsPanel::refreshButtons() {
  const bool any = m_list->currentItem() != nullptr;
  m_apply->setEnabled(any && m_document.currentLook() != nullptr);
  m_more->setEnabled(any);
}

const PresetEntry* PresetsPanel::selected() const { return m_library.find(m_list->currentPath()); }

void PresetsPanel::apply(const QString& path, const QStringList& slots_) {
  m_loading.applyPreset(path.toStdString(), slots_);
}

void PresetsPanel::applySelected() {
  if (m_list->currentItem() != nullptr) apply(m_list->currentPath(), m_document.editedSlots());
}

void PresetsPanel::revert() { m_loading.revertToPreset(m_document.editedSlots()); }

// --- the selected preset's file --------------------------------------------------------------------------------------

void PresetsPanel::tell(const Error& error) { Q_EMIT m_loading.message(MessageKind::Error, text(error.message)); }

void PresetsPanel::duplicateSelected() {
  const PresetEntry* entry = selected();
  if (entry == nullptr) return;
  const Result<QString> path = m_library.duplicate(*entry);
  if (!path) {
    tell(path.error());
    return;
  }
  for (int i = 0; i < m_list->count(); ++i)
    if (m_list->item(i)->data(PresetList::kPathRole).toString() == *path) m_list->setCurrentRow(i);
}

void PresetsPanel::renameSelected(const QString& name) {
  const PresetEntry* entry = selected();
  if (entry == nullptr || entry->isBuiltin() || name.simplified().isEmpty()) return;
  if (const Result<QString> path = m_library.rename(*entry, name.simplified()); !path) tell(path.error());
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

// --- thumbnails, and where one was -----------------------------------------------------------------------------------

void PresetsPanel::showThumbnail(const QString& key) {
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem* item = m_list->item(i);
    if (item->data(PresetList::kKeyRole).toString() != key) continue;
    const PresetEntry* entry = m_library.find(item->data(PresetList::kPathRole).toString());
    const QImage picture = entry != nullptr ? m_thumbnails.find(*entry) : QImage();
    if (!picture.isNull()) item->setIcon(QIcon(QPixmap::fromImage(picture)));
  }
}

void PresetsPanel::showProgress(int done, int waiting) {
  m_progress->setVisible(waiting > 0);
  m_cancel->setVisible(waiting > 0);
  m_progress->setText(tr("Drawing thumbnails: %1 of %2").arg(done + 1).arg(done + waiting));
}

void PresetsPanel::remember() {
  QSettings settings;
  settings.setValue(kSearchKey, m_search->text());
  settings.setValue(kTagKey, m_tag->currentIndex() > 0 ? m_tag->currentText() : QString());
  settings.setValue(kSelectedKey, m_list->currentPath());
}

void PresetsPanel::restore() {
  const QSettings settings;
  m_search->setText(settings.value(kSearchKey).toString());
  m_tag->setCurrentIndex(std::max(0, m_tag->findText(settings.value(kTagKey).toString())));
  filter();
  m_restored = true;
  const QString selected = settings.value(kSelectedKey).toString();
  for (int i = 0; i < m_list->count() && !selected.isEmpty(); ++i)
    if (m_list->item(i)->data(PresetList::kPathRole).toString() == selected) m_list->setCurrentRow(i);
}

}  // namespace dermis
