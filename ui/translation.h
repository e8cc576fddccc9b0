// The words of the program in the user's language, where there is a translation.
#pragma once

#include <QLocale>
#include <QString>
#include <string_view>

class QCoreApplication;

namespace dermis {

/// Looks for dermis_LANGUAGE_COUNTRY.qm, then dermis_LANGUAGE.qm, and Qt's own words beside it. False where there is
/// none: the program then speaks English, "1 file" and "2 files" where the source has "%n file(s)".
bool loadTranslation(QCoreApplication& application, const QLocale& locale, const QString& folder);
/// Where translations lie: beside the program (translations/), or where it is installed (../share/dermis/translations).
[[nodiscard]] QString translationFolder();
/// A label, group or sentence of the core's tables in the user's language. They stand there in English, because the
/// core knows no Qt; packaging/translations.sh collects them.
[[nodiscard]] QString tableText(std::string_view english);

}  // namespace dermis
