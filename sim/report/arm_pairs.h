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
/// The same of two groups of runs that a label tells apart: runs with the same seed and all other
/// labels equal are a pair, but for `point`, and for `changed_to` of a key changed alone.
ArmPairs PairGroups(const std::string& label, const RowColumns& columns, const Rows& a,
                    const Rows& b);

}  // namespace dockyard
