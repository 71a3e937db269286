// The images of a run's cameras at its start.
#pragma once

#include <filesystem>

#include "sim/custom/load_models.h"

namespace dockyard::custom {

/// One file for each camera, by its name, and truth.json.
void WriteStartView(const Scenario& scenario, const CustomModels& models,
                    const std::filesystem::path& dir);

}  // namespace dockyard::custom
