// How Loading runs its work beside the event loop; for its own source files.
#pragma once

#include <cmath>

#include "ui/document/loading.h"

namespace dermis {

template <class Work, class Done>
void Loading::run(const QString& lane, const QString& title, Work work, Done done, std::function<void()> failed) {
  using Value = typename std::invoke_result_t<Work, const ResolveOptions&, Warnings&>::value_type;
  m_tasks.run(
      lane, title,
      [work = std::move(work), cache = m_cache, tasks = &m_tasks, lane](std::stop_token stop) {
        ResolveOptions options;
        // The runner waits for its tasks before it goes.
        options.progress = [tasks, lane, last = -1.0](std::string_view, double fraction) mutable {
          if (std::abs(fraction - last) < 0.01) return;
          last = fraction;
          QMetaObject::invokeMethod(
              tasks, [tasks, lane, fraction] { tasks->setFraction(lane, fraction); }, Qt::QueuedConnection);
        };
        options.stop = std::move(stop);
        options.cache = cache;
        options.keepMissingMaps = true;
        Warnings warnings;
        Result<Value> result = work(options, warnings);
        return Outcome<Value>{std::move(result), std::move(warnings)};
      },
      [this, done = std::move(done), failed](Outcome<Value> outcome) mutable {
        tellWarnings(outcome.warnings);
        if (!outcome.result) {
          if (outcome.result.error().kind != Error::Kind::Cancelled)
            Q_EMIT message(MessageKind::Error, QString::fromStdString(outcome.result.error().message));
          if (failed) failed();
          return;
        }
        done(std::move(*outcome.result));
      },
      failed);
}

}  // namespace dermis
