// The arguments that commands on scenarios share: the file, --seed, --set.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/scenario.h"

namespace dockyard {

struct ScenarioOptions {
  std::string file;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> overrides;  // "key.path=value"
};

void AddSetOption(CLI::App& command, std::vector<std::string>& overrides);
void AddScenarioOptions(CLI::App& command, ScenarioOptions& options);

/// Throws ConfigError.
Scenario Load(const ScenarioOptions& options);

/// A scenario as the one run of its own folder.
CampaignRun SingleRun(const Scenario& scenario);

}  // namespace dockyard
