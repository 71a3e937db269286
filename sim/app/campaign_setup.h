// A campaign made ready to run, from a command line.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/app/scenario_options.h"
#include "sim/campaign/campaign.h"
#include "sim/run/system.h"

namespace dockyard {

/// What the commands that run a campaign share.
struct CampaignArguments {
  std::string file, out_dir;  // out_dir empty: results/<name>
  std::vector<std::string> overrides;
  std::optional<std::uint64_t> seed;  // none: as the campaign says
  std::string secret_file;            // seals the campaign; empty: none
  double run_limit_s = 0.0;           // 0: as the campaign says
  bool retry_lost = false;
  CommandOptions commands;
};

/// Adds their options; FILE is left to the command.
void AddCampaignOptions(CLI::App& command, CampaignArguments& arguments);
/// The options as words that give them again, without --out.
std::vector<std::string> OptionWords(const CampaignArguments& arguments);

/// K/N of the option --shard; all runs without it. Throws UsageError.
Shard ShardOption(const std::string& text);

struct ReadyCampaign {
  Campaign campaign;        // on the copies of its files in the results folder
  RunFunction run;          // refers to the systems, which must outlive it
  CampaignOptions options;  // of the whole campaign, on one worker
};

/// The campaign as its file and the options have it. Throws ConfigError.
Campaign LoadCampaign(const CampaignArguments& arguments, const std::vector<System>& systems);
/// Finds every mistake before a run. The workers, which are forked, share the models that are
/// loaded by then. Throws ConfigError.
ReadyCampaign MakeReady(Campaign campaign, const CampaignArguments& arguments,
                        const std::vector<System>& systems);

}  // namespace dockyard
