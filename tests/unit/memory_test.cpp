// What was freed between things that stay goes back to the system.
#include "core/base/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <memory>
#include <vector>

namespace dermis {
namespace {

double residentMiB() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

TEST(Memory, WhatWasFreedGoesBack) {
#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "another allocator";
#endif
  if (residentMiB() <= 0.0) GTEST_SKIP() << "this system doesn't say how much is resident";
  constexpr std::size_t kPieces = 32768, kBytes = 4000;  // each too small for a mapping of its own, 125 MiB together
  giveMemoryBack();                                      // what other tests have left would be used again
  const double before = residentMiB();
  std::vector<std::unique_ptr<char[]>> pieces(kPieces);
  for (auto& piece : pieces) {
    piece = std::make_unique<char[]>(kBytes);
    std::memset(piece.get(), 1, kBytes);
  }
  // The last stays: what lies below it can't go by itself.
  for (std::size_t i = 0; i + 1 < kPieces; ++i) pieces[i].reset();
  const double freed = residentMiB();
  ASSERT_GT(freed, before + 100.0) << "or this says nothing";
  giveMemoryBack();
  EXPECT_LT(residentMiB(), before + 10.0);
}

}  // namespace
}  // namespace dermis
