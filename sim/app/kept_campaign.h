// A campaign's results folder as a whole, for commands that judge it.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/app/invocation.h"
#include "sim/base/secret.h"
#include "sim/log/results.h"
#include "sim/plan/campaign.h"
#include "sim/run/system.h"

namespace dockyard {

struct KeptCampaign {
  Campaign campaign;  // on the copies in its folder
  std::string system;
  RowColumns columns;
  FinishedRuns runs;
};

inline constexpr const char* kAnyResults = "the results folder of a campaign or of one run";

/// Throws UsageError for a folder without results, the same for every command: "DIR: expected ...".
/// @param expected  "the results folder of a campaign"
[[noreturn]] void RefuseResultsFolder(const std::filesystem::path& dir,
                                      const std::string& expected);

/// Without its runs. Throws UsageError for a folder without a campaign, ConfigError, ResultsError
/// and IoError.
/// @param secret_file  of a sealed campaign, whose worlds are hidden without it; empty: none
KeptCampaign OpenKeptCampaign(const std::filesystem::path& dir, const std::vector<System>& systems,
                              const std::string& secret_file = {});
/// The same with its runs.
KeptCampaign ReadKeptCampaign(const std::filesystem::path& dir, const std::vector<System>& systems,
                              const std::string& secret_file = {});

/// `--secret FILE`, of a command that makes runs of the folder again.
void AddSecretOption(CLI::App& command, Invocation& call);
/// The secret in a file, which is made if `make` says so. Throws ConfigError for other content, and
/// IoError.
Secret SecretIn(const std::string& file, bool make);

/// Throws UsageError unless the name is one of the campaign's arms; the message names all.
void RequireArm(const KeptCampaign& kept, const std::string& arm);
/// The runs of one arm; all of them for an empty name.
std::vector<const RunResult*> RunsOfArm(const KeptCampaign& kept, const std::string& arm);

}  // namespace dockyard
