#include "gl/job_queue.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

namespace dermis::gl {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

class CallableJob : public Job {
 public:
  CallableJob(std::string text, std::function<Result<bool>()> step, std::function<double()> fraction)
      : m_text(std::move(text)), m_step(std::move(step)), m_fraction(std::move(fraction)) {}
  Result<bool> step() override { return m_step(); }
  std::string text() const override { return m_text; }
  double fraction() const override { return m_fraction ? m_fraction() : 0.0; }

 private:
  std::string m_text;
  std::function<Result<bool>()> m_step;
  std::function<double()> m_fraction;
};

}  // namespace

std::unique_ptr<Job> makeJob(std::string text, std::function<Result<bool>()> step, std::function<double()> fraction) {
  return std::make_unique<CallableJob>(std::move(text), std::move(step), std::move(fraction));
}

void JobQueue::add(Kind kind, std::unique_ptr<Job> job) {
  cancel(kind);
  insert({std::move(kind), std::move(job), false}, false);
}

void JobQueue::addLast(Kind kind, std::unique_ptr<Job> job) {
  cancel(kind);
  insert({std::move(kind), std::move(job), true}, false);
}

void JobQueue::insert(Entry entry, bool inFront) {
  const auto firstLast = std::find_if(m_jobs.begin(), m_jobs.end(), [](const Entry& e) { return e.last; });
  const auto place = entry.last ? (inFront ? firstLast : m_jobs.end()) : (inFront ? m_jobs.begin() : firstLast);
  m_jobs.insert(place, std::move(entry));
}

void JobQueue::cancel(const Kind& kind) {
  std::erase_if(m_jobs, [&](const auto& entry) { return entry.kind == kind; });
}

Result<void> JobQueue::runSlice() {
  const Clock::time_point start = Clock::now();
  // Out of the queue while it runs: a job may add others.
  Entry entry = std::move(m_jobs.front());
  m_jobs.pop_front();
  const Result<bool> done = entry.job->step();
  glFinish();
  m_longestSliceMs = std::max(m_longestSliceMs, millisecondsSince(start));
  if (!done) return tl::unexpected(done.error());
  const bool replaced =
      std::any_of(m_jobs.begin(), m_jobs.end(), [&](const Entry& other) { return other.kind == entry.kind; });
  if (!*done && !replaced) insert(std::move(entry), true);
  return {};
}

bool JobQueue::run(double budgetMs, Warnings& messages) {
  const Clock::time_point start = Clock::now();
  do {
    if (m_jobs.empty()) return false;
    if (auto slice = runSlice(); !slice) messages.push_back(slice.error().message);
  } while (millisecondsSince(start) < budgetMs);
  return !m_jobs.empty();
}

Result<void> JobQueue::finish() {
  Result<void> outcome;
  while (!m_jobs.empty())
    if (auto slice = runSlice(); !slice && outcome) outcome = slice;
  return outcome;
}

std::pair<std::string, double> JobQueue::progress() const {
  if (m_jobs.empty()) return {};
  return {m_jobs.front().job->text(), m_jobs.front().job->fraction()};
}

}  // namespace dermis::gl
