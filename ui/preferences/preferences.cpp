#include "ui/preferences/preferences.h"

#include <QCoreApplication>
#include <QSettings>
#include <algorithm>

namespace dermis {
namespace {

constexpr const char* kScale = "preferences/interfaceScale";

/// Writes or reads all values with the same list of keys.
template <class Visit, class Values>
void visit(Values& v, Visit item) {
  item("preferences/theme", v.theme);
  item(kScale, v.interfaceScale);
  item("preferences/lengthUnit", v.unit);
  item("preferences/autosaveSeconds", v.autosaveSeconds);
  item("preferences/cacheMegabytes", v.cacheMegabytes);
  item("preferences/stillSamples", v.stillSamples);
  item("preferences/statistics", v.statistics);
  item("preferences/presetFolders", v.presetFolders);
  item("preferences/environmentFolders", v.environmentFolders);
}

}  // namespace

QString lengthText(double millimetres, LengthUnit unit, int moreDecimals) {
  const auto number = [&](double value) { return QString::number(value, 'f', (value < 100.0 ? 1 : 0) + moreDecimals); };
  switch (unit) {
    case LengthUnit::Centimetres:
      return QCoreApplication::translate("Length", "%1 cm").arg(number(millimetres / 10.0));
    case LengthUnit::Inches:
      return QCoreApplication::translate("Length", "%1 in").arg(number(millimetres / 25.4));
    case LengthUnit::Automatic:
      if (millimetres >= 1000.0)
        return QCoreApplication::translate("Length", "%1 m")
            .arg(QString::number(millimetres / 1000.0, 'f', 2 + moreDecimals));
      break;
    case LengthUnit::Millimetres:
      break;
  }
  return QCoreApplication::translate("Length", "%1 mm").arg(number(millimetres));
}

double storedInterfaceScale() { return std::clamp(QSettings().value(QLatin1String(kScale), 1.0).toDouble(), 0.5, 4.0); }

Preferences::Preferences(QObject* parent) : QObject(parent) {
  const QSettings settings;
  visit(m_values, [&](const char* key, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    const QVariant stored = settings.value(QLatin1String(key));
    if (!stored.isValid()) return;
    if constexpr (std::is_enum_v<Value>)
      value = static_cast<Value>(stored.toInt());
    else
      value = stored.value<Value>();
  });
  // A settings file that somebody wrote by hand.
  m_values.theme = static_cast<ThemeChoice>(std::clamp(static_cast<int>(m_values.theme), 0, 2));
  m_values.unit = static_cast<LengthUnit>(std::clamp(static_cast<int>(m_values.unit), 0, 3));
  m_values.interfaceScale = storedInterfaceScale();
  m_values.autosaveSeconds = std::clamp(m_values.autosaveSeconds, 1, 600);
  m_values.cacheMegabytes = std::clamp(m_values.cacheMegabytes, 64, 1 << 20);
  m_values.stillSamples = std::clamp(m_values.stillSamples, 1, 4096);
}

void Preferences::set(const PreferenceValues& values) {
  if (values == m_values) return;
  m_values = values;
  QSettings settings;
  visit(m_values, [&](const char* key, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_enum_v<Value>)
      settings.setValue(QLatin1String(key), static_cast<int>(value));
    else
      settings.setValue(QLatin1String(key), value);
  });
  Q_EMIT changed();
}

}  // namespace dermis
