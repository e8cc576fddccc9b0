// The words of the program in the user's language, where there is a translation.
#pragma once

#include <QLocale>
#include <QString>

class QCoreApplication;

namespace dermis {

/// Looks for dermis_LANGUAGE_COUNTRY.qm, then dermis_LANGUAGE.qm, and Qt's own words beside it. False where there is
/// none: the program then speaks English.
bool loadTranslation(QCoreApplication& application, const QLocale& locale, const QString& folder);
/// Where translations lie: beside the program (translations/), or where it is installed (../share/dermis/translations).
[[nodiscard]] QString translationFolder();

}  // namespace dermis
