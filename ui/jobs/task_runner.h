// Work beside the event loop: decoding, resolving, writing. Results come back on the GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <exception>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace dermis {

/// What an exception means, as the end of a sentence.
[[nodiscard]] std::string reasonOf(const std::exception& error);

/// Runs each task on a thread of its own. Tasks of one lane replace each other: a new one asks the older to stop, and
/// the older one's result is dropped. All methods belong to the GUI thread.
class TaskRunner : public QObject {
  Q_OBJECT
 public:
  explicit TaskRunner(QObject* parent = nullptr) : QObject(parent) {}
  ~TaskRunner() override;

  /// `work` runs beside, `done` here with what it returned, unless the task was cancelled or replaced. `work` returns
  /// something copyable. Where it throws, `problem` is told and `broken` called instead of `done`.
  template <class Work, class Done>
  void run(const QString& lane, const QString& title, Work work, Done done, const std::function<void()>& broken = {}) {
    start(
        lane, title,
        [work = std::move(work), done = std::move(done)](std::stop_token stop) mutable -> std::function<void()> {
          auto result = std::make_shared<decltype(work(stop))>(work(stop));
          return [result, done = std::move(done)]() mutable { done(std::move(*result)); };
        },
        broken);
  }

  void cancel(const QString& lane);
  void cancelAll();
  [[nodiscard]] bool busy() const;
  [[nodiscard]] bool busy(const QString& lane) const;
  /// How far a task has come, 0..1; to be called on the GUI thread.
  void setFraction(const QString& lane, double fraction);
  /// Of the task that has come least far; −1 where none has said.
  [[nodiscard]] double fraction() const;
  /// What is being done, for the status bar; empty when idle.
  [[nodiscard]] QString title() const;

 Q_SIGNALS:
  /// A task has begun or ended.
  void activityChanged();
  /// A task has thrown: one sentence.
  void problem(const QString& sentence);

 private:
  struct Task {
    QString lane;
    QString title;
    quint64 number = 0;
    double fraction = -1.0;
    bool dropped = false;  ///< cancelled: its result is not wanted
    std::jthread thread;
  };
  void start(const QString& lane, const QString& title, std::function<std::function<void()>(std::stop_token)> work,
             std::function<void()> broken);
  void finish(quint64 number, const std::function<void()>& done);

  std::vector<std::unique_ptr<Task>> m_tasks;
  quint64 m_last = 0;
};

}  // namespace dermis
