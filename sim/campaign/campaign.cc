#include "sim/campaign/campaign.h"

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include "controller/base/check.h"
#include "sim/campaign/signal_queue.h"

namespace dockyard {
namespace {

using Workers = std::vector<std::unique_ptr<Worker>>;

std::vector<const CampaignRun*> RunsToDo(const Campaign& campaign, const FinishedRuns& finished) {
  std::vector<const CampaignRun*> todo;
  for (const CampaignRun& run : campaign.runs) {
    if (finished.count(run.run) == 0) todo.push_back(&run);
  }
  return todo;
}

void WaitForNews(const Workers& workers, const SignalQueue& signals) {
  std::vector<const Child*> children;
  for (const auto& worker : workers) children.push_back(&worker->child());
  WaitForChildren(children, signals);
}

void CollectFinished(Workers& workers, CampaignFolder& folder, Progress& progress) {
  for (auto& worker : workers) {
    worker->child().KillIfLate();
    if (!worker->child().Read()) continue;
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
  end.summary = folder.Conclude(campaign, options.cone);
  end.runs = folder.finished();
  end.total = static_cast<int>(campaign.runs.size());
  return end;
}

}  // namespace dockyard
