// Options of the commands that end a campaign: requirements on its results, and a report for CI.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/app/invocation.h"
#include "sim/campaign/merge.h"
#include "sim/report/requirement.h"

namespace dockyard {

struct JudgingOptions {
  std::vector<std::string> require;
  std::string junit_file;
};

void AddJudgingOptions(CLI::App& command, JudgingOptions& options);

/// The same options as words of a command line, each with a space before it.
std::string WordsOf(const JudgingOptions& options);

/// To be called before the first run. Throws UsageError for a requirement that cannot be judged.
std::vector<Requirement> ReadRequirements(const JudgingOptions& options, const RowColumns& columns,
                                          const Campaign& campaign);

/// The results as JUnit XML, with a replay command for each failure.
/// @param dir      the campaign's results folder
/// @param program  as it was called, for the replay commands
std::string JUnitOf(const FinishedRuns& finished, const Campaign& campaign,
                    const RowColumns& columns, const std::filesystem::path& dir,
                    const std::vector<Judgement>& judged, const Invocation& call);

/// Prints what became of each requirement, as lines of JSON if asked, and writes the JUnit file.
/// @param code  the exit code without requirements
/// @return 22 where a requirement is not met and no run is missing, else `code`. Throws IoError.
int JudgeResults(const JudgingOptions& options, const std::vector<Requirement>& requirements,
                 const CampaignEnd& end, const Campaign& campaign, const RowColumns& columns,
                 const std::filesystem::path& dir, bool json, int code, const Invocation& call);

}  // namespace dockyard
