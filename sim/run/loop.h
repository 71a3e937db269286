// One run in closed loop: a pure function of the scenario.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "controller/io/controller.h"
#include "controller/io/rover_sheet.h"
#include "models/scenario.h"
#include "sim/run/record.h"

namespace dockyard {

/// Makes the brain named in the scenario; the one place where both sides meet is sim/app.
using ControllerFactory =
    std::function<std::unique_ptr<Controller>(const std::string& name, const RoverSheet& sheet)>;

struct RunOptions {
  std::filesystem::path log_dir;  // empty: no log is written
};

/// Simulates the run and scores it. Throws ConfigError for files that cannot be read and
/// std::runtime_error for a folder that cannot be written; everything else is an outcome.
RunRecord RunDocking(const CampaignRun& run, const ControllerFactory& make_controller,
                     const RunOptions& options);

}  // namespace dockyard
