#include "ui/rows/number_field.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/rows/number_text.h"

namespace dermis {
namespace {
constexpr int kStoredDecimals = 6;
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
  // What is typed counts when it is committed; what assistive technology puts there counts at once, as nobody presses
  // Return after it.
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { m_typed = true; });
  connect(lineEdit(), &QLineEdit::textChanged, this, [this] {
    if (!std::exchange(m_typed, false)) interpretText();
  });
}

void NumberField::setNumberRange(const NumberRange& range) {
  m_range = range;
  const QSignalBlocker blocker(this);
  setRange(range.hardMin, range.hardMax);
  setSingleStep(range.step() * 10.0);
}

void NumberField::showMixed(bool mixed) {
  m_mixed = mixed;
  fitText();
}

void NumberField::showNumber(double number) {
  if (hasFocus() && lineEdit()->isModified() && qFuzzyCompare(1.0 + value(), 1.0 + number)) return;
  const QSignalBlocker blocker(this);
  setValue(number);
  fitText();
}

QString NumberField::allDigits(double value) const {
  // All stored digits, but no more trailing zeros than the range's own step shows.
  QString text = QString::number(value, 'f', kStoredDecimals);
  const qsizetype point = text.indexOf(QLatin1Char('.'));
  const qsizetype shortest = point + 1 + m_range.decimals();
  while (text.size() > shortest && text.endsWith(QLatin1Char('0'))) text.chop(1);
  if (text.endsWith(QLatin1Char('.'))) text.chop(1);
  return text;
}

QString NumberField::textFromValue(double value) const {
  if (m_mixed && !hasFocus()) return QStringLiteral("—");
  QString text = allDigits(value);
  if (hasFocus() || lineEdit() == nullptr) return text;
  // A line edit keeps two pixels on each side of its text, and a third for the cursor.
  const int room = lineEdit()->width() - 5;
  const qsizetype point = text.indexOf(QLatin1Char('.'));
  if (point < 0 || fontMetrics().horizontalAdvance(text) <= room) return text;
  for (int decimals = static_cast<int>(text.size() - point) - 2; decimals >= 1; --decimals) {
    const QString shorter = QString::number(value, 'f', decimals);
    if (fontMetrics().horizontalAdvance(shorter) > room) continue;
    // A small number must not look like none.
    return shorter.toDouble() == 0.0 && value != 0.0 ? QString::number(value, 'g', 1) : shorter;
  }
  return QString::number(value, 'f', 0);
}

void NumberField::fitText() {
  // The line edit's own signals would make the shown digits the value.
  const QSignalBlocker blocker(lineEdit());
  const QString text = textFromValue(value());
  if (lineEdit()->text() != text) lineEdit()->setText(text);
  setToolTip(m_mixed || text == allDigits(value()) ? QString() : allDigits(value()));
}

double NumberField::valueFromText(const QString& text) const {
  return std::clamp(parseNumber(text, m_range.unit).value_or(value()), minimum(), maximum());
}

QValidator::State NumberField::validate(QString& text, int&) const {
  // A number past the range is typed on the way to one inside it; committing it clamps.
  return parseNumber(text, m_range.unit) ? QValidator::Acceptable : QValidator::Intermediate;
}

void NumberField::fixup(QString& text) const { text = allDigits(value()); }

bool NumberField::event(QEvent* event) {
  // Undo takes typed letters back while there are some; what has been committed is the document's to take back.
  if (event->type() == QEvent::ShortcutOverride && !lineEdit()->isModified()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return false;
    }
  }
  return QDoubleSpinBox::event(event);
}

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
    lineEdit()->setText(allDigits(value()));
    selectAll();
    return;
  }
  const double before = value();
  QDoubleSpinBox::keyPressEvent(event);
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) return;
  lineEdit()->setModified(false);
  selectAll();
  // The number shown while it is typed over is one of several: committing it makes it all of theirs.
  if (m_mixed && value() == before) Q_EMIT edited(before, m_clock.current());
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QDoubleSpinBox::focusInEvent(event);
  fitText();
  QTimer::singleShot(0, this, &QAbstractSpinBox::selectAll);
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QDoubleSpinBox::focusOutEvent(event);
  lineEdit()->setModified(false);
  fitText();
}

void NumberField::resizeEvent(QResizeEvent* event) {
  QDoubleSpinBox::resizeEvent(event);
  fitText();
}

}  // namespace dermis
