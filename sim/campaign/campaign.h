// The runs of a campaign, or of one shard of it, on several workers, into a results folder that
// survives a crash, a Ctrl-C and a power cut, and comes out the same for any number of workers and
// shards.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/finished_set.h"
#include "sim/campaign/merge.h"
#include "sim/campaign/progress.h"
#include "sim/campaign/run_logs.h"
#include "sim/campaign/run_work.h"
#include "sim/campaign/shard_file.h"
#include "sim/plan/campaign.h"

namespace dockyard {

struct CampaignOptions {
  std::filesystem::path out_dir;
  Shard shard;              // which of the runs; by default all
  int jobs = 1;             // workers at once, >= 1
  bool retry_lost = false;  // simulate runs again that crashed or were stopped
  ProgressStyle progress = ProgressStyle::kNone;
  CampaignIdentity identity;  // a folder that was made for another is refused
  Json facts;                 // of the campaign, for readers of its manifest
  Json environment;           // where this program runs, into the shard's first line
  std::vector<KnownSystem> systems;
  RowColumns columns;  // of the campaign's system, with the campaign's labels
  /// Gets every result in order of indices, those of earlier calls included; true: enough. Empty:
  /// never. Runs beyond the last one that it got may have results too.
  std::function<bool(const RunResult&)> enough;
};

/// What RunShard came to.
struct ShardEnd {
  Tally tally;                       // of the shard's runs, those of earlier calls included
  std::int64_t total = 0;            // runs of the shard
  int signal = 0;                    // SIGINT, SIGTERM or SIGHUP that stopped it; 0: none did
  bool enough = false;               // options.enough said so
  std::vector<std::string> damaged;  // places of damaged rows; their runs were simulated again
  std::vector<NotRepeated> not_repeated;

  bool complete() const { return tally.done == total; }
};

/// Runs the runs that the folder lacks. A run whose worker dies is tried again, as often as the
/// campaign says; then it has the outcome crashed or stopped. On SIGINT, SIGTERM or SIGHUP it kills
/// the runs under way, keeps the finished ones and returns. Throws FolderTaken, ResultsError,
/// ConfigError of a run's input files, and IoError when something cannot be written; the runs
/// finished by then stay.
ShardEnd RunShard(const Campaign& campaign, const RunFunction& function,
                  const CampaignOptions& options);

}  // namespace dockyard
