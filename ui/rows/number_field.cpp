#include "ui/rows/number_field.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace dermis {
namespace {
constexpr int kStoredDecimals = 6;
}

std::optional<double> parseNumber(const QString& text) {
  QString plain = text.trimmed();
  plain.replace(QLatin1Char(','), QLatin1Char('.'));
  plain.replace(QChar(0x2212), QLatin1Char('-'));
  // What follows the number is a unit.
  qsizetype end = plain.size();
  while (end > 0 && !plain[end - 1].isDigit() && plain[end - 1] != QLatin1Char('.')) --end;
  bool ok = false;
  const double number = QLocale::c().toDouble(plain.left(end), &ok);
  if (!ok || !std::isfinite(number)) return std::nullopt;
  return number;
}

NumberField::NumberField(const NumberRange& range, QWidget* parent) : QDoubleSpinBox(parent) {
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  setLocale(QLocale::c());
  setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  setDecimals(kStoredDecimals);
  setContextMenuPolicy(Qt::NoContextMenu);
  setNumberRange(range);
  connect(this, &QDoubleSpinBox::valueChanged, this, [this](double v) { Q_EMIT edited(v, m_clock.current()); });
}

void NumberField::setNumberRange(const NumberRange& range) {
  m_range = range;
  const QSignalBlocker blocker(this);
  setRange(range.hardMin, range.hardMax);
  setSingleStep(range.step() * 10.0);
}

void NumberField::showNumber(double number) {
  if (hasFocus() && lineEdit()->isModified() && qFuzzyCompare(1.0 + value(), 1.0 + number)) return;
  const QSignalBlocker blocker(this);
  setValue(number);
}

QString NumberField::textFromValue(double value) const {
  // All stored digits, but no more trailing zeros than the range's own step shows.
  QString text = QString::number(value, 'f', kStoredDecimals);
  const qsizetype point = text.indexOf(QLatin1Char('.'));
  const qsizetype shortest = point + 1 + m_range.decimals();
  while (text.size() > shortest && text.endsWith(QLatin1Char('0'))) text.chop(1);
  if (text.endsWith(QLatin1Char('.'))) text.chop(1);
  return text;
}

double NumberField::valueFromText(const QString& text) const {
  return std::clamp(parseNumber(text).value_or(value()), minimum(), maximum());
}

QValidator::State NumberField::validate(QString& text, int&) const {
  // A number past the range is typed on the way to one inside it; committing it clamps.
  return parseNumber(text) ? QValidator::Acceptable : QValidator::Intermediate;
}

void NumberField::fixup(QString& text) const { text = textFromValue(value()); }

void NumberField::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore();
}

void NumberField::stepBy(int steps) {
  const Qt::KeyboardModifiers keys = QGuiApplication::keyboardModifiers();
  const double step = m_range.step() * (keys.testFlag(Qt::ShiftModifier) ? 1.0 : 10.0);
  setValue(value() + steps * step);
  selectAll();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    lineEdit()->setText(textFromValue(value()));
    selectAll();
    return;
  }
  QDoubleSpinBox::keyPressEvent(event);
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) selectAll();
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QDoubleSpinBox::focusInEvent(event);
  QTimer::singleShot(0, this, &QAbstractSpinBox::selectAll);
}

}  // namespace dermis
