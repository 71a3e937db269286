// The ground of a run in a report: the part where something happens, as fine as a page can draw.
#pragma once

#include <vector>

#include "sim/log/logged_run.h"
#include "sim/page/payload.h"

namespace dockyard {

/// `ground` of a replay; null without one.
/// @param X_GO  of each body and sample, in the site
Json ReplayGround(const LoggedRun& run, const std::vector<std::vector<Pose3>>& X_GO,
                  Payload& payload);

}  // namespace dockyard
