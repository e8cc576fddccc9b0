#include "ui/translation.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QTranslator>
#include <string>

namespace dermis {
namespace {

/// What a translation to English would hold: nothing but plurals, all of them made with an s.
class EnglishPlurals final : public QTranslator {
 public:
  using QTranslator::QTranslator;
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* /*context*/, const char* source, const char* /*disambiguation*/,
                                  int count) const override {
    const QString english = QString::fromUtf8(source);
    if (count < 0 || !english.contains(QLatin1String("(s)"))) return {};
    return QString(english).replace(QLatin1String("(s)"), QLatin1String(count == 1 ? "" : "s"));
  }
};

}  // namespace

bool loadTranslation(QCoreApplication& application, const QLocale& locale, const QString& folder) {
  // First, because the translator installed last is asked first.
  QCoreApplication::installTranslator(new EnglishPlurals(&application));
  auto* ours = new QTranslator(&application);
  if (!ours->load(locale, QStringLiteral("dermis"), QStringLiteral("_"), folder)) {
    delete ours;
    return false;
  }
  // Qt's words first, for the same reason.
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
