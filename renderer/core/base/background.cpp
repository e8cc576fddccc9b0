#include "core/base/background.h"

#include <sys/resource.h>

#include <atomic>

namespace dermis {
namespace {

std::atomic<bool> picturesComeFirst{false};

}  // namespace

void putPicturesFirst() { picturesComeFirst = true; }

void giveWay() {
#ifdef __linux__
  // Counted by thread there, and threads have that of the one that starts them; elsewhere it is the whole process's.
  constexpr int kNice = 10;
  if (picturesComeFirst) setpriority(PRIO_PROCESS, 0, kNice);
#endif
}

}  // namespace dermis
