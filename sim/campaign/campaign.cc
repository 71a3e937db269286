#include "sim/campaign/campaign.h"

#include <map>
#include <memory>
#include <optional>

#include "controller/base/check.h"
#include "sim/jobs/pool.h"
#include "sim/plan/make_run.h"

namespace dockyard {
namespace {

/// The runs one by one as processes get free, those that the folder has left out.
class Queue {
 public:
  Queue(const Campaign& campaign, const RunMaker& maker, const FinishedRuns& finished)
      : total_(campaign.run_count()), maker_(maker), finished_(finished) {}

  /// The next run, kept until it is taken; null after the last.
  std::shared_ptr<const CampaignRun> Start(std::size_t& index) {
    while (next_ < total_ && finished_.count(maker_.Number(next_)) > 0) ++next_;
    if (next_ == total_) return nullptr;
    index = static_cast<std::size_t>(next_);
    auto run = std::make_shared<const CampaignRun>(maker_.Make(next_++));
    under_way_[index] = run;
    return run;
  }
  std::shared_ptr<const CampaignRun> Take(std::size_t index) {
    const auto run = under_way_.at(index);
    under_way_.erase(index);
    return run;
  }

 private:
  std::int64_t total_, next_ = 0;
  const RunMaker& maker_;
  const FinishedRuns& finished_;
  std::map<std::size_t, std::shared_ptr<const CampaignRun>> under_way_;
};

/// Returns the signal that stopped it, or 0.
int RunAll(const Campaign& campaign, const RunMaker& maker, const RunFunction& function,
           const CampaignOptions& options, CampaignFolder& folder, SignalQueue& signals) {
  const RunWork work{function, options.draw, options.columns};
  Queue queue(campaign, maker, folder.finished());
  Progress progress(options.progress, campaign.run_count(), folder.finished());
  const bool keeps = campaign.keep == Keep::kAll;
  const auto next = [&]() -> std::optional<Job> {
    std::size_t index = 0;
    const auto run = queue.Start(index);
    if (!run) return std::nullopt;
    if (!keeps) {
      const std::string name = "run_" + std::to_string(run->run) + ".txt";
      return Job{index, [run, &work] { return RunAndAnswer(*run, work, {}); }, folder.dir() / name};
    }
    const std::filesystem::path dir = folder.StartRun(run->run);
    return Job{index, [run, &work, dir] { return RunAndAnswer(*run, work, dir); },
               dir / "messages.txt"};
  };
  const auto take = [&](std::size_t index, const Child::End& end) {
    const auto run = queue.Take(index);
    const std::filesystem::path dir =
        keeps ? RunFolder(folder.dir(), run->run) : std::filesystem::path();
    const FinishedRun finished = ReadAnswer(*run, options.columns, dir, end);
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
  const RunMaker maker(campaign, options.systems);
  CampaignFolder folder(
      options.out_dir, campaign, maker,
      {options.columns, ResolvedYaml(campaign, options.systems), options.identity});
  SignalQueue signals;
  CampaignEnd end;
  end.signal = RunAll(campaign, maker, function, options, folder, signals);
  end.summary = folder.Conclude(campaign, maker, options.draw_campaign);
  end.runs = folder.finished();
  end.total = campaign.run_count();
  return end;
}

}  // namespace dockyard
