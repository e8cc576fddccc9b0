// A field that takes a typed number, with a comma or a point, in any locale.
#pragma once

#include <QDoubleSpinBox>

#include "ui/rows/value_editor.h"

namespace dermis {

class NumberField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit NumberField(const NumberRange& range, QWidget* parent = nullptr);
  void setNumberRange(const NumberRange& range);
  /// Shows a number without telling of an edit.
  void showNumber(double number);
  /// A dash, where several values are shown at once, until it has the focus.
  void showMixed(bool mixed);

 Q_SIGNALS:
  void edited(double number, dermis::Gesture gesture);

 protected:
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;
  bool event(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void stepBy(int steps) override;

 private:
  [[nodiscard]] QString allDigits(double value) const;
  /// As many decimals as the field has room for; all of them while it is being typed into.
  void fitText();

  NumberRange m_range;
  GestureClock m_clock;
  bool m_mixed = false;
  bool m_typed = false;  ///< the text is about to change by a key
};

}  // namespace dermis
