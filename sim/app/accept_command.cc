#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/kept_campaign.h"
#include "sim/app/number_option.h"
#include "sim/app/terminal.h"
#include "sim/base/count_text.h"
#include "sim/base/folder.h"
#include "sim/base/json.h"
#include "sim/report/point_verdicts.h"
#include "sim/report/sample.h"
#include "sim/report/until_accepted.h"
#include "sim/statistics/acceptance.h"

namespace dockyard {
namespace {

struct AcceptArguments {
  std::string dir, arm;
  std::vector<std::string> by;
  std::optional<int> trials, failures;
  double reliability = 0.0, confidence = 0.95;
  bool json = false;
};

constexpr const char* kAcceptHelp =
    R"(Say whether a campaign shows a reliability at a confidence.

Examples:
  dockyard accept --trials 628 --failures 2 --reliability 0.99 --confidence 0.95
  dockyard accept --trials 299 --failures 0 --reliability 0.99 --json

Instead of --trials and --failures, name the results folder of a campaign. Runs of a grid, a table
or keys set one at a time are no sample of one population: --by KEY judges each of the key's values
by itself, and may be given again. Exit code 0: accepted (each point of them), 20: not accepted, 21:
undecided. The confidence holds for a number of runs that is fixed before the first.)";

struct Counts {
  int trials = 0, failures = 0;
  std::int64_t planned = 0;  // 0: not known
};

bool HasLabel(const KeptCampaign& kept, const std::string& label) {
  const std::vector<std::string>& labels = kept.columns.labels;
  return label == "controller" || std::find(labels.begin(), labels.end(), label) != labels.end();
}

/// Throws UsageError for runs that are no sample of one population.
void RequireSample(const Campaign& campaign) {
  const std::string why = WhyNoSample(campaign);
  if (why.empty()) return;
  const std::string expected = "DIR: expected a campaign whose runs are drawn alike: " + why;
  if (!WhyDependent(campaign).empty()) {
    throw UsageError(expected + "; make it with design.kind=monte_carlo");
  }
  std::string keys;
  for (const std::string& label : SettingLabels(campaign)) {
    if (label != "arm") keys += " --by " + label;
  }
  throw UsageError(expected + ";" + (keys.empty() ? " --by TAG" : keys) +
                   " judges each point by itself, --trials and --failures take counts");
}

/// Those of one arm, unless the arm is a key of the points.
Rows JudgedRuns(const KeptCampaign& kept, const AcceptArguments& arguments) {
  const bool by_arm =
      std::find(arguments.by.begin(), arguments.by.end(), "arm") != arguments.by.end();
  const bool one_arm = !arguments.arm.empty() || (!kept.campaign.arms.empty() && !by_arm);
  if (one_arm) RequireArm(kept, arguments.arm);
  return RunsOfArm(kept, arguments.arm);
}

/// Runs that are planned of those judged.
std::int64_t PlannedRuns(const KeptCampaign& kept, const AcceptArguments& arguments) {
  return kept.campaign.run_count() / (arguments.arm.empty() ? 1 : kept.campaign.arm_count());
}

void WarnOfSequentialTest(const std::string& dir, Invocation& call) {
  if (!Folder(dir).HasFile(kAcceptanceFile)) return;
  Warn("a sequential test ended this campaign (" + std::string(kAcceptanceFile) +
           "); the confidence of this verdict holds for a fixed number of runs alone",
       &call.warnings);
}

void WarnOfMissingRuns(std::int64_t there, std::int64_t planned, Invocation& call) {
  if (planned <= there) return;
  Warn(std::to_string(there) + " of " + std::to_string(planned) +
           " planned runs are there; a verdict on a part, asked for again and again, is wrong "
           "more often than the confidence says",
       &call.warnings);
}

Counts CountsOf(const AcceptArguments& arguments, Invocation& call) {
  if (arguments.trials && arguments.failures && arguments.dir.empty()) {
    if (*arguments.failures > *arguments.trials) {
      throw UsageError("--failures: expected at most the " + CountText(*arguments.trials, "trial") +
                       ", found " + std::to_string(*arguments.failures));
    }
    return {*arguments.trials, *arguments.failures, 0};
  }
  if (arguments.trials || arguments.failures || arguments.dir.empty()) {
    throw UsageError("expected DIR, or --trials with --failures");
  }
  const KeptCampaign kept = ReadKeptCampaign(arguments.dir, call.systems);
  RequireSample(kept.campaign);
  WarnOfSequentialTest(arguments.dir, call);
  Counts counts;
  for (const RunResult* run : JudgedRuns(kept, arguments)) {
    ++counts.trials;
    counts.failures += run->success ? 0 : 1;
  }
  counts.planned = PlannedRuns(kept, arguments);
  return counts;
}

Json AcceptanceJson(const Counts& counts, const AcceptArguments& arguments, const Acceptance& found,
                    const std::vector<std::string>& warnings) {
  Json json{{"verdict", NameOf(found.verdict)},
            {"trials", counts.trials},
            {"failures", counts.failures},
            {"reliability", arguments.reliability},
            {"confidence", arguments.confidence},
            {"lower", found.lower},
            {"upper", found.upper},
            {"further_runs", nullptr}};
  if (found.further_runs) json["further_runs"] = *found.further_runs;
  if (counts.planned > 0) json["planned"] = counts.planned;
  json["warnings"] = warnings;
  return json;
}

void Print(const Counts& counts, const AcceptArguments& arguments, const Acceptance& found) {
  std::printf("%s, %s: reliability at least %.6g, at most %.6g (each at %s %%)\n",
              CountText(counts.trials, "trial").c_str(),
              CountText(counts.failures, "failure").c_str(), found.lower, found.upper,
              NumberText(100.0 * arguments.confidence).c_str());
  std::printf("%s: reliability %s at confidence %s\n", NameOf(found.verdict),
              NumberText(arguments.reliability).c_str(), NumberText(arguments.confidence).c_str());
  if (found.verdict != AcceptanceVerdict::kUndecided) return;
  if (found.further_runs) {
    std::printf("%s without a failure would be accepted\n",
                CountText(*found.further_runs, "further run").c_str());
  } else {
    std::printf("no number of further runs would be accepted\n");
  }
}

int CodeOf(AcceptanceVerdict verdict) {
  if (verdict == AcceptanceVerdict::kAccepted) return kExitDone;
  return verdict == AcceptanceVerdict::kNotAccepted ? kExitNotAccepted : kExitUndecided;
}

/// Throws UsageError unless the runs of each point are a sample.
void RequirePoints(const KeptCampaign& kept, const std::vector<std::string>& by, const Rows& rows) {
  for (const std::string& key : by) {
    if (HasLabel(kept, key)) continue;
    std::string names;
    for (const std::string& label : kept.columns.labels) names += " " + label;
    throw UsageError("--by: expected a label of the campaign (" +
                     (names.empty() ? "it has none" : names.substr(1)) + "), found '" + key + "'");
  }
  const std::string why = WhyDependent(kept.campaign);
  if (!why.empty()) {
    throw UsageError("--by: expected runs that are drawn alike at each point: " + why +
                     "; make them with design.kind=monte_carlo");
  }
  for (const Point& point : ByPoint(by, kept.columns, rows)) {
    const std::vector<std::string> differing =
        DifferingLabels(SettingLabels(kept.campaign), kept.columns, point.rows);
    if (differing.empty()) continue;
    throw UsageError(
        "--by: expected keys that tell all points apart: runs of one point differ in " +
        differing.front() + "; add --by " + differing.front());
  }
}

int AcceptPoints(const AcceptArguments& arguments, Invocation& call) {
  if (arguments.trials || arguments.failures || arguments.dir.empty()) {
    throw UsageError("--by: expected DIR with it, and neither --trials nor --failures");
  }
  const KeptCampaign kept = ReadKeptCampaign(arguments.dir, call.systems);
  const Rows rows = JudgedRuns(kept, arguments);
  RequirePoints(kept, arguments.by, rows);
  WarnOfSequentialTest(arguments.dir, call);
  const std::int64_t planned = PlannedRuns(kept, arguments),
                     there = static_cast<std::int64_t>(rows.size());
  WarnOfMissingRuns(there, planned, call);
  const PointVerdicts judged =
      JudgePoints(arguments.by, kept.columns, rows, arguments.reliability, arguments.confidence);
  AcceptanceVerdict verdict = judged.verdict();
  // A point that has no run yet has no verdict.
  if (there < planned && verdict == AcceptanceVerdict::kAccepted) {
    verdict = AcceptanceVerdict::kUndecided;
  }
  if (arguments.json) {
    Json json = PointVerdictsJson(judged, verdict);
    json["planned"] = planned;
    json["warnings"] = call.warnings;
    std::printf("%s\n", json.dump(2).c_str());
  } else {
    std::printf("%s", PointVerdictsText(judged, verdict).c_str());
  }
  return CodeOf(verdict);
}

int Accept(const AcceptArguments& arguments, Invocation& call) {
  if (!arguments.by.empty()) return AcceptPoints(arguments, call);
  const Counts counts = CountsOf(arguments, call);
  if (counts.planned > 0) WarnOfMissingRuns(counts.trials, counts.planned, call);
  const Acceptance found =
      JudgeAcceptance(counts.trials, counts.failures, arguments.reliability, arguments.confidence);
  if (arguments.json) {
    std::printf("%s\n", AcceptanceJson(counts, arguments, found, call.warnings).dump(2).c_str());
  } else {
    Print(counts, arguments, found);
  }
  return CodeOf(found.verdict);
}

}  // namespace

void AddAcceptCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<AcceptArguments>();
  CLI::App* command = app.add_subcommand("accept", kAcceptHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign")->type_name("DIR");
  command->add_option("--arm", arguments->arm, "the arm that is judged, where a campaign has arms");
  command
      ->add_option("--by", arguments->by,
                   "a label, such as a key of the grid: a verdict for each of its values")
      ->type_name("KEY")
      ->allow_extra_args(false);
  command->add_option("--trials", arguments->trials, "number of runs")
      ->check(CLI::Range(0, 2000000000));
  command->add_option("--failures", arguments->failures, "number of runs that failed")
      ->check(CLI::Range(0, 2000000000));
  command->add_option("--reliability", arguments->reliability, "share of runs that must succeed")
      ->required()
      ->check(NumberWithin(1e-9, 1.0));
  command->add_option("--confidence", arguments->confidence, "of the verdict [0.95]")
      ->check(NumberWithin(0.5, 1.0 - 1e-12));
  command->add_flag("--json", arguments->json, "print JSON");
  command->callback([arguments, &call] { call.exit_code = Accept(*arguments, call); });
}

}  // namespace dockyard
