#include "gl/gpu_timer.h"

#include <chrono>
#include <ctime>
#include <utility>

namespace dermis::gl {

namespace {
constexpr std::size_t kFramesInFlight = 4;
}

double GpuTimer::nowMs() const {
  if (!m_alone) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
  }
  glFinish();
  // std::clock() counts all threads of the process, as this does, but in microseconds that may wrap.
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

GpuTimer::Scope::Scope(GpuTimer& timer, std::string name) : m_timer(timer), m_startMs(timer.nowMs()) {
  if (timer.m_frames.empty()) timer.m_frames.emplace_back();
  Entry entry;
  entry.times.name = std::move(name);
  if (timer.m_spare.empty()) {
    entry.query = Query::create(GL_TIME_ELAPSED);
  } else {
    entry.query = std::move(timer.m_spare.back());
    timer.m_spare.pop_back();
  }
  glBeginQuery(GL_TIME_ELAPSED, entry.query.id());
  timer.m_frames.back().push_back(std::move(entry));
}

GpuTimer::Scope::~Scope() {
  glEndQuery(GL_TIME_ELAPSED);
  m_timer.m_frames.back().back().times.cpuMs = m_timer.nowMs() - m_startMs;
}

bool GpuTimer::collect(Frame& frame, bool wait) {
  if (!wait && !frame.empty()) {
    GLint ready = 0;
    glGetQueryObjectiv(frame.back().query.id(), GL_QUERY_RESULT_AVAILABLE, &ready);
    if (ready == 0) return false;
  }
  m_latest.clear();
  for (Entry& entry : frame) {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(entry.query.id(), GL_QUERY_RESULT, &nanoseconds);
    entry.times.gpuMs = static_cast<double>(nanoseconds) * 1e-6;
    m_latest.push_back(entry.times);
    m_spare.push_back(std::move(entry.query));
  }
  return true;
}

void GpuTimer::beginFrame() {
  // Keep a few frames in flight; past that take the oldest in, waiting if it must be.
  while (!m_frames.empty() && collect(m_frames.front(), m_frames.size() >= kFramesInFlight)) m_frames.pop_front();
  m_frames.emplace_back();
}

void GpuTimer::finish() {
  for (Frame& frame : m_frames) collect(frame, true);
  m_frames.clear();
}

}  // namespace dermis::gl
