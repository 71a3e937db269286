// The arguments that commands on scenarios share: the file, --seed, --set.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/plan/campaign.h"
#include "sim/run/loop.h"
#include "sim/run/system.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

struct ScenarioOptions {
  std::string file;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> overrides;  // "key.path=value"
};

void AddSetOption(CLI::App& command, std::vector<std::string>& overrides);
/// `--seed N`: of a scenario or a campaign, in place of its key `seed`.
void AddSeedOption(CLI::App& command, std::optional<std::uint64_t>& seed);
void AddScenarioOptions(CLI::App& command, ScenarioOptions& options);

/// Throws ConfigError.
Scenario Load(const ScenarioOptions& options, const std::vector<System>& systems);

/// Whether a controller's program may be started, how long one of its answers may take, and whether
/// it is confined.
struct CommandOptions {
  bool allow = false;
  double answer_limit_s = 10.0;
  bool sandbox = false;
  void Fill(RunOptions& options) const {
    options.allow_commands = allow;
    options.answer_limit_s = answer_limit_s;
    options.sandbox = sandbox;
  }
};
void AddCommandOptions(CLI::App& command, CommandOptions& options);
/// The options as words that give them again.
std::vector<std::string> OptionWords(const CommandOptions& options);

/// The part of the systems that a campaign's reader needs.
CampaignSystems CampaignSystemsOf(const std::vector<System>& systems);

/// A scenario as the one run of its own folder.
CampaignRun SingleRun(const Scenario& scenario);

}  // namespace dockyard
