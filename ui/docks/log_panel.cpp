#include "ui/docks/log_panel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QListWidget>
#include <QTime>
#include <QVBoxLayout>

#include "ui/theme/icons.h"

namespace dermis {
namespace {
constexpr int kKept = 2000;
}

LogPanel::LogPanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("log"));
  m_list->setAccessibleName(tr("Messages"));
  m_list->setWordWrap(true);
  m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
  column->addWidget(m_list);
  auto* copy = new QAction(tr("Copy"), m_list);
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetShortcut);
  connect(copy, &QAction::triggered, this, [this] {
    QStringList lines;
    for (const QListWidgetItem* item : m_list->selectedItems()) lines << item->text();
    QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
  });
  auto* clear = new QAction(tr("Clear"), m_list);
  connect(clear, &QAction::triggered, m_list, &QListWidget::clear);
  m_list->addActions({copy, clear});
}

void LogPanel::add(MessageKind kind, const QString& sentence) {
  const char* icon = kind == MessageKind::Error ? "error" : kind == MessageKind::Warning ? "warning" : "info";
  auto* item = new QListWidgetItem(themeIcon(icon),
                                   QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + sentence, m_list);
  item->setToolTip(sentence);
  if (m_list->count() > kKept) delete m_list->takeItem(0);
  m_list->scrollToBottom();
}

}  // namespace dermis
