#include "ui/rows/group_box.h"

#include <QAction>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {

GroupBox::GroupBox(const QString& title, const QString& key, QWidget* parent)
    : QWidget(parent), m_key(key.isEmpty() ? QString() : QStringLiteral("groups/") + key) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  m_head = new QToolButton(this);
  m_head->setText(title);
  m_head->setAccessibleName(tr("%1, group").arg(title));
  m_head->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_head->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  m_head->setIconSize(QSize(12, 12));
  m_head->setProperty("groupHead", true);
  m_head->setFocusPolicy(Qt::TabFocus);
  m_body = new QWidget(this);
  m_rows = new QVBoxLayout(m_body);
  m_rows->setContentsMargins(metrics::kGap, metrics::kGap, metrics::kGap, metrics::kMargin);
  m_rows->setSpacing(metrics::kRowSpacing);
  column->addWidget(m_head);
  column->addWidget(m_body);
  if (!m_key.isEmpty()) m_open = QSettings().value(m_key, true).toBool();
  connect(m_head, &QToolButton::clicked, this, [this] { setOpen(!m_open); });
  refresh();
}

void GroupBox::addRow(QWidget* row) { m_rows->addWidget(row); }

void GroupBox::addHeadActions(const QList<QAction*>& actions) {
  m_head->addActions(actions);
  m_head->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void GroupBox::clearRows() {
  while (QLayoutItem* item = m_rows->takeAt(0)) {
    delete item->widget();
    delete item;
  }
}

void GroupBox::setOpen(bool open) {
  m_open = open;
  if (!m_key.isEmpty()) QSettings().setValue(m_key, open);
  refresh();
}

void GroupBox::setForcedOpen(bool forced) {
  m_forced = forced;
  refresh();
}

void GroupBox::refresh() {
  const bool shown = m_open || m_forced;
  m_body->setVisible(shown);
  m_head->setIcon(themeIcon(shown ? "chevron-down" : "chevron-right"));
}

}  // namespace dermis
