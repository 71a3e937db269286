// What the front cameras see at the start, with the truth beside it.
#pragma once

#include <filesystem>

#include "sim/rocky7/load_models.h"

namespace dockyard::rocky7 {

/// Writes left.png, right.png and truth.json into the folder. Throws ConfigError and IoError.
void WriteStartView(const Scenario& scenario, const Rocky7Models& models,
                    const std::filesystem::path& dir);

}  // namespace dockyard::rocky7
