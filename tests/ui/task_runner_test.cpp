// What the status bar says of work beside the event loop.
#include "ui/jobs/task_runner.h"

#include <gtest/gtest.h>

#include <QTest>
#include <atomic>

namespace dermis {
namespace {

TEST(TaskRunnerTitles, WorkWithoutATitleIsNotNamed) {
  TaskRunner tasks;
  std::atomic<bool> go = false;
  const auto wait = [&go](const std::stop_token&) {
    while (!go) std::this_thread::yield();
    return 0;
  };
  tasks.run(QStringLiteral("quiet"), QString(), wait, [](int) {});
  EXPECT_TRUE(tasks.busy());
  EXPECT_EQ(tasks.title(), QString());
  tasks.run(QStringLiteral("a"), QStringLiteral("Loading maps"), wait, [](int) {});
  EXPECT_EQ(tasks.title(), QStringLiteral("Loading maps"));
  tasks.run(QStringLiteral("b"), QStringLiteral("Lighting"), wait, [](int) {});
  EXPECT_EQ(tasks.title(), QStringLiteral("Loading maps · Lighting"));
  go = true;
  EXPECT_TRUE(QTest::qWaitFor([&] { return !tasks.busy(); }, 5000));
  EXPECT_EQ(tasks.title(), QString());
}

}  // namespace
}  // namespace dermis
