#include "ui/translation.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QTranslator>
#include <string>

namespace dermis {

bool loadTranslation(QCoreApplication& application, const QLocale& locale, const QString& folder) {
  auto* ours = new QTranslator(&application);
  if (!ours->load(locale, QStringLiteral("dermis"), QStringLiteral("_"), folder)) {
    delete ours;
    return false;
  }
  // Qt's words first: where both have one, the translator installed last is asked first.
  auto* qts = new QTranslator(&application);
  if (qts->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(qts);
  else
    delete qts;
  return QCoreApplication::installTranslator(ours);
}

QString tableText(std::string_view english) {
  return QCoreApplication::translate("tables", std::string(english).c_str());
}

QString translationFolder() {
  const QString program = QCoreApplication::applicationDirPath();
  const QString beside = program + QStringLiteral("/translations");
  return QFileInfo::exists(beside) ? beside : program + QStringLiteral("/../share/dermis/translations");
}

}  // namespace dermis
