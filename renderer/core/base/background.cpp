#include "core/base/background.h"

#include <sys/resource.h>

#include <atomic>

namespace dermis {
namespace {

std::atomic<bool> picturesComeFirst{false};

}  // namespace

void putPicturesFirst() { picturesComeFirst = true; }

void giveWay() {
  constexpr int kNice = 10;
  // Linux counts it by thread, and threads have that of the one that starts them.
  if (picturesComeFirst) setpriority(PRIO_PROCESS, 0, kNice);
}

}  // namespace dermis
