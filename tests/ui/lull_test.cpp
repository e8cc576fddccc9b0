// Samples of a resting picture leave the event loop to whoever asks something.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "ui/viewport/lull.h"

namespace dermis {
namespace {

constexpr double kPictureMs = 800.0;

TEST(Lull, IsShortWhereNobodyAsks) {
  Lull lull;
  QSignalSpy quiet(&lull, &Lull::quiet);
  QElapsedTimer clock;
  clock.start();
  lull.start(kPictureMs);
  ASSERT_TRUE(quiet.wait(5000));
  EXPECT_GE(clock.elapsed(), 37);  // 40, and a coarse timer may be a twentieth early
}

TEST(Lull, LastsAsLongAsSomebodyAsksButNoLongerThanAPicture) {
  // QTest::qWaitFor would sleep between the questions. On a machine that gives this process no time for a while, nobody
  // seems to ask: one lull of ten has to last.
  bool lasted = false;
  for (int i = 0; i < 10 && !lasted; ++i) {
    Lull lull;
    QSignalSpy quiet(&lull, &Lull::quiet);
    QTimer questions;
    QElapsedTimer clock;
    questions.start(0);
    clock.start();
    lull.start(kPictureMs);
    ASSERT_TRUE(quiet.wait(20000)) << "it ends though the questions don't";
    lasted = clock.elapsed() >= static_cast<int>(kPictureMs);
  }
  EXPECT_TRUE(lasted);
}

}  // namespace
}  // namespace dermis
