// All runs of a campaign on several processes, into a results folder that survives a crash, a
// Ctrl-C and a power cut, and comes out the same for any number of processes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/progress.h"
#include "sim/campaign/worker.h"
#include "sim/plan/campaign.h"

namespace dockyard {

struct CampaignOptions {
  std::filesystem::path out_dir;
  int jobs = 1;                     // processes, >= 1
  double run_time_limit_s = 900.0;  // wall time of one run; a run beyond it is killed: crashed
  ProgressStyle progress = ProgressStyle::kNone;
  std::string identity;  // of program and model files; a folder begun with another is refused
  std::vector<KnownSystem> systems;
  RowColumns columns;          // of the campaign's system, with the campaign's labels
  DrawRun draw;                // figures into each run's folder; empty: none
  DrawCampaign draw_campaign;  // figures into plots/; empty: none
};

struct CampaignEnd {
  FinishedRuns runs;  // those of earlier calls in the same folder included
  std::int64_t total = 0;
  int signal = 0;  // SIGINT, SIGTERM or SIGHUP that stopped it; 0: none did
  std::string summary;

  bool complete() const { return static_cast<std::int64_t>(runs.size()) == total; }
};

/// Runs the runs that the folder lacks. On SIGINT, SIGTERM or SIGHUP it kills the runs under
/// way, keeps the finished ones and returns. Throws FolderTaken, ResultsError, ConfigError of
/// a run's input files, and IoError when something cannot be written; the runs finished by then
/// stay.
CampaignEnd RunCampaign(const Campaign& campaign, const RunFunction& function,
                        const CampaignOptions& options);

}  // namespace dockyard
