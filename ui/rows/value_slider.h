// A slider over a soft range of real numbers.
#pragma once

#include <QSlider>
#include <optional>

#include "ui/rows/value_editor.h"

namespace dermis {

/// Drag moves it, a double-click brings the default back, Shift is ten times finer, Ctrl snaps to twentieths, the wheel
/// works only with the focus. The number may lie past the soft range: the handle then waits at the end.
class ValueSlider : public QSlider {
  Q_OBJECT
 public:
  explicit ValueSlider(const NumberRange& range, QWidget* parent = nullptr);
  void setNumberRange(const NumberRange& range);
  void showNumber(double number);
  /// As a hand would: clamped to the hard range, and an edit.
  void setNumber(double number);
  [[nodiscard]] double number() const { return m_number; }
  [[nodiscard]] const NumberRange& range() const { return m_range; }
  void showDefault(std::optional<double> number);
  /// The number is one of several: moving the handle to where it stands, as past an end, makes it all of theirs.
  void showMixed(bool mixed) { m_mixed = mixed; }
  [[nodiscard]] QSize sizeHint() const override { return {120, 22}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {48, 22}; }
  /// Where the handle's centre lies, in widget coordinates.
  [[nodiscard]] QPoint handleCentre() const;

 Q_SIGNALS:
  void edited(double number, dermis::Gesture gesture);
  void dragStarted();
  void dragEnded();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] double fractionOf(double number) const;
  void moveTo(double number, Qt::KeyboardModifiers keys);
  void step(double ticks, Qt::KeyboardModifiers keys);

  NumberRange m_range;
  GestureClock m_clock;
  double m_number = 0.0;
  bool m_mixed = false;
  std::optional<double> m_default;
  double m_fraction = 0.0;  ///< of the drag in progress, unrounded
  double m_lastX = 0.0;
  Gesture m_press = 0;  ///< of the drag in progress, or the last one
};

}  // namespace dermis
