// How long a thread itself computed: other work of the machine doesn't count, so that ratios hold under load too.
#pragma once

#include <ctime>

namespace dermis::test {

/// Seconds of the calling thread's processor time that `work` takes.
template <typename Work>
[[nodiscard]] double threadSeconds(const Work& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

}  // namespace dermis::test
