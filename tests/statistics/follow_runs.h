#pragma once

#include <vector>

#include "sim/statistics/sequential.h"

namespace dockyard {

/// The end of the test, or its state after these runs in their order, true for one that failed.
inline SequentialEnd FollowRuns(const SequentialPlan& plan, const std::vector<bool>& failed) {
  SequentialEnd end;
  for (const bool run_failed : failed) FollowRun(plan, run_failed, end);
  return end;
}

}  // namespace dockyard
