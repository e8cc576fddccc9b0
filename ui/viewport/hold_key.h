// A key that does something while it is held, wherever the focus is but in a field that takes the letter.
#pragma once

#include <QObject>

class QAction;
class QKeyEvent;
class QKeySequence;
class QWidget;

namespace dermis {

class HoldKey : public QObject {
  Q_OBJECT
 public:
  /// Listens while `window` is the active one. The key can be changed under the name `id`, where it is called `label`.
  HoldKey(const QString& id, const QString& label, const QKeySequence& key, QWidget& window);
  /// The key as it is set now.
  [[nodiscard]] QKeySequence key() const;
  [[nodiscard]] bool isHeld() const { return m_held; }

 Q_SIGNALS:
  void held(bool down);
  /// Another key does it now.
  void keyChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void set(bool down);
  /// The same question that a shortcut asks: does the focus take this key for itself?
  [[nodiscard]] static bool focusTakes(const QKeyEvent& press);

  QAction* m_action = nullptr;  ///< of no menu and no widget: only its shortcut is of use
  QWidget& m_window;
  bool m_held = false;
  int m_down = 0;  ///< the key that is held
};

}  // namespace dermis
