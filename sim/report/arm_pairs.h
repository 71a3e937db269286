// Two arms of a campaign, run by run on the same draws.
#pragma once

#include <string>

#include "sim/log/record.h"
#include "sim/report/points.h"
#include "sim/statistics/paired.h"

namespace dockyard {

struct ArmPairs {
  PairedCounts counts;
  int unpaired = 0;  // runs whose other half is missing
};

/// Runs of both arms with the same seed and place are a pair. The first label is the arm's.
ArmPairs PairArms(const Rows& a, const Rows& b);

}  // namespace dockyard
