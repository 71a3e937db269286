#include "sim/app/until_accepted_options.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/number_option.h"
#include "sim/base/folder.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/report/until_accepted.h"

namespace dockyard {
namespace {

constexpr int kMostRuns = 1000000;  // the exact recursion takes 20 ms for so many

int MaxRunsOf(const UntilAcceptedOptions& options, const Campaign& campaign) {
  const std::int64_t planned = campaign.run_count();
  if (options.max_runs && *options.max_runs > planned) {
    throw UsageError("--max-runs: expected at most the " + std::to_string(planned) +
                     " runs of the campaign (--set design.runs=N for more), found " +
                     std::to_string(*options.max_runs));
  }
  return options.max_runs.value_or(static_cast<int>(std::min<std::int64_t>(planned, kMostRuns)));
}

void RequireTheseAims(const std::filesystem::path& dir, const SequentialAims& aims) {
  const auto kept = Folder(dir).Read(kAcceptanceFile, kMostTextBytes);
  if (!kept || HasTheseAims(*kept, aims)) return;
  throw UsageError("--until-accepted: " + (dir / kAcceptanceFile).string() +
                   " has other aims; aims that are chosen after a look have other risks: choose "
                   "another folder with --out");
}

}  // namespace

void AddUntilAcceptedOptions(CLI::App& command, UntilAcceptedOptions& options) {
  command.add_flag("--until-accepted", options.asked,
                   "end as soon as a sequential test of the reliability has decided");
  command.add_option("--reliability", options.reliability, "share of runs that must succeed")
      ->check(NumberWithin(1e-9, 1.0 - 1e-9));
  command
      .add_option("--design-reliability", options.design_reliability,
                  "a higher one, at which the system should be accepted")
      ->check(NumberWithin(1e-9, 1.0 - 1e-9));
  command.add_option("--confidence", options.confidence, "of accepting [0.95]")
      ->check(NumberWithin(0.5, 1.0 - 1e-12));
  command.add_option("--power", options.power, "chance to accept at the design reliability [0.9]")
      ->check(NumberWithin(0.5, 1.0 - 1e-12));
  command.add_option("--max-runs", options.max_runs, "then undecided [all runs]")
      ->check(CLI::Range(1, kMostRuns));
}

std::string WordsOf(const UntilAcceptedOptions& options) {
  if (!options.asked) return "";
  const UntilAcceptedOptions usual;
  std::string words = " --until-accepted";
  const auto add = [&](const char* name, double value) {
    words += std::string(" ") + name + " " + NumberText(value);
  };
  if (options.reliability) add("--reliability", *options.reliability);
  if (options.design_reliability) add("--design-reliability", *options.design_reliability);
  if (options.confidence != usual.confidence) add("--confidence", options.confidence);
  if (options.power != usual.power) add("--power", options.power);
  if (options.max_runs) add("--max-runs", *options.max_runs);
  return words;
}

std::optional<SequentialPlan> PlanUntilAccepted(const UntilAcceptedOptions& options,
                                                const Campaign& campaign) {
  if (!options.asked) {
    if (options.reliability || options.design_reliability || options.max_runs) {
      throw UsageError(
          "--reliability, --design-reliability and --max-runs: expected them with "
          "--until-accepted");
    }
    return std::nullopt;
  }
  if (!options.reliability || !options.design_reliability) {
    throw UsageError("--until-accepted: expected --reliability and --design-reliability");
  }
  if (*options.design_reliability <= *options.reliability) {
    throw UsageError("--design-reliability: expected more than the reliability " +
                     NumberText(*options.reliability) + ", found " +
                     NumberText(*options.design_reliability));
  }
  const std::string why = WhyNotSequential(campaign);
  if (!why.empty()) {
    throw UsageError("--until-accepted: expected a campaign whose runs are drawn alike: " + why);
  }
  return PlanSequential({.reliability = *options.reliability,
                         .confidence = options.confidence,
                         .design_reliability = *options.design_reliability,
                         .power = options.power,
                         .max_runs = MaxRunsOf(options, campaign)});
}

std::function<bool(const RunResult&)> Follower(const std::filesystem::path& dir,
                                               const SequentialPlan& plan, SequentialEnd& end) {
  return [dir, &plan, &end](const RunResult& row) {
    if (end.trials == 0) {
      RequireTheseAims(dir, plan.aims);
      KeepAcceptance(dir, plan, end);
    }
    FollowRun(plan, !row.success, end);
    return end.state != SequentialState::kContinue;
  };
}

void KeepAcceptance(const std::filesystem::path& dir, const SequentialPlan& plan,
                    const SequentialEnd& end) {
  Folder(dir).Write(kAcceptanceFile, SequentialJson(plan, end).dump(2) + "\n");
}

void GoOnPastAcceptance(const std::filesystem::path& dir) {
  const auto kept = Folder(dir).Read(kAcceptanceFile, kMostTextBytes);
  if (!kept || DecidedRuns(*kept) == 0) return;
  Folder(dir).Write(kAcceptanceFile, WentOnText(*kept));
}

int ReportAcceptance(const SequentialPlan& plan, const SequentialEnd& end, bool json,
                     const Invocation& call) {
  if (json) {
    Json answer = SequentialJson(plan, end);
    answer["warnings"] = call.warnings;
    std::printf("%s\n", answer.dump().c_str());
  } else {
    std::printf("\n%s", SequentialText(plan, end).c_str());
  }
  if (end.state == SequentialState::kAccepted) return kExitDone;
  return end.state == SequentialState::kRejected ? kExitNotAccepted : kExitUndecided;
}

}  // namespace dockyard
