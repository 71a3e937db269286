#include <cstdio>
#include <filesystem>
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
#include "sim/base/text.h"
#include "sim/report/until_accepted.h"
#include "sim/statistics/acceptance.h"

namespace dockyard {
namespace {

struct AcceptArguments {
  std::string dir, arm;
  std::optional<int> trials, failures;
  double reliability = 0.0, confidence = 0.95;
  bool json = false;
};

constexpr const char* kAcceptHelp =
    R"(Say whether a campaign shows a reliability at a confidence.

Examples:
  dockyard accept --trials 628 --failures 2 --reliability 0.99 --confidence 0.95
  dockyard accept --trials 299 --failures 0 --reliability 0.99 --json

Instead of --trials and --failures, name the results folder of a campaign. Exit code 0: accepted,
20: not accepted, 21: undecided. The confidence holds for a number of runs that is fixed before
the first.)";

struct Counts {
  int trials = 0, failures = 0;
  std::int64_t planned = 0;  // 0: not known
};

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
  if (Folder(arguments.dir).HasFile(kAcceptanceFile)) {
    Warn("a sequential test ended this campaign (" + std::string(kAcceptanceFile) +
             "); the confidence of this verdict holds for a fixed number of runs alone",
         &call.warnings);
  }
  if (!kept.campaign.arms.empty() || !arguments.arm.empty()) RequireArm(kept, arguments.arm);
  Counts counts;
  for (const RunResult* run : RunsOfArm(kept, arguments.arm)) {
    ++counts.trials;
    counts.failures += run->docked ? 0 : 1;
  }
  counts.planned = kept.campaign.run_count() / kept.campaign.arm_count();
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

int Accept(const AcceptArguments& arguments, Invocation& call) {
  const Counts counts = CountsOf(arguments, call);
  if (counts.planned > counts.trials) {
    Warn(std::to_string(counts.trials) + " of " + std::to_string(counts.planned) +
             " planned runs are there; a verdict on a part, asked for again and again, is wrong "
             "more often than the confidence says",
         &call.warnings);
  }
  const Acceptance found =
      JudgeAcceptance(counts.trials, counts.failures, arguments.reliability, arguments.confidence);
  if (arguments.json) {
    std::printf("%s\n", AcceptanceJson(counts, arguments, found, call.warnings).dump(2).c_str());
  } else {
    Print(counts, arguments, found);
  }
  if (found.verdict == AcceptanceVerdict::kAccepted) return kExitDone;
  return found.verdict == AcceptanceVerdict::kNotAccepted ? kExitNotAccepted : kExitUndecided;
}

}  // namespace

void AddAcceptCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<AcceptArguments>();
  CLI::App* command = app.add_subcommand("accept", kAcceptHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign")->type_name("DIR");
  command->add_option("--arm", arguments->arm, "the arm that is judged, where a campaign has arms");
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
