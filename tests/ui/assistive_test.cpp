// The program from outside, as a screen reader meets it: over D-Bus, while it draws.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QProcess>
#include <QStandardPaths>

namespace dermis {
namespace {

/// What a script prints, and how it ended; nothing where it could not be run.
struct Outcome {
  int code = -1;
  std::string said;
};

Outcome runScript(const QStringList& words, int patienceMs) {
  QProcess process;
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(QStringLiteral("dbus-run-session"), QStringList{QStringLiteral("--")} + words);
  Outcome outcome;
  if (process.waitForFinished(patienceMs) && process.exitStatus() == QProcess::NormalExit)
    outcome.code = process.exitCode();
  else
    process.kill();
  outcome.said = process.readAll().toStdString();
  return outcome;
}

TEST(Assistive, AScreenReaderFindsEveryControlSetsTenParametersAndSavesAPreset) {
  const QString python = QStringLiteral("/usr/bin/python3");
  if (QStandardPaths::findExecutable(QStringLiteral("dbus-run-session")).isEmpty() ||
      runScript({python, QStringLiteral("-c"), QStringLiteral("import pyatspi")}, 20000).code != 0)
    GTEST_SKIP() << "dbus-daemon or python3-pyatspi is not installed";
  QElapsedTimer clock;
  clock.start();
  const Outcome outcome = runScript(
      {python, QStringLiteral(DERMIS_SOURCE_DIR "/tests/ui/assistive.py"), QStringLiteral(DERMIS_BINARY)}, 300000);
  EXPECT_EQ(outcome.code, 0) << outcome.said;
  EXPECT_NE(outcome.said.find("10 of 10 parameters"), std::string::npos) << outcome.said;
  RecordProperty("seconds", static_cast<int>(clock.elapsed() / 1000));
}

}  // namespace
}  // namespace dermis
