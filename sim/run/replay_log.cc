#include "sim/run/replay_log.h"

namespace dockyard {

std::optional<ControllerReplay> ReplayLog(RunLogReader& log, const System& system,
                                          const CampaignRun& run, const ReadyRun& ready,
                                          const RunOptions& options) {
  if (log.header().system != system.name) {
    throw DataError("the log: expected one of the system " + system.name + ", found one of '" +
                    log.header().system + "'");
  }
  // As text: a number that is read back as a whole one is still the same.
  if (log.header().nominal.dump() != ready.nominal.dump()) return std::nullopt;
  const auto controller = MakeController(system, run, ready, options);
  return ReplayController(log, *controller,
                          {.motors = ready.motor_count,
                           .cameras = ready.camera_count,
                           .sensors = static_cast<int>(ready.sensors.size())});
}

}  // namespace dockyard
