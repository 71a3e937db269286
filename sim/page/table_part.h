// The table of all runs in a report.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "sim/log/results.h"
#include "sim/page/payload.h"

namespace dockyard {

/// `table` of the header. Texts with very many different values are left out, and named.
/// @param starts  in the target's frame, by the runs' places; empty: not known
Json TablePart(const FinishedRuns& runs, const RowColumns& columns,
               const std::vector<Pose2>& starts, Payload& payload,
               std::vector<std::string>& left_out);

}  // namespace dockyard
