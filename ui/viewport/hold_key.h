// A key that does something while it is held, wherever the focus is but in a field that takes the letter.
#pragma once

#include <QObject>

class QWidget;

namespace dermis {

class HoldKey : public QObject {
  Q_OBJECT
 public:
  /// Listens while `window` is the active one.
  HoldKey(Qt::Key key, QWidget& window);
  [[nodiscard]] bool isHeld() const { return m_held; }

 Q_SIGNALS:
  void held(bool down);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void set(bool down);
  /// The same question that a shortcut asks: does the focus take this key for itself?
  [[nodiscard]] bool focusTakesKey() const;

  Qt::Key m_key;
  QWidget& m_window;
  bool m_held = false;
};

}  // namespace dermis
