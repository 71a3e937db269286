// Where the runs of a campaign started, from above.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "sim/log/record.h"

namespace dockyard {

/// As SVG: an arrow at each start pose in the target's frame D, with a disc where runs succeeded
/// and a cross where one failed. As long as at most 60 starts have failures these are named: by run
/// and outcome, or by their number where runs started alike. Of very many starts the arrows are
/// left out.
/// @param word  of a success (SuccessWord)
/// @param X_DR  of each row
std::string StartsPlot(const std::string& title, const std::string& word,
                       const std::vector<RunResult>& rows, const std::vector<Pose2>& X_DR);

}  // namespace dockyard
