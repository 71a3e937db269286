// The controller of a kept run alone, fed from the run's log.
#pragma once

#include "sim/log/run_log.h"
#include "sim/run/loop.h"

namespace dockyard {

/// Feeds the log's frames to a new controller, made from the nominal parameters of `ready`, and
/// compares its commands with the logged ones.
/// @param ready  made from the run's scenario again; its plant is not used
/// None: the log's nominal parameters are others, as after a change of the models. Throws DataError
/// for a damaged log and for one of another robot, ConfigError and ControllerFailure as
/// MakeController.
std::optional<ControllerReplay> ReplayLog(RunLogReader& log, const System& system,
                                          const CampaignRun& run, const ReadyRun& ready,
                                          const RunOptions& options);

}  // namespace dockyard
