// A run that can be watched, in a report.
#pragma once

#include <string>
#include <vector>

#include "sim/log/column.h"
#include "sim/log/logged_run.h"
#include "sim/page/payload.h"

namespace dockyard {

/// What the log does not tell.
struct ReplayFacts {
  int run = 0;
  std::size_t scene = 0;  // in the header's list
  std::string outcome{}, sentence{}, command{}, seed{}, state_hash{}, messages{};
  bool success = false;
  std::vector<Column> channels{}, beliefs{};  // of the system, for units and meanings
  bool pictures = true;
  std::size_t most_images = 240;  // of those without a sighting
};

/// An entry of `replays` in the header. The page's world is the run's site G, so that the ground
/// lies along its axes. Null for a log without a whole sample.
Json ReplayPart(const LoggedRun& run, const ReplayFacts& facts, Payload& payload);

}  // namespace dockyard
