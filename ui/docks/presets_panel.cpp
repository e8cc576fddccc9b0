#include "ui/docks/presets_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>
#include <functional>
#include <utility>

#include "ui/browse/list_place.h"
#include "ui/browse/preset_list.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/preferences/list_keys.h"
#include "ui/preferences/preferences.h"
#include "ui/text.h"
#include "ui/theme/metrics.h"
#include "ui/thumbnails.h"

namespace dermis {
namespace {
const QString kSearchKey = QStringLiteral("presets/search");
const QString kTagKey = QStringLiteral("presets/tag");
const QString kScrollKey = QStringLiteral("presets/scroll");
const QString kSelectedKey = QStringLiteral("presets/selected");

/// Its picture is looked for when it is seen: most of the list is not when the window opens.
class PresetItem : public QListWidgetItem {
 public:
  PresetItem(const QString& name, QListWidget* list, std::function<QIcon()> icon)
      : QListWidgetItem(name, list), m_icon(std::move(icon)) {}
  [[nodiscard]] QVariant data(int role) const override {
    return role == Qt::DecorationRole ? QVariant(m_icon()) : QListWidgetItem::data(role);
  }

 private:
  std::function<QIcon()> m_icon;
};
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
  connect(m_list, &QListWidget::currentItemChanged, this, [this] {
    m_awaitedPath.clear();
    refreshButtons();
  });
  connect(m_list, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
    QMenu menu;
    fillMenu(&menu);
    menu.exec(m_list->mapToGlobal(at));
  });
  connect(renameKey(m_list), &QAction::triggered, this, &PresetsPanel::askName);
  connect(removeKey(m_list), &QAction::triggered, this, &PresetsPanel::trashSelected);
  connect(m_search, &QLineEdit::textChanged, this, &PresetsPanel::filter);
  connect(m_tag, &QComboBox::activated, this, [this] {
    m_awaitedTag.clear();
    filter();
  });
  connect(&m_document, &Document::currentSlotChanged, this, &PresetsPanel::refreshWorn);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    m_thumbnails.yield();
    if (what == Change::Everything || what == Change::Material) refreshWorn();
  });
  connect(&m_loading, &Loading::presetSaved, &m_library, &PresetLibrary::refresh);
  connect(&m_library, &PresetLibrary::changed, this, &PresetsPanel::fill);
  connect(&m_library, &PresetLibrary::problem, this,
          [this](const QString& sentence) { Q_EMIT m_loading.message(MessageKind::Error, sentence); });
  connect(&m_library, &PresetLibrary::rewritten, this,
          [this](const QString& from, const QString& to, const Material& before, const Material& after) {
            m_document.presetRewritten(from.toStdString(), to.toStdString(), before, after);
          });
  m_thumbnails.preferShown([this] { return shownKeys(); });
  connect(&m_thumbnails, &ThumbnailMaker::made, this, &PresetsPanel::showThumbnail);
  connect(&m_thumbnails, &ThumbnailMaker::progressed, this, &PresetsPanel::showProgress);
  connect(&m_preferences, &Preferences::changed, this,
          [this] { m_library.setFolders(m_preferences.values().presetFolders); });
  m_library.setFolders(m_preferences.values().presetFolders);
  fill();
  restore();
}

PresetsPanel::~PresetsPanel() { remember(); }

void PresetsPanel::fill() {
  const QString chosen = m_list->currentPath();
  m_place->hold();
  {
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    for (const PresetEntry& entry : m_library.entries()) {
      auto* item = new PresetItem(entry.name, m_list, [this, path = entry.path] { return iconOf(path); });
      item->setData(PresetList::kPathRole, entry.path);
      item->setData(PresetList::kKeyRole, entry.key);
      item->setData(PresetList::kTagsRole, entry.tags);
      item->setData(PresetList::kNameRole, entry.name);
      item->setToolTip(QStringLiteral("%1\n%2\n%3").arg(entry.name, entry.tags.join(QStringLiteral(", ")), entry.path));
      if (entry.path == chosen) m_list->setCurrentItem(item);
    }
  }
  const QString tag = m_tag->currentIndex() > 0 ? m_tag->currentText() : QString();
  m_tag->clear();
  m_tag->addItem(tr("All"));
  m_tag->addItems(m_library.tags());
  m_tag->setCurrentIndex(std::max(0, m_tag->findText(tag)));
  takeAwaited();
  filter();
  refreshWorn();
  refreshButtons();
  m_place->settle();
  m_thumbnails.want(m_library.entries());
}

QIcon PresetsPanel::iconOf(const QString& path) {
  const PresetEntry* entry = m_library.find(path);
  if (entry == nullptr) return {};
  QIcon& icon = m_icons[entry->key];
  if (!icon.isNull()) return icon;
  QImage picture = m_thumbnails.find(*entry);
  if (picture.isNull())
    picture = entry->ball.isNull() ? materialBall(entry->material, PresetEntry::kBall) : entry->ball;
  icon = QIcon(QPixmap::fromImage(picture));
  return icon;
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

void PresetsPanel::apply(const QString& path, const QStringList& slots_) {
  m_loading.applyPreset(path.toStdString(), slots_);
}

void PresetsPanel::applySelected() {
  if (m_list->currentItem() != nullptr) apply(m_list->currentPath(), m_document.editedSlots());
}

void PresetsPanel::revert() { m_loading.revertToPreset(m_document.editedSlots()); }

// --- thumbnails, and where one was -----------------------------------------------------------------------------------

void PresetsPanel::showThumbnail(const QString& key) {
  m_icons.remove(key);
  m_list->viewport()->update();
}

QSet<QString> PresetsPanel::shownKeys() const {
  QSet<QString> keys;
  for (int i = 0; i < m_list->count() && m_list->isVisible(); ++i) {
    const QListWidgetItem* item = m_list->item(i);
    if (!item->isHidden() && m_list->visualItemRect(item).intersects(m_list->viewport()->rect()))
      keys.insert(item->data(PresetList::kKeyRole).toString());
  }
  return keys;
}

void PresetsPanel::showProgress(int done, int waiting) {
  m_progress->setVisible(waiting > 0);
  m_cancel->setVisible(waiting > 0);
  m_progress->setText(tr("Drawing thumbnails: %1 of %2").arg(done + 1).arg(done + waiting));
}

void PresetsPanel::remember() {
  QSettings settings;
  const QString tag = m_tag->currentIndex() > 0 ? m_tag->currentText() : QString();
  settings.setValue(kSearchKey, m_search->text());
  settings.setValue(kTagKey, m_awaitedTag.isEmpty() ? tag : m_awaitedTag);
  settings.setValue(kSelectedKey, m_awaitedPath.isEmpty() ? m_list->currentPath() : m_awaitedPath);
}

void PresetsPanel::restore() {
  const QSettings settings;
  m_awaitedTag = settings.value(kTagKey).toString();
  m_awaitedPath = settings.value(kSelectedKey).toString();
  m_search->setText(settings.value(kSearchKey).toString());
  takeAwaited();
  filter();
  m_restored = true;
}

void PresetsPanel::takeAwaited() {
  const int tag = m_awaitedTag.isEmpty() ? -1 : m_tag->findText(m_awaitedTag);
  if (tag > 0) {
    m_awaitedTag.clear();
    m_tag->setCurrentIndex(tag);
  }
  if (!m_awaitedPath.isEmpty()) select(QString(m_awaitedPath));
}

void PresetsPanel::select(const QString& path) {
  for (int i = 0; i < m_list->count(); ++i)
    if (m_list->item(i)->data(PresetList::kPathRole).toString() == path) m_list->setCurrentRow(i);
}

}  // namespace dermis
