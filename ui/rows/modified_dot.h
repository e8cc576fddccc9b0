// The dot before a row's label: empty, differs from the default, changed since the preset, several values.
#pragma once

#include <QWidget>

namespace dermis {

class ModifiedDot : public QWidget {
  Q_OBJECT
 public:
  enum class State { AsDefault, Differs, Changed, Several };
  explicit ModifiedDot(QWidget* parent = nullptr);
  void showState(State state);
  [[nodiscard]] State state() const { return m_state; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  State m_state = State::AsDefault;
};

}  // namespace dermis
