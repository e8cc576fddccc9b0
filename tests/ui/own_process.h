// Tests of this program in a process of their own: at another scale factor of the screen, with another driver.
#pragma once

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QProcess>
#include <string>
#include <utility>
#include <vector>

namespace dermis::test {

using Variables = std::vector<std::pair<const char*, QString>>;

/// Whether all `count` tests of `filter` pass where these variables are set, within `patienceMs`.
inline testing::AssertionResult passesWith(const Variables& variables, const QString& filter, int count,
                                           int patienceMs) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  std::string what;
  for (const auto& [name, value] : variables) {
    environment.insert(QLatin1String(name), value);
    what += std::string(what.empty() ? "" : ", ") + name + "=" + value.toStdString();
  }
  process.setProcessEnvironment(environment);
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--gtest_filter=") + filter});
  if (!process.waitForFinished(patienceMs)) return testing::AssertionFailure() << what << ": no end";
  const std::string said = process.readAll().toStdString();
  const std::string passed = "[  PASSED  ] " + std::to_string(count) + " test";
  if (process.exitCode() == 0 && said.find(passed) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << what << ":\n" << said;
}

/// The same at QT_SCALE_FACTOR `factor`.
inline testing::AssertionResult passesAtScale(const char* factor, const QString& filter, int count, int patienceMs) {
  return passesWith({{"QT_SCALE_FACTOR", QLatin1String(factor)}}, filter, count, patienceMs);
}

}  // namespace dermis::test
