#include "sim/jobs/pool.h"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <memory>

#include "controller/base/check.h"
#include "sim/base/descendants.h"

namespace dockyard {
namespace {

/// Where one worker works.
struct Place {
  std::unique_ptr<Worker> worker;  // kills the process where it still runs
  std::optional<Job> job;          // under way
  int attempts = 0;                // at the job
};

class Pool {
 public:
  Pool(const PoolOptions& options, const PoolCalls& calls, int signal_descriptor)
      : options_(options),
        calls_(calls),
        signal_descriptor_(signal_descriptor),
        places_(static_cast<std::size_t>(options.workers)) {}

  ~Pool() {
    places_.clear();
    started_.End();
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// Gives each free place a job, while there are any.
  void Fill() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i].job) continue;
      places_[i].job = calls_.next(static_cast<int>(i));
      if (!places_[i].job) return;
      places_[i].attempts = 0;
      Attempt(i);
    }
  }

  int running() const {
    return static_cast<int>(std::count_if(
        places_.begin(), places_.end(), [](const Place& place) { return place.job.has_value(); }));
  }

  /// Sleeps until a worker or a signal reports, a job's time is over, or a fifth of a second has
  /// passed: the clock of the caller's own work.
  void WaitForNews() {
    using Clock = std::chrono::steady_clock;
    std::vector<pollfd> watched{{signal_descriptor_, POLLIN, 0}};
    double patience_s = 0.2;
    for (const Place& place : places_) {
      if (!place.job) continue;
      watched.push_back({place.worker->descriptor(), POLLIN, 0});
      patience_s = std::min(patience_s, std::max(0.0, place.worker->seconds_left()));
    }
    const auto before = Clock::now();
    const int got =
        ::poll(watched.data(), watched.size(), static_cast<int>(std::ceil(1000.0 * patience_s)));
    DOCKYARD_CHECK(got >= 0 || errno == EINTR);
    // Far beyond its patience only when this process itself was stopped, or the machine asleep: the
    // jobs stood still too.
    const std::chrono::duration<double> waited = Clock::now() - before;
    if (waited.count() < patience_s + 1.0) return;
    for (Place& place : places_) {
      if (place.job) place.worker->Extend(waited.count());
    }
  }

  void TakeEnded() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      Place& place = places_[i];
      if (!place.job) continue;
      place.worker->KillIfLate();
      if (!place.worker->Read()) continue;
      const JobEnd end = place.worker->Finish();
      if (!place.worker->usable()) {
        place.worker.reset();
        EndOrphans();
      }
      if (end.loss != Loss::kNone && place.attempts <= options_.retries) {
        Attempt(i);
        continue;
      }
      const Job job = *place.job;
      place.job.reset();
      calls_.take(job, static_cast<int>(i), end);
    }
  }

 private:
  /// Ends what a worker that is gone had started.
  void EndOrphans() {
    std::vector<pid_t> workers;
    for (const Place& place : places_) {
      if (place.worker) workers.push_back(place.worker->process());
    }
    started_.End(workers);
  }

  void Attempt(std::size_t i) {
    Place& place = places_[i];
    if (calls_.prepare) calls_.prepare(*place.job, static_cast<int>(i));
    if (!place.worker) place.worker = NewWorker();
    ++place.attempts;
    place.worker->Start(place.job->number, place.job->messages);
  }

  std::unique_ptr<Worker> NewWorker() const {
    std::vector<int> close = options_.close_in_worker;
    close.push_back(signal_descriptor_);
    for (const Place& other : places_) {
      if (!other.worker) continue;
      for (const int descriptor : other.worker->descriptors()) close.push_back(descriptor);
    }
    return std::make_unique<Worker>(calls_.work, options_.limits, close);
  }

  const PoolOptions& options_;
  const PoolCalls& calls_;
  int signal_descriptor_;
  Descendants started_;
  std::vector<Place> places_;
};

}  // namespace

int RunPool(const PoolOptions& options, SignalQueue& signals, const PoolCalls& calls) {
  DOCKYARD_CHECK(options.workers >= 1 && options.retries >= 0);
  DOCKYARD_CHECK(options.limits.wall_s > 0.0 && options.limits.memory_mib > 0);
  Pool pool(options, calls, signals.descriptor());
  for (;;) {
    pool.Fill();
    if (pool.running() == 0) return 0;
    if (options.waiting) options.waiting(pool.running());
    pool.WaitForNews();
    if (const int signal = signals.Take(); signal != 0) return signal;
    pool.TakeEnded();
  }
}

}  // namespace dockyard
