#include "ui/dialogs/folder_list.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QListWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/docks/panel.h"
#include "ui/theme/metrics.h"

namespace dermis {

FolderList::FolderList(const QString& title, const QString& name, QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(metrics::kGap);
  m_list = new QListWidget(this);
  m_list->setObjectName(name);
  m_list->setAccessibleName(title);
  m_list->setToolTip(tr("Folders that are searched, and watched for changes"));
  m_list->setFixedHeight(64);
  row->addWidget(m_list, 1);
  auto* buttons = new QVBoxLayout();
  auto* add = iconButton("add", tr("%1: add a folder…").arg(title), this);
  add->setObjectName(name + QStringLiteral(".add"));
  auto* remove = iconButton("remove", tr("%1: remove the selected folder from the list").arg(title), this);
  remove->setObjectName(name + QStringLiteral(".remove"));
  buttons->addWidget(add);
  buttons->addWidget(remove);
  buttons->addStretch(1);
  row->addLayout(buttons);
  connect(add, &QToolButton::clicked, this,
          [this, title] { this->add(QFileDialog::getExistingDirectory(this, title)); });
  connect(remove, &QToolButton::clicked, this, [this] { delete m_list->takeItem(m_list->currentRow()); });
}

void FolderList::setFolders(const QStringList& folders) {
  m_list->clear();
  m_list->addItems(folders);
}

QStringList FolderList::folders() const {
  QStringList folders;
  for (int i = 0; i < m_list->count(); ++i) folders << m_list->item(i)->text();
  return folders;
}

void FolderList::add(const QString& folder) {
  if (!folder.isEmpty() && !folders().contains(folder)) m_list->addItem(folder);
}

}  // namespace dermis
