// Threads that work beside pictures give way to those that draw them, where a program has said so.
#include "core/base/background.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace dermis {
namespace {

int niceness() { return getpriority(PRIO_PROCESS, 0); }

/// What a thread that gives way has, and one that it starts.
std::pair<int, int> ofAThreadThatGivesWay() {
  int own = 0, child = 0;
  std::thread([&] {
    giveWay();
    own = niceness();
    std::thread([&] { child = niceness(); }).join();
  }).join();
  return {own, child};
}

TEST(Background, ThreadsGiveWayWherePicturesComeFirst) {
  const int before = niceness();
  EXPECT_EQ(ofAThreadThatGivesWay(), std::pair(before, before)) << "a command waits for its work";
  putPicturesFirst();
  const int expected = std::max(before, 10);
  EXPECT_EQ(ofAThreadThatGivesWay(), std::pair(expected, expected));
  EXPECT_EQ(niceness(), before) << "the thread that draws stays as it was";
}

}  // namespace
}  // namespace dermis
