// One run of a results folder, for commands that look at it again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/app/invocation.h"
#include "sim/app/kept_campaign.h"
#include "sim/app/scenario_options.h"
#include "sim/base/folder.h"
#include "sim/log/record.h"
#include "sim/run/system.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// A run as kept: its scenario, its result, and the folders of its log and of its commands' log.
struct KeptRun {
  CampaignRun run;
  RowColumns columns;
  std::optional<RunResult> result;
  Folder log_dir, commands_dir;
};

/// Of the facts in a campaign's manifest: the limit of a program's answers, where it is not the
/// usual.
inline constexpr const char* kAnswerLimitFact = "answer_limit_s";
inline constexpr const char* kSandboxFact = "sandbox";  // whether programs were confined
/// What a command needs to make runs again.
struct ReplayOptions {
  CommandOptions commands{.allow = true};
  std::string secret_file{};  // of a sealed campaign
};
/// Of the campaign in the folder: how it starts programs, and its secret.
/// @param secret_file  as the user named it; empty: a sealed campaign's is called FILE
ReplayOptions KeptReplayOptions(const std::filesystem::path& dir, const std::string& secret_file);
/// The command that runs one run again, to be pasted.
/// @param run      its number, or {run} for a reader to fill in; empty: the folder is of one run
/// @param options  those of programs are said where it starts one
std::string ReplayCommand(const std::string& program, const std::filesystem::path& dir,
                          const std::string& run, bool starts_program,
                          const ReplayOptions& options);

/// The folder of a campaign needs the run's number. That of a single run has none, nor has a run's
/// own folder within a campaign's. Says on standard error where models or program are not those of
/// the campaign.
/// @param command  as it is called, for messages: "replay"
/// Throws UsageError, ConfigError and ResultsError.
KeptRun FindKeptRun(const std::filesystem::path& dir, std::optional<int> number,
                    const std::string& command, const Invocation& call);

}  // namespace dockyard
