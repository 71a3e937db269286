#include "sim/campaign/campaign.h"

#include <map>
#include <optional>
#include <utility>

#include "controller/base/check.h"
#include "sim/campaign/run_logs.h"
#include "sim/jobs/pool.h"
#include "sim/plant/renderer.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

/// Hands results to `enough` in order of indices, however they come.
class InOrder {
 public:
  explicit InOrder(std::function<bool(const RunResult&)> enough) : enough_(std::move(enough)) {}

  /// True when it is enough.
  bool Add(std::int64_t index, const RunResult& result) {
    if (!enough_ || done_) return done_;
    waiting_[index] = result;
    while (!done_ && !waiting_.empty() && waiting_.begin()->first == next_) {
      done_ = enough_(waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
      ++next_;
    }
    return done_;
  }
  bool done() const { return done_; }

 private:
  std::function<bool(const RunResult&)> enough_;
  std::map<std::int64_t, RunResult> waiting_;
  std::int64_t next_ = 0;
  bool done_ = false;
};

/// One shard under way.
class Engine {
 public:
  Engine(const Campaign& campaign, const RunFunction& function, const CampaignOptions& options)
      : campaign_(campaign),
        options_(options),
        folder_(options.out_dir),
        maker_(campaign, options.systems),
        check_(campaign),
        function_(function),
        finished_(0),
        next_(options.shard.number - 1),
        logs_(campaign.keep, folder_, options.columns),
        in_order_(options.enough) {
    ClaimFolder(options.out_dir, options.identity, options.facts);
    const Json header{{"shard", ShardFile("", options.shard).stem().string()},
                      {"environment", options.environment}};
    writer_.emplace(ShardFile(options.out_dir, options.shard), header, options.columns);
    finished_ = ReadFinished(options.out_dir, check_, options.columns, end_.damaged);
    GoOn();
  }

  ShardEnd Run() {
    Progress progress(options_.progress, SuccessWord(options_.columns), RunsOfShard(),
                      finished_.TallyOf(options_.shard));
    SignalQueue signals;
    const PoolOptions pool{.workers = options_.jobs,
                           .limits = {campaign_.limits.wall_s, campaign_.limits.memory_mib},
                           .retries = campaign_.limits.retries,
                           .close_in_worker = {writer_->lock_descriptor()},
                           .waiting = [&](int running) {
                             writer_->FlushIfDue();
                             progress.Tick(running);
                           }};
    const auto take = [&](const Job& job, int place, const JobEnd& end) {
      const Pass pass = PassOf(job.number);
      const FinishedRun run =
          ReadAnswer([&] { return maker_.Make(pass.index); }, options_.columns, end);
      if (pass.again) return logs_.TakeLog(pass.index, run, WorkPlace(place));
      logs_.TakeRow(pass.index, run, WorkPlace(place));
      writer_->Append(run);
      finished_.Add(pass.index, run.result.success, run.result.outcome);
      progress.Finished(run);
      in_order_.Add(pass.index, run.result);
    };
    end_.signal =
        RunPool(pool, signals,
                {.work = [&](std::int64_t number,
                             const fs::path& messages) { return Work(PassOf(number), messages); },
                 .next = [&](int place) { return Next(place); },
                 .prepare = [&](const Job&, int place) { Empty(WorkPlace(place)); },
                 .take = take});
    writer_->Flush();
    progress.End();
    RemoveWork();
    end_.tally = finished_.TallyOf(options_.shard);
    end_.total = RunsOfShard();
    end_.enough = in_order_.done();
    end_.not_repeated = logs_.not_repeated();
    return std::move(end_);
  }

 private:
  /// In the results folder.
  fs::path WorkPlace() const { return fs::path("work") / ShardFile("", options_.shard).stem(); }
  /// Of the worker at that place.
  fs::path WorkPlace(int place) const { return WorkPlace() / std::to_string(place); }
  fs::path WorkFolder(int place) const { return options_.out_dir / WorkPlace(place); }

  void Empty(const fs::path& place) const {
    folder_.Remove(place);
    folder_.Make(place);
  }

  /// Its own, and what shards left that were killed, half-written files too. Those of shards at
  /// work stay.
  void RemoveWork() const {
    try {
      folder_.Remove(WorkPlace());
      const fs::path shards = options_.out_dir / "shards";
      for (const std::string& name : folder_.Names("work")) {
        if (IsIdle(shards / (name + ".rows"))) folder_.Remove(fs::path("work") / name);
      }
      if (!folder_.Names("work").empty()) return;  // a shard is at work
      folder_.Remove("work");
      const auto alone = TryLockResults(options_.out_dir);
      if (!alone) return;  // a merge is at work
      for (const std::string& name : folder_.Names()) {
        if (name.ends_with(".tmp") && folder_.HasFile(name)) folder_.Remove(name);
      }
    } catch (const IoError&) {  // what is left hurts nobody
    }
  }

  std::int64_t RunsOfShard() const {
    const Shard& shard = options_.shard;
    return (maker_.run_count() - shard.number + shard.count) / shard.count;
  }

  /// What earlier programs left in the folder: logs that count, results in order.
  void GoOn() {
    Empty(WorkPlace());
    if (!options_.enough && campaign_.keep.none()) return;
    const FinishedRuns runs = ReadShards(options_.out_dir, check_, options_.columns);
    for (const RunResult& result : runs.results) {
      const std::int64_t index = maker_.IndexOf(result.run);
      if (!options_.shard.Has(index)) continue;
      if (!options_.retry_lost || !IsLost(result.outcome)) logs_.AddEarlier(index, result);
      in_order_.Add(index, result);
    }
  }

  Job JobOf(const Pass& pass, int place) const {
    return {NumberOf(pass), WorkFolder(place) / kMessagesFile};
  }

  /// The next log that is to be written; else the next run of the shard that has no result.
  std::optional<Job> Next(int place) {
    if (const auto index = logs_.NextAgain()) return JobOf({*index, true}, place);
    if (in_order_.done()) return std::nullopt;
    const auto done = [&] {
      return finished_.Has(next_) && !(options_.retry_lost && finished_.Lost(next_));
    };
    while (next_ < maker_.run_count() && done()) next_ += options_.shard.count;
    if (next_ >= maker_.run_count()) return std::nullopt;
    const Job job = JobOf({next_, false}, place);
    next_ += options_.shard.count;
    return job;
  }

  /// In a worker.
  std::string Work(const Pass& pass, const fs::path& messages) const {
    if (options_.jobs > 1) DrawWithoutThreads();
    const fs::path dir = messages.parent_path();
    const auto logging = [&](const CampaignRun& run) {
      return LoggingOf(run, campaign_.keep, pass.again, dir, folder_);
    };
    return RunAndAnswer({.make = [&] { return maker_.Make(pass.index); },
                         .logging = logging,
                         .simulate = function_,
                         .columns = options_.columns,
                         .dir = dir,
                         .sightings = campaign_.keep.sightings && !pass.again});
  }

  const Campaign& campaign_;
  const CampaignOptions& options_;
  Folder folder_;
  RunMaker maker_;
  RowCheck check_;
  const RunFunction& function_;
  ShardEnd end_;
  std::optional<ShardWriter> writer_;
  FinishedSet finished_;
  std::int64_t next_;
  RunLogs logs_;
  InOrder in_order_;
};

}  // namespace

ShardEnd RunShard(const Campaign& campaign, const RunFunction& function,
                  const CampaignOptions& options) {
  DOCKYARD_CHECK(!options.enough || options.shard.whole());
  DOCKYARD_CHECK(options.jobs >= 1 && options.columns.labels == campaign.labels);
  return Engine(campaign, function, options).Run();
}

}  // namespace dockyard
