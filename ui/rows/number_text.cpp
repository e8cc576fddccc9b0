#include "ui/rows/number_text.h"

#include <QLocale>
#include <array>
#include <cmath>
#include <numbers>

namespace dermis {
namespace {

enum class Kind { Plain, Length, Area, Angle, Stops };

struct UnitRow {
  const char* name;
  Kind kind;
  double size;  ///< in mm, mm², degrees, stops
};

constexpr std::array<UnitRow, 31> kUnits = {{
    {"nm", Kind::Length, 1e-6},    {"µm", Kind::Length, 1e-3},  // the micro sign
    {"μm", Kind::Length, 1e-3},                                 // the Greek letter
    {"um", Kind::Length, 1e-3},    {"mm", Kind::Length, 1.0},
    {"cm", Kind::Length, 10.0},    {"dm", Kind::Length, 100.0},
    {"m", Kind::Length, 1000.0},   {"in", Kind::Length, 25.4},
    {"inch", Kind::Length, 25.4},  {"\"", Kind::Length, 25.4},
    {"″", Kind::Length, 25.4},     {"ft", Kind::Length, 304.8},
    {"µm2", Kind::Area, 1e-6},     {"μm2", Kind::Area, 1e-6},
    {"um2", Kind::Area, 1e-6},     {"mm2", Kind::Area, 1.0},
    {"cm2", Kind::Area, 100.0},    {"m2", Kind::Area, 1e6},
    {"°", Kind::Angle, 1.0},       {"deg", Kind::Angle, 1.0},
    {"degrees", Kind::Angle, 1.0}, {"rad", Kind::Angle, 180.0 / std::numbers::pi},
    {"turn", Kind::Angle, 360.0},  {"turns", Kind::Angle, 360.0},
    {"ev", Kind::Stops, 1.0},      {"stop", Kind::Stops, 1.0},
    {"stops", Kind::Stops, 1.0},   {"%", Kind::Plain, 0.01},
    {"×", Kind::Plain, 1.0},       {"x", Kind::Plain, 1.0},
}};

QString plainName(QString unit) {
  unit = unit.trimmed().toLower();
  unit.replace(QStringLiteral("²"), QStringLiteral("2"));
  unit.remove(QLatin1Char('^'));
  return unit;
}

const UnitRow* findUnit(const QString& name) {
  for (const UnitRow& row : kUnits)
    if (name == QString::fromUtf8(row.name)) return &row;
  return nullptr;
}

/// What one of the typed unit amounts to in the field's own.
std::optional<double> factor(const QString& typed, const QString& own) {
  if (typed.isEmpty() || typed == own) return 1.0;
  const UnitRow* from = findUnit(typed);
  if (from == nullptr) return std::nullopt;
  if (own.isEmpty()) return from->kind == Kind::Plain ? std::optional(from->size) : std::nullopt;
  const UnitRow* to = findUnit(own);
  if (to == nullptr || to->kind != from->kind) return std::nullopt;
  return from->size / to->size;
}

/// The decimal sign is the last of the two; what stands before it in the other's place groups digits.
QString withPoint(QString number) {
  const qsizetype comma = number.lastIndexOf(QLatin1Char(','));
  const qsizetype point = number.lastIndexOf(QLatin1Char('.'));
  if (comma >= 0 && point >= 0) number.remove(comma > point ? QLatin1Char('.') : QLatin1Char(','));
  number.replace(QLatin1Char(','), QLatin1Char('.'));
  number.remove(QLatin1Char(' '));
  number.remove(QChar(0x00A0));
  number.remove(QChar(0x202F));
  return number;
}

}  // namespace

std::optional<double> parseNumber(const QString& text, const QString& unit) {
  QString plain = text.trimmed();
  plain.replace(QChar(0x2212), QLatin1Char('-'));
  // What follows the number is a unit; its own last character may be a digit ("mm2").
  static const QString kSquares = QStringLiteral("2²");
  qsizetype end = plain.size();
  if (end > 1 && kSquares.contains(plain[end - 1]) && (plain[end - 2].isLetter() || plain[end - 2] == QLatin1Char('^')))
    --end;
  while (end > 0 && !plain[end - 1].isDigit() && plain[end - 1] != QLatin1Char('.')) --end;
  bool ok = false;
  const double number = QLocale::c().toDouble(withPoint(plain.left(end)), &ok);
  if (!ok || !std::isfinite(number)) return std::nullopt;
  const std::optional<double> scale = factor(plainName(plain.mid(end)), plainName(unit));
  if (!scale) return std::nullopt;
  return number * *scale;
}

QString groupedNumber(quint64 number) {
  QString digits = QString::number(number);
  for (qsizetype i = digits.size() - 3; i > 0; i -= 3) digits.insert(i, QChar(0x202F));
  return digits;
}

}  // namespace dermis
