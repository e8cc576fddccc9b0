#include "ui/viewport/hold_key.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include "ui/preferences/shortcuts.h"

namespace dermis {

HoldKey::HoldKey(const QString& id, const QString& label, const QKeySequence& key, QWidget& window)
    : QObject(&window), m_action(new QAction(label, this)), m_window(window) {
  m_action->setObjectName(id);
  m_action->setShortcut(key);
  Shortcuts::list(m_action, tr("While a key is held"));
  connect(m_action, &QAction::changed, this, &HoldKey::keyChanged);
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
      if (!watched->isWidgetType()) break;
      // A held key repeats: whoever has the focus need not hear of it.
      if (m_held && press->key() == m_down) return true;
      const int pressed = press->key() | static_cast<int>(press->modifiers() & ~Qt::KeypadModifier);
      if (m_held || key().isEmpty() || key()[0].toCombined() != pressed) break;
      if (press->isAutoRepeat() || QApplication::activePopupWidget() != nullptr || focusTakes(*press)) break;
      if (static_cast<QWidget*>(watched)->window() != &m_window) break;
      m_down = press->key();
      set(true);
      return true;
    }
    case QEvent::KeyRelease: {
      const auto* release = static_cast<QKeyEvent*>(event);
      if (!m_held || release->key() != m_down || release->isAutoRepeat()) break;
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

QKeySequence HoldKey::key() const { return m_action->shortcut(); }

bool HoldKey::focusTakes(const QKeyEvent& press) {
  QWidget* focus = QApplication::focusWidget();
  if (focus == nullptr) return false;
  QKeyEvent question(QEvent::ShortcutOverride, press.key(), press.modifiers(), press.text());
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
