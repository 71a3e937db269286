#include "sim/campaign/campaign.h"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <memory>
#include <set>
#include <vector>

#include "controller/base/check.h"

namespace dockyard {
namespace {

/// While it lives, SIGINT, SIGTERM and SIGHUP wait here instead of ending the program.
class SignalQueue {
 public:
  SignalQueue() {
    sigset_t caught;
    sigemptyset(&caught);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&caught, signal);
    sigprocmask(SIG_BLOCK, &caught, &before_);
    descriptor_ = ::signalfd(-1, &caught, SFD_NONBLOCK | SFD_CLOEXEC);
    DOCKYARD_CHECK(descriptor_ >= 0);
  }
  ~SignalQueue() {
    ::close(descriptor_);
    sigprocmask(SIG_SETMASK, &before_, nullptr);
  }
  SignalQueue(const SignalQueue&) = delete;
  SignalQueue& operator=(const SignalQueue&) = delete;

  int descriptor() const { return descriptor_; }
  /// The number of the signal that came, or 0.
  int Take() {
    signalfd_siginfo info{};
    const ssize_t count = ::read(descriptor_, &info, sizeof info);
    return count == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
  }

 private:
  sigset_t before_{};
  int descriptor_ = -1;
};

using Workers = std::vector<std::unique_ptr<Worker>>;

std::vector<const CampaignRun*> RunsToDo(const Campaign& campaign, const FinishedRuns& finished) {
  std::vector<const CampaignRun*> todo;
  for (const CampaignRun& run : campaign.runs) {
    if (finished.count(run.run) == 0) todo.push_back(&run);
  }
  return todo;
}

/// Sleeps until a worker or a signal has something to say, or a worker's time is over.
void WaitForNews(const Workers& workers, const SignalQueue& signals) {
  std::vector<pollfd> watched{{signals.descriptor(), POLLIN, 0}};
  double patience_s = 1.0;  // the live line's clock
  for (const auto& worker : workers) {
    watched.push_back({worker->descriptor(), POLLIN, 0});
    patience_s = std::min(patience_s, std::max(0.0, worker->seconds_left()));
  }
  const int got =
      ::poll(watched.data(), watched.size(), static_cast<int>(std::ceil(1000.0 * patience_s)));
  DOCKYARD_CHECK(got >= 0 || errno == EINTR);
}

void CollectFinished(Workers& workers, CampaignFolder& folder, Progress& progress) {
  for (auto& worker : workers) {
    worker->KillIfLate();
    if (!worker->Read()) continue;
    const WorkerEnd end = worker->Finish();
    folder.Keep(end.run);
    progress.Finished(end.run.result, end.note);
    worker.reset();
  }
  workers.erase(std::remove(workers.begin(), workers.end(), nullptr), workers.end());
}

void CheckRunNumbers(const Campaign& campaign) {
  std::set<int> numbers;
  for (const CampaignRun& run : campaign.runs) DOCKYARD_CHECK(numbers.insert(run.run).second);
}

/// Returns the signal that stopped it, or 0.
int RunAll(const Campaign& campaign, const RunFunction& function, const CampaignOptions& options,
           CampaignFolder& folder, SignalQueue& signals) {
  const std::vector<const CampaignRun*> todo = RunsToDo(campaign, folder.finished());
  Progress progress(options.progress, static_cast<int>(campaign.runs.size()), folder.finished());
  Workers workers;  // destroyed on the way out, whatever the way: no child outlives this call
  std::size_t next = 0;
  int signal = 0;
  while (signal == 0 && (next < todo.size() || !workers.empty())) {
    while (next < todo.size() && static_cast<int>(workers.size()) < options.jobs) {
      const CampaignRun& run = *todo[next++];
      workers.push_back(std::make_unique<Worker>(
          run, function, folder.StartRun(run.run), options.run_time_limit_s,
          std::vector<int>{folder.lock_descriptor(), signals.descriptor()}));
    }
    progress.Tick(static_cast<int>(workers.size()));
    WaitForNews(workers, signals);
    CollectFinished(workers, folder, progress);
    signal = signals.Take();
  }
  progress.End();
  return signal;
}

}  // namespace

CampaignEnd RunCampaign(const Campaign& campaign, const RunFunction& function,
                        const CampaignOptions& options) {
  DOCKYARD_CHECK(options.jobs >= 1 && options.run_time_limit_s > 0.0);
  CheckRunNumbers(campaign);
  CampaignFolder folder(options.out_dir, campaign, options.identity);
  SignalQueue signals;
  CampaignEnd end;
  end.signal = RunAll(campaign, function, options, folder, signals);
  end.summary = folder.Conclude(campaign);
  end.runs = folder.finished();
  end.total = static_cast<int>(campaign.runs.size());
  return end;
}

}  // namespace dockyard
