// The table of all runs in a report.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "sim/log/results.h"
#include "sim/page/payload.h"

namespace dockyard {

/// `table` of the header. Texts with very many different values are left out, and named.
/// @param start  the start pose in the target's frame of the run at that place; empty: not known
Json TablePart(const FinishedRuns& runs, const RowColumns& columns,
               const std::function<Pose2(std::size_t)>& start, Payload& payload,
               std::vector<std::string>& left_out);

}  // namespace dockyard
