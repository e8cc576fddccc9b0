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
  const QSignalSpy quiet(&lull, &Lull::quiet);
  QElapsedTimer clock;
  clock.start();
  lull.start(kPictureMs);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !quiet.isEmpty(); }, 5000));
  EXPECT_GE(clock.elapsed(), 39);
}

TEST(Lull, LastsAsLongAsSomebodyAsksButNoLongerThanAPicture) {
  Lull lull;
  const QSignalSpy quiet(&lull, &Lull::quiet);
  QTimer questions;
  QElapsedTimer clock;
  questions.start(2);
  clock.start();
  lull.start(kPictureMs);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !quiet.isEmpty(); }, 20000));
  EXPECT_GE(clock.elapsed(), static_cast<int>(kPictureMs));
}

}  // namespace
}  // namespace dermis
