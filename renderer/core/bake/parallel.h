// A loop over all cores that can be cancelled.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stop_token>
#include <thread>
#include <vector>

namespace dermis {

/// Calls work(begin, end) for pieces of 0..count, from several threads; `done(share)` follows each piece from the
/// thread that did it. False where `stop` was asked before the end.
template <class Work, class Done>
bool forPieces(std::size_t count, std::size_t piece, const std::stop_token& stop, const Work& work, const Done& done) {
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> finished = 0;
  const auto loop = [&] {
    while (!stop.stop_requested()) {
      const std::size_t begin = next.fetch_add(piece);
      if (begin >= count) return;
      const std::size_t end = std::min(count, begin + piece);
      work(begin, end);
      done(static_cast<float>(finished += end - begin) / static_cast<float>(count));
    }
  };
  const std::size_t threads =
      std::min<std::size_t>((count + piece - 1) / piece, std::max(1U, std::thread::hardware_concurrency()));
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 1; i < threads; ++i) workers.emplace_back(loop);
    loop();
  }
  return !stop.stop_requested();
}

}  // namespace dermis
