#include "ui/snapshots/snapshots_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/preferences/list_keys.h"
#include "ui/snapshots/snapshots.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {

QToolButton* button(const char* icon, const QString& words, const QString& help, const char* name, QWidget* parent) {
  auto* made = new QToolButton(parent);
  made->setObjectName(QStringLiteral("snapshots.") + QLatin1String(name));
  made->setIcon(themeIcon(icon));
  made->setText(words);
  made->setAccessibleName(words);
  made->setToolTip(help);
  made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  return made;
}

}  // namespace

SnapshotsPanel::SnapshotsPanel(Snapshots& snapshots, QWidget* parent) : QWidget(parent), m_snapshots(snapshots) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(metrics::kGap, metrics::kGap, metrics::kGap, metrics::kGap);
  auto* buttons = new QVBoxLayout();
  m_take = button("camera", tr("Take"), tr("Keep the look as it is now"), "take", this);
  m_compare = button("preset", tr("Compare"), tr("Show the selected snapshot beside the picture, with the same camera"),
                     "compare", this);
  m_compare->setCheckable(true);
  m_restore = button("undo", tr("Restore"), tr("Put the selected look back; one step of undo"), "restore", this);
  m_remove = button("remove", tr("Delete"), tr("Forget the selected snapshot"), "remove", this);
  for (QToolButton* each : {m_take, m_compare, m_restore, m_remove}) {
    each->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    buttons->addWidget(each);
  }
  buttons->addStretch(1);
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("snapshots.list"));
  m_list->setAccessibleName(tr("Snapshots"));
  m_list->setToolTip(tr("Double-click compares, F2 renames"));
  m_list->setViewMode(QListView::IconMode);
  m_list->setFlow(QListView::LeftToRight);
  m_list->setWrapping(false);
  m_list->setMovement(QListView::Static);
  m_list->setIconSize(QSize(132, 88));
  m_list->setGridSize(QSize(144, 116));
  m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_list->setMinimumHeight(122);
  row->addLayout(buttons);
  row->addWidget(m_list, 1);

  connect(m_take, &QToolButton::clicked, this, &SnapshotsPanel::takeRequested);
  connect(m_compare, &QToolButton::clicked, this, [this](bool on) { Q_EMIT compareRequested(on ? selected() : -1); });
  connect(m_restore, &QToolButton::clicked, this, [this] {
    if (selected() >= 0) m_snapshots.restore(static_cast<std::size_t>(selected()));
  });
  connect(m_remove, &QToolButton::clicked, this, [this] {
    if (selected() >= 0) m_snapshots.remove(static_cast<std::size_t>(selected()));
  });
  connect(renameKey(m_list), &QAction::triggered, this, [this] {
    if (QListWidgetItem* item = m_list->currentItem()) m_list->editItem(item);
  });
  connect(removeKey(m_list), &QAction::triggered, m_remove, &QToolButton::click);
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int index) {
    if (m_compared >= 0 && index >= 0 && index != m_compared) Q_EMIT compareRequested(index);
    refreshButtons();
  });
  connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { Q_EMIT compareRequested(selected()); });
  connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    m_snapshots.rename(static_cast<std::size_t>(m_list->row(item)), item->text());
  });
  connect(&m_snapshots, &Snapshots::changed, this, &SnapshotsPanel::refresh);
  refresh();
}

int SnapshotsPanel::selected() const { return m_list->currentRow(); }

void SnapshotsPanel::showCompared(int index) {
  m_compared = index;
  refreshButtons();
}

void SnapshotsPanel::refresh() {
  const QSignalBlocker blocker(m_list);
  const auto& all = m_snapshots.all();
  // Entries are kept where they can be: one of them may be the one that is being renamed.
  const bool grown = static_cast<int>(all.size()) > m_list->count();
  while (m_list->count() > static_cast<int>(all.size())) delete m_list->takeItem(m_list->count() - 1);
  while (m_list->count() < static_cast<int>(all.size())) {
    auto* item = new QListWidgetItem(m_list);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
  for (int i = 0; i < m_list->count(); ++i) {
    const Snapshot& snapshot = all[static_cast<std::size_t>(i)];
    m_list->item(i)->setText(snapshot.name);
    m_list->item(i)->setIcon(QIcon(QPixmap::fromImage(snapshot.thumbnail)));
  }
  if (grown) m_list->setCurrentRow(m_list->count() - 1);
  refreshButtons();
}

void SnapshotsPanel::refreshButtons() {
  const bool any = selected() >= 0;
  for (QToolButton* each : {m_compare, m_restore, m_remove}) each->setEnabled(any);
  m_compare->setChecked(any && m_compared == selected());
}

}  // namespace dermis
