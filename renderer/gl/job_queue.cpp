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
  m_jobs.emplace_back(std::move(kind), std::move(job));
}

void JobQueue::cancel(const Kind& kind) {
  std::erase_if(m_jobs, [&](const auto& entry) { return entry.first == kind; });
}

Result<void> JobQueue::runSlice() {
  const Clock::time_point start = Clock::now();
  // Out of the queue while it runs: a job may add others.
  auto [kind, job] = std::move(m_jobs.front());
  m_jobs.pop_front();
  const Result<bool> done = job->step();
  glFinish();
  m_longestSliceMs = std::max(m_longestSliceMs, millisecondsSince(start));
  if (!done) return tl::unexpected(done.error());
  const bool replaced =
      std::any_of(m_jobs.begin(), m_jobs.end(), [&kind = kind](const auto& entry) { return entry.first == kind; });
  if (!*done && !replaced) m_jobs.emplace_front(std::move(kind), std::move(job));
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
  return {m_jobs.front().second->text(), m_jobs.front().second->fraction()};
}

}  // namespace dermis::gl
