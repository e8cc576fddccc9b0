// GPU and CPU time of each pass of a frame, without waiting for the GPU.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "gl/gl_objects.h"

namespace dermis::gl {

/// Times of one pass, milliseconds.
struct TimedPass {
  std::string name;
  double gpuMs = 0.0;
  double cpuMs = 0.0;
};

/// Call beginFrame(), then pass(name) around each pass. Results are of the latest frame whose queries have arrived.
class GpuTimer {
 public:
  /// Ends its pass when it goes out of scope. Passes don't nest: GL has one elapsed-time query at a time.
  class Scope {
   public:
    Scope(GpuTimer& timer, std::string name);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    GpuTimer& m_timer;
    double m_startMs;
  };

  /// From now on each pass waits for what came before and for its own end, and its cpuMs is what all threads of the
  /// process spent on it: on software GL, what it costs.
  void timeAlone() { m_alone = true; }
  void beginFrame();
  [[nodiscard]] Scope pass(std::string name) { return {*this, std::move(name)}; }
  /// Of the latest frame that is complete.
  [[nodiscard]] const std::vector<TimedPass>& passes() const { return m_latest; }
  /// Waits for all frames in flight; then passes() is of the last one.
  void finish();

 private:
  struct Entry {
    TimedPass times;
    Query query;
  };
  using Frame = std::vector<Entry>;
  bool collect(Frame& frame, bool wait);
  [[nodiscard]] double nowMs() const;

  bool m_alone = false;
  std::deque<Frame> m_frames;  ///< in flight, the current one last
  std::vector<Query> m_spare;
  std::vector<TimedPass> m_latest;
};

}  // namespace dermis::gl
