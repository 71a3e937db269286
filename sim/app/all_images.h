// A run's log with the images that its file does not keep.
#pragma once

#include <string>
#include <vector>

#include "sim/app/invocation.h"
#include "sim/log/logged_run.h"
#include "sim/run/system.h"

namespace dockyard {

/// Simulates the run again where the log keeps some of the images alone, and says so. Leaves the
/// log as it is where it has all, and where the run's controller is a program, as none is started.
/// @param log     of this run
/// @param labels  columns of the campaign's rows
LoggedRun WithAllImages(LoggedRun log, CampaignRun run, const std::vector<std::string>& labels,
                        const Invocation& call);

}  // namespace dockyard
