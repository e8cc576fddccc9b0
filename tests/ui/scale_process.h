// Tests of this program in a process of their own, at another scale factor of the screen.
#pragma once

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QProcess>
#include <string>

namespace dermis::test {

/// Whether all `count` tests of `filter` pass at QT_SCALE_FACTOR `factor`, within `patienceMs`.
inline testing::AssertionResult passesAtScale(const char* factor, const QString& filter, int count, int patienceMs) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QLatin1String(factor));
  process.setProcessEnvironment(environment);
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--gtest_filter=") + filter});
  if (!process.waitForFinished(patienceMs)) return testing::AssertionFailure() << factor << ": no end";
  const std::string said = process.readAll().toStdString();
  const std::string passed = "[  PASSED  ] " + std::to_string(count) + " test";
  if (process.exitCode() == 0 && said.find(passed) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << factor << ":\n" << said;
}

}  // namespace dermis::test
