#include "ui/docks/textures_panel.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/docks/dropped_paths.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/document/map_watcher.h"
#include "ui/document/maps_read.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"
#include "ui/translation.h"

namespace dermis {

TexturesPanel::TexturesPanel(Document& document, Loading& loading, QWidget* parent)
    : Panel(parent), m_document(document), m_loading(loading), m_watcher(new MapWatcher(document, loading, this)) {
  setAcceptDrops(true);
  m_title = new QLabel(this);
  m_title->setProperty("quiet", true);
  m_title->setToolTip(tr("Drop a folder anywhere here: its files find their maps by name, such as head_albedo.png"));
  m_title->setWordWrap(true);
  auto* folder = new QPushButton(themeIcon("open"), tr("Folder…"), this);
  folder->setObjectName(QStringLiteral("textures.folder"));
  folder->setAccessibleName(tr("Choose a folder of maps"));
  folder->setToolTip(tr("Choose a folder: its files find their maps by name, such as head_albedo.png"));
  connect(folder, &QPushButton::clicked, this, &TexturesPanel::chooseFolder);
  auto* top = new QHBoxLayout();
  top->addWidget(m_title, 1);
  top->addWidget(folder, 0, Qt::AlignTop);
  strip()->addLayout(top);
  m_report = new QWidget(this);
  auto* reportRow = new QHBoxLayout(m_report);
  reportRow->setContentsMargins(0, 0, 0, 0);
  m_reportText = new QLabel(m_report);
  m_reportText->setObjectName(QStringLiteral("textures.report"));
  m_reportText->setAccessibleName(tr("Maps matched by name"));
  m_reportText->setTextFormat(Qt::PlainText);
  m_reportText->setWordWrap(true);
  auto* close = iconButton("close", tr("Hide what was matched"), m_report);
  connect(close, &QToolButton::clicked, m_report, &QWidget::hide);
  reportRow->addWidget(m_reportText, 1);
  reportRow->addWidget(close, 0, Qt::AlignTop);
  strip()->addWidget(m_report);
  m_report->hide();

  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Material) refresh();
  });
  connect(&m_document, &Document::currentSlotChanged, this, [this] {
    m_report->hide();
    refresh();
  });
  connect(m_watcher, &MapWatcher::stateChanged, this, &TexturesPanel::refresh);
  connect(&m_loading, &Loading::mapsMatched, this, &TexturesPanel::showReport);
}

void TexturesPanel::buildRows() {
  auto* holder = new QWidget(body());
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
  column->setSpacing(metrics::kGap + 2);
  for (const TextureSlotRow& slot : textureSlots()) {
    auto* row = new TextureRow(slot, holder);
    m_rows.at(static_cast<std::size_t>(slot.slot)) = row;
    column->addWidget(row);
    connectRow(row, slot.slot);
  }
  m_nothing = new QLabel(tr("This shading model reads no maps."), holder);
  m_nothing->setProperty("quiet", true);
  column->addWidget(m_nothing);
  addWidget(holder);
  finish();
}

void TexturesPanel::connectRow(TextureRow* row, TextureSlot slot) {
  connect(row, &TextureRow::dropped, this, [this, slot](const QStringList& paths) { take(slot, paths); });
  connect(row, &TextureRow::chooseRequested, this, [this, slot] { choose(slot); });
  connect(row, &TextureRow::locateRequested, this, [this, slot] { askWhere(slot); });
  connect(row, &TextureRow::clearRequested, this, [this, slot] {
    std::vector<TextureEdit> edits;
    for (const QString& name : m_document.editedSlots()) edits.push_back({name, slot, TextureBinding{}, nullptr});
    m_document.setTextures(edits, tr("Clear %1 map of %2")
                                      .arg(tableText(textureSlotRow(slot).label).toLower(),
                                           m_document.editedSlots().join(QStringLiteral(", "))));
  });
  connect(row, &TextureRow::reloadRequested, this, [this, slot] {
    if (const SlotLook* look = m_document.currentLook())
      m_loading.rereadMap(look->worn.material.texture(slot).path, true);
  });
  connect(row, &TextureRow::bindingEdited, this,
          [this, slot](const BindingChange& change, Gesture gesture) { changeBinding(slot, change, gesture); });
}

void TexturesPanel::changeBinding(TextureSlot slot, const BindingChange& change, Gesture gesture) {
  std::vector<TextureEdit> edits;
  for (const QString& name : m_document.editedSlots()) {
    const ResolvedMaterial& worn = m_document.slotLook(name)->worn;
    if (!worn.material.texture(slot).present()) continue;
    TextureBinding next = worn.material.texture(slot);
    change(next);
    edits.push_back({name, slot, next, worn.images.at(static_cast<std::size_t>(slot))});
  }
  m_document.setTextures(
      edits,
      tr("Change %1 map of %2")
          .arg(tableText(textureSlotRow(slot).label).toLower(), m_document.editedSlots().join(QStringLiteral(", "))),
      gesture);
}

void TexturesPanel::take(std::optional<TextureSlot> slot, const QStringList& paths) {
  if (paths.isEmpty()) return;
  if (paths.size() == 1 && QFileInfo(paths.first()).isDir()) {
    m_loading.assignFolder(m_document.editedSlots(), paths.first());
  } else if (paths.size() == 1 && slot) {
    assign(*slot, paths.first());
  } else {
    std::vector<std::filesystem::path> files;
    for (const QString& path : paths) files.push_back(toPath(path));
    m_loading.assignByName(m_document.editedSlots(), files);
  }
}

void TexturesPanel::assign(TextureSlot slot, const QString& path) {
  m_loading.assignTexture(m_document.editedSlots(), slot, toPath(path));
}

void TexturesPanel::choose(TextureSlot slot) {
  const QString folder = QSettings().value(QStringLiteral("folders/textures")).toString();
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Choose the %1 map").arg(tableText(textureSlotRow(slot).label).toLower()),
                                   folder, tr("Images (%1);;All files (*)").arg(namePatterns(FileKind::Image)));
  if (path.isEmpty()) return;
  QSettings().setValue(QStringLiteral("folders/textures"), QFileInfo(path).path());
  assign(slot, path);
}

void TexturesPanel::chooseFolder() {
  const QString last = QSettings().value(QStringLiteral("folders/textures")).toString();
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Choose a folder of maps"), last);
  if (folder.isEmpty()) return;
  QSettings().setValue(QStringLiteral("folders/textures"), folder);
  take(std::nullopt, {folder});
}

void TexturesPanel::askWhere(TextureSlot slot) {
  const SlotLook* look = m_document.currentLook();
  if (look == nullptr) return;
  const QFileInfo missing(text(look->worn.material.texture(slot).path));
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Where is %1 now?").arg(missing.fileName()),
      QFileInfo::exists(missing.path()) ? missing.path()
                                        : QSettings().value(QStringLiteral("folders/textures")).toString(),
      tr("The same name (%1);;Images (%2);;All files (*)").arg(missing.fileName(), namePatterns(FileKind::Image)));
  if (!path.isEmpty()) locate(slot, path);
}

void TexturesPanel::locate(TextureSlot slot, const QString& path) {
  if (const SlotLook* look = m_document.currentLook())
    m_loading.locateMap(look->worn.material.texture(slot).path, toPath(path));
}

void TexturesPanel::showReport(const QString& report) {
  m_reportText->setText(report);
  m_report->show();
}

void TexturesPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!localPaths(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void TexturesPanel::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  take(std::nullopt, localPaths(event->mimeData()));
}

void TexturesPanel::setSeen(bool seen) {
  m_isSeen = seen;
  // Many widgets, and the window opens without them.
  if (m_isSeen && m_nothing == nullptr) buildRows();
  if (m_isSeen && m_isStale) refresh();
}

void TexturesPanel::refresh() {
  // Behind another dock's tab: neither the window's opening nor a slider that moves waits for its rows.
  m_isStale = !m_isSeen;
  if (m_isStale) return;
  const SlotLook* look = m_document.currentLook();
  setEnabled(look != nullptr);
  if (look == nullptr) return;
  m_title->setText(tr("Maps of “%1”. Drop a folder to match files by name.")
                       .arg(m_document.editedSlots().join(QStringLiteral(", "))));
  bool any = false;
  for (const TextureSlotRow& slot : textureSlots()) {
    TextureRow* row = m_rows.at(static_cast<std::size_t>(slot.slot));
    const TextureBinding& binding = look->worn.material.texture(slot.slot);
    const bool shown = readsMap(look->worn.material.model, slot.slot);
    row->setVisible(shown);
    any = any || shown;
    row->showBinding(binding, look->worn.images.at(static_cast<std::size_t>(slot.slot)),
                     m_watcher->stateOf(binding.path));
  }
  m_nothing->setVisible(!any);
}

}  // namespace dermis
