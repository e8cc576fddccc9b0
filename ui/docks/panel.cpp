#include "ui/docks/panel.h"

#include <QFrame>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/rows/group_box.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"
#include "ui/theme/strips.h"

namespace dermis {

Panel::Panel(QWidget* parent) : QWidget(parent) {
  m_outer = flushColumn(this);
  auto* area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  auto* body = new QWidget(area);
  m_rows = flushColumn(body);
  area->setWidget(body);
  m_outer->addWidget(area, 1);
}

QVBoxLayout* Panel::strip() {
  if (m_strip == nullptr) {
    QFrame* frame = toolStrip(this);
    m_strip = new QVBoxLayout(frame);
    m_strip->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
    m_strip->setSpacing(metrics::kGap);
    m_outer->insertWidget(0, frame);
  }
  return m_strip;
}

GroupBox* Panel::addGroup(const QString& title, const QString& key) {
  auto* group = new GroupBox(title, key, body());
  m_rows->addWidget(group);
  return group;
}

QWidget* Panel::body() const { return m_rows->parentWidget(); }

void Panel::addWidget(QWidget* widget) { m_rows->addWidget(widget); }

void Panel::finish() { m_rows->addStretch(1); }

QToolButton* iconButton(const char* icon, const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIcon(themeIcon(icon));
  button->setToolTip(name);
  button->setAccessibleName(name);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace dermis
