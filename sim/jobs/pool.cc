#include "sim/jobs/pool.h"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <memory>

#include "controller/base/check.h"

namespace dockyard {
namespace {

struct Running {
  std::size_t index = 0;
  std::unique_ptr<Child> child;  // kills the process where it still runs
};

/// Sleeps until a child or a signal reports, a child's time is over, or a second has
/// passed.
void WaitForNews(const std::vector<Running>& running, const SignalQueue& signals) {
  std::vector<pollfd> watched{{signals.descriptor(), POLLIN, 0}};
  double patience_s = 1.0;  // the clock of a live progress line
  for (const Running& one : running) {
    watched.push_back({one.child->descriptor(), POLLIN, 0});
    patience_s = std::min(patience_s, std::max(0.0, one.child->seconds_left()));
  }
  const int got =
      ::poll(watched.data(), watched.size(), static_cast<int>(std::ceil(1000.0 * patience_s)));
  DOCKYARD_CHECK(got >= 0 || errno == EINTR);
}

void TakeEnded(std::vector<Running>& running,
               const std::function<void(std::size_t, const Child::End&)>& take) {
  for (Running& one : running) {
    one.child->KillIfLate();
    if (!one.child->Read()) continue;
    take(one.index, one.child->Finish());
    one.child.reset();
  }
  running.erase(std::remove_if(running.begin(), running.end(),
                               [](const Running& one) { return one.child == nullptr; }),
                running.end());
}

}  // namespace

int RunPool(const PoolOptions& options, SignalQueue& signals,
            const std::function<std::optional<Job>()>& next,
            const std::function<void(std::size_t index, const Child::End& end)>& take) {
  DOCKYARD_CHECK(options.processes >= 1 && options.time_limit_s > 0.0);
  std::vector<int> close_in_child = options.close_in_child;
  close_in_child.push_back(signals.descriptor());
  std::vector<Running> running;
  bool more = true;
  for (;;) {
    while (more && static_cast<int>(running.size()) < options.processes) {
      const std::optional<Job> job = next();
      more = job.has_value();
      if (!more) break;
      running.push_back(
          {job->index, std::make_unique<Child>(job->work, job->messages, options.time_limit_s,
                                               close_in_child)});
    }
    if (running.empty()) return 0;
    if (options.waiting) options.waiting(static_cast<int>(running.size()));
    WaitForNews(running, signals);
    TakeEnded(running, take);
    if (const int signal = signals.Take(); signal != 0) return signal;
  }
}

}  // namespace dockyard
