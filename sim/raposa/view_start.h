// What the back camera sees at the start, with the truth beside it.
#pragma once

#include <filesystem>

#include "sim/raposa/load_models.h"

namespace dockyard::raposa {

/// Writes back.png and truth.json into the folder. Throws ConfigError and IoError.
void WriteStartView(const Scenario& scenario, const RaposaModels& models,
                    const std::filesystem::path& dir);

}  // namespace dockyard::raposa
