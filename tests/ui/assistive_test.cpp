// The program through AT-SPI, as a screen reader uses it: assistive.py beside this file does the work.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QProcess>
#include <QStandardPaths>

namespace dermis {
namespace {

TEST(AssistiveTechnology, FindsEveryControlByNameSetsTenParametersAndSavesAPreset) {
  const QString session = QStandardPaths::findExecutable(QStringLiteral("dbus-run-session"));
  const QString python = QStringLiteral("/usr/bin/python3");  // where Debian's modules are
  if (session.isEmpty() || QProcess::execute(python, {QStringLiteral("-c"), QStringLiteral("import pyatspi")}) != 0)
    GTEST_SKIP() << "dbus-run-session or python3-pyatspi is not installed";
  QProcess script;
  script.setProcessChannelMode(QProcess::MergedChannels);
  script.start(session, {QStringLiteral("--"), python, QStringLiteral(DERMIS_SOURCE_DIR "/tests/ui/assistive.py"),
                         QCoreApplication::applicationDirPath() + QStringLiteral("/dermis")});
  ASSERT_TRUE(script.waitForFinished(180000));
  EXPECT_EQ(script.exitCode(), 0) << script.readAll().toStdString();
}

}  // namespace
}  // namespace dermis
