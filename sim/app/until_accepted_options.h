// `campaign --until-accepted`: runs until a sequential test has decided.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "sim/app/invocation.h"
#include "sim/log/record.h"
#include "sim/plan/campaign.h"
#include "sim/statistics/sequential.h"

namespace dockyard {

struct UntilAcceptedOptions {
  bool asked = false;
  std::optional<double> reliability, design_reliability;
  double confidence = 0.95, power = 0.9;
  std::optional<int> max_runs;  // all runs of the campaign without it
};

void AddUntilAcceptedOptions(CLI::App& command, UntilAcceptedOptions& options);

/// The same options as words of a command line, each with a space before it.
std::string WordsOf(const UntilAcceptedOptions& options);

/// The test that was asked for; none if none was. Throws UsageError for aims that cannot be, and
/// for a campaign that the test cannot judge.
std::optional<SequentialPlan> PlanUntilAccepted(const UntilAcceptedOptions& options,
                                                const Campaign& campaign);

/// For CampaignOptions::enough: takes the runs' results in their order into `end`, true from the
/// decision on. Writes the aims into acceptance.json of the results folder before it looks at the
/// first result, and throws UsageError where the folder was begun with other aims.
std::function<bool(const RunResult&)> Follower(const std::filesystem::path& dir,
                                               const SequentialPlan& plan, SequentialEnd& end);

/// Writes where the test stands into acceptance.json. Throws IoError.
void KeepAcceptance(const std::filesystem::path& dir, const SequentialPlan& plan,
                    const SequentialEnd& end);

/// A campaign that goes on without the test in a folder that one ended: all its rows count again.
/// Throws IoError.
void GoOnPastAcceptance(const std::filesystem::path& dir);

/// Prints what was decided, as a line of JSON if asked. Returns the exit code: 0 accepted, 20 not
/// accepted, 21 undecided.
int ReportAcceptance(const SequentialPlan& plan, const SequentialEnd& end, bool json,
                     const Invocation& call);

}  // namespace dockyard
