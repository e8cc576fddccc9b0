#include "ui/viewport/hold_key.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace dermis {

HoldKey::HoldKey(Qt::Key key, QWidget& window) : QObject(&window), m_key(key), m_window(window) {
  qApp->installEventFilter(this);
  // A release that goes to another window, or to nobody, is never heard: losing the focus is one.
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (now == nullptr || now->window() != &m_window) set(false);
  });
  connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
    if (state != Qt::ApplicationActive) set(false);
  });
}

bool HoldKey::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::KeyPress: {
      const auto* press = static_cast<QKeyEvent*>(event);
      if (press->key() != m_key || !watched->isWidgetType()) break;
      // A held key repeats: whoever has the focus need not hear of it.
      if (m_held) return true;
      const bool plain = (press->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
      if (!plain || press->isAutoRepeat() || QApplication::activePopupWidget() != nullptr || focusTakesKey()) break;
      if (static_cast<QWidget*>(watched)->window() != &m_window) break;
      set(true);
      return true;
    }
    case QEvent::KeyRelease: {
      const auto* release = static_cast<QKeyEvent*>(event);
      if (!m_held || release->key() != m_key || release->isAutoRepeat()) break;
      set(false);
      break;
    }
    case QEvent::WindowDeactivate:
      if (watched == &m_window) set(false);
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

bool HoldKey::focusTakesKey() const {
  QWidget* focus = QApplication::focusWidget();
  if (focus == nullptr) return false;
  QKeyEvent question(QEvent::ShortcutOverride, m_key, Qt::NoModifier, QString(QChar(m_key)).toLower());
  question.ignore();
  QApplication::sendEvent(focus, &question);
  return question.isAccepted();
}

void HoldKey::set(bool down) {
  if (down == m_held) return;
  m_held = down;
  Q_EMIT held(down);
}

}  // namespace dermis
