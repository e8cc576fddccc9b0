#include "ui/jobs/task_runner.h"

#include <algorithm>
#include <new>

#include "core/base/background.h"

namespace dermis {

std::string reasonOf(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is not enough memory for it; close other programs, or use a smaller file";
  return error.what();
}

TaskRunner::~TaskRunner() {
  // Ask all of them first, so that they stop side by side; the threads' destructors then wait.
  for (const auto& task : m_tasks) task->thread.request_stop();
}

void TaskRunner::start(const QString& lane, const QString& title,
                       std::function<std::function<void()>(std::stop_token)> work, std::function<void()> broken) {
  cancel(lane);
  auto task = std::make_unique<Task>();
  task->lane = lane;
  task->title = title;
  task->number = ++m_last;
  const quint64 number = task->number;
  task->thread = std::jthread(
      [this, number, title, work = std::move(work), broken = std::move(broken)](std::stop_token stop) mutable {
        giveWay();
        std::function<void()> done;
        try {
          done = work(stop);
        } catch (const std::exception& error) {
          done = [this, title, broken = std::move(broken), why = QString::fromStdString(reasonOf(error))] {
            Q_EMIT problem(tr("%1 did not succeed: %2.").arg(title, why));
            if (broken) broken();
          };
        }
        QMetaObject::invokeMethod(
            this, [this, number, done = std::move(done)] { finish(number, done); }, Qt::QueuedConnection);
      });
  m_tasks.push_back(std::move(task));
  Q_EMIT activityChanged();
}

void TaskRunner::finish(quint64 number, const std::function<void()>& done) {
  const auto found =
      std::find_if(m_tasks.begin(), m_tasks.end(), [&](const auto& task) { return task->number == number; });
  if (found == m_tasks.end()) return;
  const std::unique_ptr<Task> task = std::move(*found);
  m_tasks.erase(found);
  if (!task->dropped) done();
  Q_EMIT activityChanged();
}

void TaskRunner::cancel(const QString& lane) {
  bool any = false;
  for (const auto& task : m_tasks) {
    if (task->lane != lane || task->dropped) continue;
    task->dropped = true;
    task->thread.request_stop();
    any = true;
  }
  if (any) Q_EMIT activityChanged();
}

void TaskRunner::cancelAll() {
  for (const auto& task : m_tasks) {
    task->dropped = true;
    task->thread.request_stop();
  }
  Q_EMIT activityChanged();
}

bool TaskRunner::busy() const {
  return std::any_of(m_tasks.begin(), m_tasks.end(), [](const auto& task) { return !task->dropped; });
}

bool TaskRunner::busy(const QString& lane) const {
  return std::any_of(m_tasks.begin(), m_tasks.end(),
                     [&](const auto& task) { return !task->dropped && task->lane == lane; });
}

void TaskRunner::setFraction(const QString& lane, double fraction) {
  for (const auto& task : m_tasks)
    if (!task->dropped && task->lane == lane) task->fraction = fraction;
  Q_EMIT activityChanged();
}

double TaskRunner::fraction() const {
  double least = -1.0;
  for (const auto& task : m_tasks)
    if (!task->dropped && task->fraction >= 0.0) least = least < 0.0 ? task->fraction : std::min(least, task->fraction);
  return least;
}

QString TaskRunner::title() const {
  QStringList titles;
  for (const auto& task : m_tasks)
    if (!task->dropped && !task->title.isEmpty()) titles << task->title;
  return titles.join(QStringLiteral(" · "));
}

}  // namespace dermis
