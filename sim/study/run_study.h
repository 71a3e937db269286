// All runs of a study on several processes.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/log/record.h"
#include "sim/scenario/study.h"
#include "sim/study/study_results.h"

namespace dockyard {

/// Simulates one run. A run of a study leaves no log.
using StudyRunFunction = std::function<RunRecord(const CampaignRun& run)>;

struct StudyOptions {
  std::filesystem::path out_dir;    // exists; gets messages of runs that print
  int jobs = 1;                     // processes, >= 1
  double run_time_limit_s = 300.0;  // wall time of one run
  std::function<void(int done, int total)> progress;
};

struct StudyEnd {
  std::vector<StudyRow> rows;  // in run order, the finished ones
  int total = 0;
  int signal = 0;  // that stopped it; 0: none did

  bool complete() const { return static_cast<int>(rows.size()) == total; }
  bool any_crashed() const;
};

/// Seed of a run. A key changed alone meets the same seeds as the unchanged grid, so that the
/// difference is the key's and not the draw's.
std::uint64_t StudySeed(const Study& study, int point, int repeat);

/// Runs every point `repeats` times. A run that dies or throws has the outcome crashed and no
/// measures. On SIGINT, SIGTERM or SIGHUP it kills the runs under way and returns the finished
/// ones.
/// @param columns  of the study's system, without labels
/// Throws ConfigError as CheckMeasures, and IoError.
StudyEnd RunStudy(const Study& study, const StudyRunFunction& simulate, const RowColumns& columns,
                  const StudyOptions& options);

}  // namespace dockyard
