// What a person chose once for all scenes; kept in the program's settings.
#pragma once

#include <QObject>
#include <QStringList>

#include "ui/theme/theme.h"

namespace dermis {

/// In which the program shows lengths of the model; materials always count in millimetres.
enum class LengthUnit { Automatic, Millimetres, Centimetres, Inches };
/// "118.2 mm", "11.8 cm"; automatic: metres from a metre on.
[[nodiscard]] QString lengthText(double millimetres, LengthUnit unit, int moreDecimals = 0);

struct PreferenceValues {
  ThemeChoice theme = ThemeChoice::Dark;
  double interfaceScale = 1.0;  ///< on top of the screen's own; from the next start
  LengthUnit unit = LengthUnit::Automatic;
  int autosaveSeconds = 2;
  int cacheMegabytes = 2048;
  int stillSamples = 64;
  bool statistics = true;
  QStringList presetFolders;  ///< beside the program's own
  QStringList environmentFolders;
  bool operator==(const PreferenceValues&) const = default;
};

/// The interface scale alone, to be asked before there is a QApplication.
[[nodiscard]] double storedInterfaceScale();

class Preferences : public QObject {
  Q_OBJECT
 public:
  /// Reads what is stored.
  explicit Preferences(QObject* parent = nullptr);
  [[nodiscard]] const PreferenceValues& values() const { return m_values; }
  /// Stores them.
  void set(const PreferenceValues& values);

 Q_SIGNALS:
  void changed();

 private:
  PreferenceValues m_values;
};

}  // namespace dermis
