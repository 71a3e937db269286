// The images at a start pose with the truth beside them: dockyard view.
#pragma once

#include <filesystem>

#include "sim/axel/load_models.h"
#include "sim/scenario/scenario.h"

namespace dockyard::axel {

/// Renders the stereo pair of the settled start pose and writes left.png, right.png and view.json:
/// the board's true pose in the rover body and, for each camera and fiducial, its projected centre,
/// the centroid of the projected disc and the share of the disc that other things hide.
/// Throws ConfigError for bad files, std::runtime_error for a folder that cannot be written.
void WriteStartView(const Scenario& scenario, const AxelModels& models,
                    const std::filesystem::path& out_dir);

}  // namespace dockyard::axel
