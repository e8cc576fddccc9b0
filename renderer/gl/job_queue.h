// Long GPU work cut into slices, run between frames so that the window keeps answering.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "core/base/result.h"

namespace dermis::gl {

/// One piece of long work. A slice should take at most about 8 ms of the GPU (or of the software rasteriser).
class Job {
 public:
  virtual ~Job() = default;
  /// Does one slice; true when the job is done. Errors: the job ends there and is dropped.
  [[nodiscard]] virtual Result<bool> step() = 0;
  [[nodiscard]] virtual std::string text()
      const = 0;  ///< what is going on, for a progress bar: "Prefiltering studio.hdr"
  [[nodiscard]] virtual double fraction() const = 0;  ///< 0..1
};

/// A job made of a callable that returns true when done.
[[nodiscard]] std::unique_ptr<Job> makeJob(std::string text, std::function<Result<bool>()> step,
                                           std::function<double()> fraction = {});

/// Runs jobs one after another, in the order they came, on the GL thread.
class JobQueue {
 public:
  /// What a job is for; adding one of the same kind replaces those queued or running (the last choice counts).
  using Kind = std::string;

  void add(Kind kind, std::unique_ptr<Job> job);
  /// The same for what only makes a picture better that could be shown already: it comes after all others.
  void addLast(Kind kind, std::unique_ptr<Job> job);
  /// Runs slices for about `budgetMs`, at least one; waits for each slice's GPU work, since a software renderer does
  /// nothing before it is asked for results. True while jobs are left. Errors go to `messages`.
  bool run(double budgetMs, Warnings& messages);
  /// Completes everything. Errors: the first that a job reported; the others are still completed.
  [[nodiscard]] Result<void> finish();
  void cancel() { m_jobs.clear(); }
  void cancel(const Kind& kind);

  [[nodiscard]] bool idle() const { return m_jobs.empty(); }
  /// Whether nothing is left but what addLast() took.
  [[nodiscard]] bool onlyLastLeft() const { return m_jobs.empty() || m_jobs.front().last; }
  /// Text and fraction of the job in progress; empty when idle.
  [[nodiscard]] std::pair<std::string, double> progress() const;
  /// The longest slice so far in milliseconds.
  [[nodiscard]] double longestSliceMs() const { return m_longestSliceMs; }

 private:
  struct Entry {
    Kind kind;
    std::unique_ptr<Job> job;
    bool last = false;
  };
  /// Puts an entry in front of (or behind) those of its sort.
  void insert(Entry entry, bool inFront);
  Result<void> runSlice();

  std::deque<Entry> m_jobs;
  double m_longestSliceMs = 0.0;
};

}  // namespace dermis::gl
