#include "sim/campaign/campaign.h"

#include <optional>
#include <set>
#include <vector>

#include "controller/base/check.h"
#include "sim/jobs/pool.h"

namespace dockyard {
namespace {

std::vector<const CampaignRun*> RunsToDo(const Campaign& campaign, const FinishedRuns& finished) {
  std::vector<const CampaignRun*> todo;
  for (const CampaignRun& run : campaign.runs) {
    if (finished.count(run.run) == 0) todo.push_back(&run);
  }
  return todo;
}

void CheckRunNumbers(const Campaign& campaign) {
  std::set<int> numbers;
  for (const CampaignRun& run : campaign.runs) DOCKYARD_CHECK(numbers.insert(run.run).second);
}

/// Returns the signal that stopped it, or 0.
int RunAll(const Campaign& campaign, const RunFunction& function, const CampaignOptions& options,
           CampaignFolder& folder, SignalQueue& signals) {
  const std::vector<const CampaignRun*> todo = RunsToDo(campaign, folder.finished());
  const RunWork work{function, options.draw, options.columns};
  Progress progress(options.progress, static_cast<int>(campaign.runs.size()), folder.finished());
  std::size_t started = 0;
  const auto next = [&]() -> std::optional<Job> {
    if (started == todo.size()) return std::nullopt;
    const CampaignRun& run = *todo[started];
    const std::filesystem::path dir = folder.StartRun(run.run);
    return Job{started++, [&run, &work, dir] { return RunAndAnswer(run, work, dir); },
               dir / "messages.txt"};
  };
  const auto take = [&](std::size_t index, const Child::End& end) {
    const CampaignRun& run = *todo[index];
    const FinishedRun finished =
        ReadAnswer(run, options.columns, RunFolder(folder.dir(), run.run), end);
    folder.Keep(finished);
    const bool crashed = finished.result.outcome == kCrashed;
    progress.Finished(finished.result, crashed ? finished.note : "");
  };
  const PoolOptions pool{.processes = options.jobs,
                         .time_limit_s = options.run_time_limit_s,
                         .close_in_child = {folder.lock_descriptor()},
                         .waiting = [&](int running) { progress.Tick(running); }};
  const int signal = RunPool(pool, signals, next, take);
  progress.End();
  return signal;
}

}  // namespace

CampaignEnd RunCampaign(const Campaign& campaign, const RunFunction& function,
                        const CampaignOptions& options) {
  DOCKYARD_CHECK(options.jobs >= 1 && options.run_time_limit_s > 0.0);
  DOCKYARD_CHECK(options.columns.labels == campaign.labels);
  CheckRunNumbers(campaign);
  CampaignFolder folder(options.out_dir, campaign, options.columns, options.identity);
  SignalQueue signals;
  CampaignEnd end;
  end.signal = RunAll(campaign, function, options, folder, signals);
  end.summary = folder.Conclude(campaign, options.draw_campaign);
  end.runs = folder.finished();
  end.total = static_cast<int>(campaign.runs.size());
  return end;
}

}  // namespace dockyard
