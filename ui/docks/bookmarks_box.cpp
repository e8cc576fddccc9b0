#include "ui/docks/bookmarks_box.h"

#include <QAction>
#include <QHBoxLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/docks/panel.h"
#include "ui/document/document.h"
#include "ui/preferences/list_keys.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {

BookmarksBox::BookmarksBox(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(metrics::kDotWidth, 0, 0, 0);
  column->setSpacing(metrics::kRowSpacing);
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("bookmarks.list"));
  m_list->setAccessibleName(tr("Camera bookmarks"));
  m_list->setToolTip(tr("Click looks from there, double-click renames"));
  m_list->setFixedHeight(92);
  m_list->setEditTriggers(QAbstractItemView::DoubleClicked);
  connect(renameKey(m_list), &QAction::triggered, this, [this] {
    if (QListWidgetItem* item = m_list->currentItem()) m_list->editItem(item);
  });
  connect(removeKey(m_list), &QAction::triggered, this, &BookmarksBox::removeSelected);
  column->addWidget(m_list);
  auto* line = new QHBoxLayout();
  m_add = new QToolButton(this);
  m_add->setObjectName(QStringLiteral("bookmarks.add"));
  m_add->setIcon(themeIcon("add"));
  m_add->setText(tr("Add bookmark"));
  m_add->setAccessibleName(tr("Add bookmark"));
  m_add->setToolTip(tr("Keep the camera's place with the scene"));
  m_add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_remove = iconButton("remove", tr("Remove the selected bookmark"), this);
  m_remove->setObjectName(QStringLiteral("bookmarks.remove"));
  line->addWidget(m_add);
  line->addStretch(1);
  line->addWidget(m_remove);
  column->addLayout(line);
  connect(m_add, &QToolButton::clicked, this, &BookmarksBox::addHere);
  connect(m_remove, &QToolButton::clicked, this, &BookmarksBox::removeSelected);
  connect(m_list, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { goTo(m_list->row(item)); });
  connect(m_list, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { goTo(m_list->row(item)); });
  connect(m_list, &QListWidget::itemChanged, this, &BookmarksBox::rename);
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) { m_remove->setEnabled(row >= 0); });
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Bookmarks) refresh();
  });
  refresh();
}

void BookmarksBox::addHere() {
  if (!m_document.isReady()) return;
  std::vector<CameraBookmark> next = m_document.scene().bookmarks;
  if (next.size() >= kMaxBookmarks) return;
  CameraBookmark bookmark;
  bookmark.name = tr("View %1").arg(next.size() + 1).toStdString();
  bookmark.camera = m_document.camera();
  next.push_back(std::move(bookmark));
  m_document.setBookmarks(next, tr("Add bookmark"));
  m_list->setCurrentRow(m_list->count() - 1);
}

void BookmarksBox::removeSelected() {
  const int row = m_list->currentRow();
  std::vector<CameraBookmark> next = m_document.scene().bookmarks;
  if (row < 0 || row >= static_cast<int>(next.size())) return;
  next.erase(next.begin() + row);
  m_document.setBookmarks(next, tr("Remove bookmark"));
}

void BookmarksBox::rename(QListWidgetItem* item) {
  const auto row = static_cast<std::size_t>(m_list->row(item));
  std::vector<CameraBookmark> next = m_document.scene().bookmarks;
  if (row >= next.size() || item->text().trimmed().isEmpty()) return refresh();
  next[row].name = item->text().trimmed().toStdString();
  m_document.setBookmarks(next, tr("Rename bookmark"));
}

void BookmarksBox::goTo(int index) {
  const auto& bookmarks = m_document.scene().bookmarks;
  if (index < 0 || index >= static_cast<int>(bookmarks.size())) return;
  m_document.setCamera(bookmarks[static_cast<std::size_t>(index)].camera);
  Q_EMIT visited();
}

void BookmarksBox::refresh() {
  const QSignalBlocker blocker(m_list);
  // Entries are kept where they can be: one of them may be the one that is being renamed.
  const auto& bookmarks = m_document.scene().bookmarks;
  while (m_list->count() > static_cast<int>(bookmarks.size())) delete m_list->takeItem(m_list->count() - 1);
  while (m_list->count() < static_cast<int>(bookmarks.size())) {
    auto* item = new QListWidgetItem(m_list);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
  for (int i = 0; i < m_list->count(); ++i) m_list->item(i)->setText(text(bookmarks[static_cast<std::size_t>(i)].name));
  m_remove->setEnabled(m_list->currentRow() >= 0);
  m_add->setEnabled(m_document.isReady());
}

}  // namespace dermis
