#include "sim/campaign/campaign.h"

#include <map>
#include <optional>
#include <utility>

#include "controller/base/check.h"
#include "sim/campaign/retention.h"
#include "sim/jobs/pool.h"
#include "sim/run/renderer.h"

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
        maker_(campaign, options.systems),
        work_{function, options.columns},
        finished_(0),
        next_(options.shard.number - 1),
        retention_(campaign.keep),
        in_order_(options.enough) {
    ClaimFolder(options.out_dir, options.identity, options.facts);
    const Json header{{"shard", ShardFile("", options.shard).stem().string()},
                      {"environment", options.environment}};
    writer_.emplace(ShardFile(options.out_dir, options.shard), header, options.columns);
    finished_ = ReadFinished(options.out_dir, maker_, options.columns, end_.damaged);
    GoOn();
  }

  ShardEnd Run() {
    Progress progress(options_.progress, RunsOfShard(), finished_.TallyOf(options_.shard));
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
      const FinishedRun run =
          ReadAnswer([&] { return maker_.Make(job.number); }, options_.columns, end);
      KeepLog(run, place);
      writer_->Append(run);
      finished_.Add(job.number, run.result.docked, run.result.outcome);
      progress.Finished(run);
      return !in_order_.Add(job.number, run.result);
    };
    if (!in_order_.done()) {
      end_.signal =
          RunPool(pool, signals,
                  {.work = [&](std::int64_t index,
                               const fs::path& messages) { return Work(index, messages); },
                   .next = [&](int place) { return Next(place); },
                   .prepare = [&](const Job& job, int place) { Prepare(job, place); },
                   .take = take});
    }
    writer_->Flush();
    progress.End();
    RemoveWork();
    end_.tally = finished_.TallyOf(options_.shard);
    end_.total = RunsOfShard();
    end_.enough = in_order_.done();
    return std::move(end_);
  }

 private:
  fs::path WorkFolder() const {
    return options_.out_dir / "work" / ShardFile("", options_.shard).stem();
  }
  /// Of the worker at that place.
  fs::path WorkFolder(int place) const { return WorkFolder() / std::to_string(place); }

  /// Its own, and what shards left that were killed, half-written files too. Those of shards at
  /// work stay.
  void RemoveWork() const {
    std::error_code ignored;
    fs::remove_all(WorkFolder(), ignored);
    const fs::path work = options_.out_dir / "work", shards = options_.out_dir / "shards";
    for (const auto& entry : fs::directory_iterator(work, ignored)) {
      const fs::path rows = shards / (entry.path().filename().string() + ".rows");
      if (IsIdle(rows)) fs::remove_all(entry.path(), ignored);
    }
    if (!fs::remove(work, ignored)) return;  // a shard is at work
    for (const auto& entry : fs::directory_iterator(options_.out_dir, ignored)) {
      if (entry.path().extension() == ".tmp") fs::remove(entry.path(), ignored);
    }
  }

  std::int64_t RunsOfShard() const {
    const Shard& shard = options_.shard;
    return (maker_.run_count() - shard.number + shard.count) / shard.count;
  }

  /// What earlier programs left in the folder: logs that count, results in order.
  void GoOn() {
    EmptyFolder(WorkFolder());
    if (!options_.enough && (campaign_.keep.none() || campaign_.keep.failures_per_cause < 0)) {
      return;
    }
    const FinishedRuns runs = ReadShards(options_.out_dir, options_.columns);
    for (const RunResult& result : runs.results) {
      const std::int64_t index = maker_.IndexOf(result.run);
      if (!options_.shard.Has(index)) continue;
      if (fs::exists(RunFolder(options_.out_dir, result.run))) retention_.AddKept(result);
      in_order_.Add(index, result);
    }
  }

  /// The next run of the shard that has no result.
  std::optional<Job> Next(int place) {
    const auto done = [&] {
      return finished_.Has(next_) && !(options_.retry_lost && finished_.Lost(next_));
    };
    while (next_ < maker_.run_count() && done()) next_ += options_.shard.count;
    if (next_ >= maker_.run_count()) return std::nullopt;
    const Job job{next_, WorkFolder(place) / "messages.txt"};
    next_ += options_.shard.count;
    return job;
  }

  void Prepare(const Job&, int place) const {
    if (!campaign_.keep.none() || !fs::exists(WorkFolder(place))) EmptyFolder(WorkFolder(place));
  }

  /// In a worker.
  std::string Work(std::int64_t index, const fs::path& messages) const {
    const fs::path dir = campaign_.keep.none() ? fs::path() : messages.parent_path();
    if (options_.jobs > 1) DrawWithoutThreads();
    return RunAndAnswer([&] { return maker_.Make(index); }, work_, dir);
  }

  void KeepSightings(const FinishedRun& run, int place) const {
    const fs::path to = SightingsFile(options_.out_dir, run.result.run);
    MakeFolder(to.parent_path());
    WriteWhole(to, ReadWhole(WorkFolder(place) / "sightings.json").value_or("[]\n"));
  }

  void KeepLog(const FinishedRun& run, int place) {
    if (campaign_.keep.none()) return;
    if (campaign_.keep.sightings && !IsLost(run.result.outcome)) KeepSightings(run, place);
    const Retention::Choice choice = retention_.Choose(run.result);
    if (choice.drop) fs::remove_all(RunFolder(options_.out_dir, *choice.drop));
    if (!choice.keep) return;
    const fs::path from = WorkFolder(place), to = RunFolder(options_.out_dir, run.result.run);
    if (IsLost(run.result.outcome)) WriteLostRun(from, run, options_.columns);
    std::error_code error;
    if (fs::file_size(from / "messages.txt", error) == 0) fs::remove(from / "messages.txt", error);
    MakeFolder(to.parent_path());
    fs::remove_all(to, error);
    fs::rename(from, to, error);
    if (error) throw IoError("cannot make folder " + to.string() + ": " + error.message());
  }

  const Campaign& campaign_;
  const CampaignOptions& options_;
  RunMaker maker_;
  RunWork work_;
  ShardEnd end_;
  std::optional<ShardWriter> writer_;
  FinishedSet finished_;
  std::int64_t next_;
  Retention retention_;
  InOrder in_order_;
};

}  // namespace

ShardEnd RunShard(const Campaign& campaign, const RunFunction& function,
                  const CampaignOptions& options) {
  DOCKYARD_CHECK(!options.enough || options.shard.whole());
  DOCKYARD_CHECK(options.jobs >= 1 && options.columns.labels == campaign.labels);
  return Engine(campaign, function, options).Run();
}

CampaignEnd RunCampaign(const Campaign& campaign, const RunFunction& function,
                        const CampaignOptions& options) {
  const ShardEnd shard = RunShard(campaign, function, options);
  CampaignEnd end = MergeShards(options.out_dir, campaign, options.columns);
  end.signal = shard.signal;
  return end;
}

}  // namespace dockyard
