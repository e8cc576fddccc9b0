#include "ui/docks/presets_panel.h"

#include <QDir>
#include <QFileSystemWatcher>
#include <QFrame>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStandardPaths>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/material/builtin_presets.h"
#include "core/material/preset_io.h"
#include "ui/docks/panel.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"
#include "ui/thumbnails.h"

namespace dermis {
namespace {

constexpr int kBall = 40;
constexpr int kPathRole = Qt::UserRole;

void addItem(QListWidget* list, const QString& name, const QString& path, const Material& material) {
  auto* item = new QListWidgetItem(name, list);
  item->setData(kPathRole, path);
  const QString model = text(shadingModelRow(material.model).label);
  item->setToolTip(QStringLiteral("%1\n%2\n%3").arg(name, model, path));
  item->setIcon(QIcon(QPixmap::fromImage(materialBall(material, kBall))));
}

}  // namespace

QString userPresetFolder() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/presets");
  QDir().mkpath(folder);
  return folder;
}

PresetsPanel::PresetsPanel(Document& document, Loading& loading, QWidget* parent)
    : QWidget(parent), m_document(document), m_loading(loading) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new QFrame(this);
  head->setProperty("toolStrip", true);
  auto* headRow = new QHBoxLayout(head);
  headRow->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
  m_search = new QLineEdit(head);
  m_search->setPlaceholderText(tr("Search presets"));
  m_search->setAccessibleName(tr("Search presets"));
  m_search->setClearButtonEnabled(true);
  m_search->addAction(themeIcon("search"), QLineEdit::LeadingPosition);
  headRow->addWidget(m_search);
  column->addWidget(head);
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("presets.list"));
  m_list->setAccessibleName(tr("Presets"));
  m_list->setIconSize(QSize(kBall, kBall));
  m_list->setUniformItemSizes(true);
  column->addWidget(m_list, 1);
  auto* foot = new QHBoxLayout();
  foot->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kMargin, metrics::kGap);
  foot->setSpacing(metrics::kGap);
  m_apply = new QPushButton(tr("Apply"), this);
  m_apply->setObjectName(QStringLiteral("presets.apply"));
  m_apply->setToolTip(tr("Put the selected preset on the current slot"));
  auto* save = iconButton("save", tr("Save the current material to its preset"), this);
  save->setObjectName(QStringLiteral("presets.save"));
  auto* saveAs = iconButton("add", tr("Save the current material as a new preset…"), this);
  saveAs->setObjectName(QStringLiteral("presets.saveAs"));
  foot->addWidget(m_apply, 1);
  foot->addWidget(save);
  foot->addWidget(saveAs);
  column->addLayout(foot);

  connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { applySelected(); });
  connect(m_list, &QListWidget::itemActivated, this, [this] { applySelected(); });
  connect(m_apply, &QPushButton::clicked, this, &PresetsPanel::applySelected);
  connect(save, &QToolButton::clicked, this, &PresetsPanel::saveRequested);
  connect(saveAs, &QToolButton::clicked, this, &PresetsPanel::saveAsRequested);
  connect(m_search, &QLineEdit::textChanged, this, &PresetsPanel::filter);
  connect(&m_document, &Document::currentSlotChanged, this, &PresetsPanel::refreshSelection);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Material) refreshSelection();
  });
  connect(&m_loading, &Loading::presetSaved, this, &PresetsPanel::refresh);
  m_watcher = new QFileSystemWatcher({userPresetFolder()}, this);
  connect(m_watcher, &QFileSystemWatcher::directoryChanged, this, &PresetsPanel::refresh);
  refresh();
}

void PresetsPanel::refresh() {
  m_list->clear();
  Warnings ignored;
  for (const BuiltinPreset& preset : builtinPresets())
    if (const Result<Material> material = loadBuiltinPreset(preset.id, ignored))
      addItem(m_list, text(preset.name), QStringLiteral("builtin:") + text(preset.id), *material);
  const QDir folder(userPresetFolder());
  for (const QFileInfo& file : folder.entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
    // A file that isn't a preset simply isn't listed: opening it by hand says why.
    if (const Result<Material> material = loadPreset(toPath(file.absoluteFilePath()), ignored))
      addItem(m_list, material->name.empty() ? file.completeBaseName() : text(material->name), file.absoluteFilePath(),
              *material);
  }
  filter();
  refreshSelection();
}

void PresetsPanel::filter() {
  for (int i = 0; i < m_list->count(); ++i)
    m_list->item(i)->setHidden(!m_list->item(i)->text().contains(m_search->text().simplified(), Qt::CaseInsensitive));
}

void PresetsPanel::refreshSelection() {
  const SlotLook* look = m_document.currentLook();
  m_apply->setEnabled(look != nullptr);
  if (look == nullptr) return;
  const QString path = look->binding ? text(look->binding->presetPath) : QString();
  const QSignalBlocker blocker(m_list);
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem* item = m_list->item(i);
    QFont font = m_list->font();
    const bool worn = !path.isEmpty() && item->data(kPathRole).toString() == path;
    font.setBold(worn);
    item->setFont(font);
  }
}

void PresetsPanel::applySelected() {
  const QListWidgetItem* item = m_list->currentItem();
  if (item != nullptr) m_loading.applyPreset(item->data(kPathRole).toString().toStdString(), m_document.currentSlot());
}

}  // namespace dermis
