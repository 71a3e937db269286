// A report as one HTML file: a campaign's results with the replays of its kept runs.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/log/results.h"
#include "sim/page/overview_part.h"
#include "sim/page/replay_part.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// A run whose log is kept.
struct WatchedRun {
  std::size_t place = 0;                // in the results
  std::function<LoggedRun()> log;       // may throw DataError and IoError
  std::function<StageShapes()> shapes;  // may throw ConfigError
  std::string command, messages;
};

struct ReportContent {
  std::string title, program;
  const Campaign* campaign = nullptr;  // null: a single run
  const FinishedRuns* runs = nullptr;  // not null
  RowColumns columns;
  std::vector<Column> channels, beliefs;  // of the system
  std::string system;
  std::vector<Pose2> starts;  // in the target's frame, by place; empty: not known
  std::optional<AcceptanceAim> aim;
  std::vector<Requirement> requirements;
  std::string replay_command;       // with {run}; empty: there is none
  std::vector<WatchedRun> watched;  // in the order in which they are taken in
  bool pictures = true;
  std::size_t most_bytes = std::size_t{50} << 20;  // of the file; replays beyond it are left out
};

/// The whole file.
std::string ReportPage(const ReportContent& content);

}  // namespace dockyard
