#include "ui/browse/list_place.h"

#include <QEvent>
#include <QListWidget>
#include <QScrollBar>
#include <QSettings>

namespace dermis {

ListPlace::ListPlace(QListWidget& list, const QString& key) : m_list(list), m_key(key) {
  m_wanted = QSettings().value(m_key).toInt();
  m_list.installEventFilter(this);
  connect(m_list.verticalScrollBar(), &QScrollBar::rangeChanged, this, &ListPlace::apply);
  // Whoever scrolls is where he wants to be.
  connect(m_list.verticalScrollBar(), &QScrollBar::actionTriggered, this, [this] { m_wanted.reset(); });
}

ListPlace::~ListPlace() { QSettings().setValue(m_key, m_wanted.value_or(m_list.verticalScrollBar()->value())); }

void ListPlace::hold() {
  if (!m_wanted) m_wanted = m_list.verticalScrollBar()->value();
}

void ListPlace::settle() {
  if (!m_list.isVisible()) return;
  m_list.doItemsLayout();
  apply();
}

bool ListPlace::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show) QMetaObject::invokeMethod(this, &ListPlace::settle, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

void ListPlace::apply() {
  if (!m_wanted || !m_list.isVisible() || m_list.verticalScrollBar()->maximum() < *m_wanted) return;
  m_list.verticalScrollBar()->setValue(*m_wanted);
  m_wanted.reset();
}

}  // namespace dermis
