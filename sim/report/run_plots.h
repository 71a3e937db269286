// One run as figures, from its log.
#pragma once

#include <string>
#include <vector>

#include "sim/log/logged_run.h"

namespace dockyard {

/// From above, in the target's frame, as SVG: the true path, the believed one, the planned ways,
/// and where the robot looked for the target.
std::string PathPlot(const std::string& title, const LoggedRun& run);

/// Over time, as SVG: the controller's phases, and a panel for each group of channels. Channels
/// whose names differ in their first word alone ("left_current_a", "right_current_a") share one.
/// @param channels  of the truth, by StatedColumns::channels
std::string HistoryPlot(const std::string& title, const LoggedRun& run,
                        const std::vector<Column>& channels);

}  // namespace dockyard
