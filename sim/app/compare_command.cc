#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/compare_groups.h"
#include "sim/app/exit_codes.h"
#include "sim/app/kept_campaign.h"
#include "sim/app/number_option.h"
#include "sim/app/terminal.h"
#include "sim/base/count_text.h"
#include "sim/base/json.h"
#include "sim/report/arm_pairs.h"
#include "sim/report/baseline.h"
#include "sim/report/rate_text.h"
#include "sim/statistics/paired.h"

namespace dockyard {
namespace {

struct CompareArguments {
  std::string dir, a, b, baseline;
  std::optional<int> only_a, only_b;
  std::optional<double> fail_if_worse;
  bool json = false;
};

constexpr const char* kCompareHelp =
    R"(Compare two arms or groups of runs of a campaign, or a campaign with a kept one.

Examples:
  dockyard compare --only-a 5 --only-b 14
  dockyard compare --only-a 5 --only-b 14 --fail-if-worse 0.001 --json

Instead of counts, name the results folder of a campaign and two of its arms, or two values of a
label as KEY=A KEY=B, or --baseline with the results of the same campaign file by another build.
Runs in which A alone or B alone succeeded tell the two apart (McNemar's test, exact and mid-p);
groups that share no draws are compared as they are (Fisher's exact test). With --fail-if-worse,
exit code 23: A is worse.)";

struct Comparison {
  std::string a = "A", b = "B";  // their names
  PairedCounts counts;
  bool whole = true;               // whether both and neither are known
  std::string word = "succeeded";  // SuccessWord
  int unpaired = 0;                // runs of arms whose other half is missing
  std::optional<BaselinePairs> baseline;
  std::optional<GroupCounts> apart;  // groups without pairs; counts has nothing then

  double ChanceOfWorse() const {
    return apart ? ChanceOfAWorseGroup(*apart) : ChanceOfAWorse(counts.only_a, counts.only_b);
  }
};

Comparison CompareByLabel(const KeptCampaign& kept, const std::string& a, const std::string& b,
                          std::vector<std::string>* warnings) {
  const ComparedGroups groups = CompareGroups(kept, a, b);
  Comparison found;
  found.a = a;
  found.b = b;
  found.counts = groups.pairs.counts;
  found.unpaired = groups.pairs.unpaired;
  found.word = SuccessWord(kept.columns, kept.runs.results);
  found.apart = groups.apart;
  if (!groups.pooled.empty()) {
    Warn("runs of a group differ in " + groups.pooled + " as well, and are counted together",
         warnings);
  }
  return found;
}

Comparison CompareArms(const KeptCampaign& kept, const std::string& a, const std::string& b) {
  const ArmPairs pairs = PairArms(RunsOfArm(kept, a), RunsOfArm(kept, b));
  Comparison found;
  found.a = a;
  found.b = b;
  found.counts = pairs.counts;
  found.unpaired = pairs.unpaired;
  found.word = SuccessWord(kept.columns, kept.runs.results);
  return found;
}

std::vector<RunResult> RowsOfArm(const KeptCampaign& kept, const std::string& arm) {
  if (!arm.empty()) RequireArm(kept, arm);
  std::vector<RunResult> rows;
  for (const RunResult* run : RunsOfArm(kept, arm)) rows.push_back(*run);
  return rows;
}

Comparison CompareBaseline(const CompareArguments& arguments, const std::vector<System>& systems) {
  const KeptCampaign here = ReadKeptCampaign(arguments.dir, systems),
                     there = ReadKeptCampaign(arguments.baseline, systems);
  Comparison found;
  found.a = "this campaign";
  found.b = "the baseline";
  found.word = SuccessWord(here.columns, here.runs.results);
  found.baseline = PairWithBaseline(here.columns, RowsOfArm(here, arguments.a), there.columns,
                                    RowsOfArm(there, arguments.a));
  found.counts = found.baseline->counts;
  if (found.counts.both + found.counts.neither + found.counts.only_a + found.counts.only_b == 0) {
    throw UsageError(
        "--baseline: expected runs with the number, seed and labels of runs in DIR, found none in "
        "'" +
        arguments.baseline + "'");
  }
  return found;
}

Comparison Find(const CompareArguments& arguments, Invocation& call) {
  const std::vector<System>& systems = call.systems;
  const bool counted = arguments.only_a && arguments.only_b,
             against_baseline = !arguments.dir.empty() && !arguments.baseline.empty(),
             arms = !arguments.dir.empty() && !arguments.b.empty();
  const bool strange = arguments.only_a.has_value() != arguments.only_b.has_value() ||
                       (counted && !arguments.dir.empty()) ||
                       (against_baseline && !arguments.b.empty());
  if (strange || !(counted || against_baseline || arms)) {
    throw UsageError(
        "expected DIR A B, DIR KEY=A KEY=B, DIR with --baseline and perhaps one arm, or --only-a "
        "with --only-b");
  }
  if (counted) {
    Comparison found;
    found.counts = {0, *arguments.only_a, *arguments.only_b, 0};
    found.whole = false;
    return found;
  }
  if (against_baseline) return CompareBaseline(arguments, systems);
  const KeptCampaign kept = ReadKeptCampaign(arguments.dir, systems);
  if (NameGroups(kept, arguments.a, arguments.b)) {
    return CompareByLabel(kept, arguments.a, arguments.b, &call.warnings);
  }
  RequireArm(kept, arguments.a);
  RequireArm(kept, arguments.b);
  return CompareArms(kept, arguments.a, arguments.b);
}

Json ShareJson(int runs, int successes) {
  return {{"runs", runs}, {"successes", successes}, {"docked", successes}};  // the former name
}

Json GroupsJson(const GroupCounts& counts) {
  const Estimate difference = GroupDifference(counts);
  return {{"paired", false},
          {"a", ShareJson(counts.runs_a, counts.successes_a)},
          {"b", ShareJson(counts.runs_b, counts.successes_b)},
          {"exact", FisherExact(counts)},
          {"a_worse", ChanceOfAWorseGroup(counts)},
          {"difference", difference.value},
          {"difference_low", difference.interval.low},
          {"difference_high", difference.interval.high}};
}

void PrintJson(const Comparison& found, const std::vector<std::string>& warnings) {
  const PairedCounts& counts = found.counts;
  if (found.apart) {
    Json json = GroupsJson(*found.apart);
    json["warnings"] = warnings;
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  Json json{{"paired", true},
            {"only_a", counts.only_a},
            {"only_b", counts.only_b},
            {"exact", McNemarExact(counts.only_a, counts.only_b)},
            {"mid_p", McNemarMidP(counts.only_a, counts.only_b)},
            {"a_worse", ChanceOfAWorse(counts.only_a, counts.only_b)}};
  if (found.whole) {
    const Estimate difference = PairedDifference(counts);
    json["both"] = counts.both;
    json["neither"] = counts.neither;
    json["difference"] = difference.value;
    json["difference_low"] = difference.interval.low;
    json["difference_high"] = difference.interval.high;
  }
  if (found.baseline) {
    json["same_bits"] = found.baseline->same_bits;
    json["lost"] = found.baseline->lost;
    json["won"] = found.baseline->won;
    json["only_here"] = found.baseline->only_here;
    json["only_there"] = found.baseline->only_there;
    json["other_draw"] = found.baseline->other_draw;
  }
  json["warnings"] = warnings;
  std::printf("%s\n", json.dump(2).c_str());
}

/// "3 runs docked in the baseline alone: 4 17 20"; nothing without runs.
/// @param one, many  what is said of one run, and of several; many empty: the same
void PrintRuns(const std::vector<int>& runs, const std::string& one, const std::string& many = "") {
  constexpr std::size_t kMostShown = 12;
  if (runs.empty()) return;
  std::string text =
      CountText(runs.size(), "run " + one, "runs " + (many.empty() ? one : many)) + ":";
  for (std::size_t i = 0; i < std::min(runs.size(), kMostShown); ++i) {
    text += " " + std::to_string(runs[i]);
  }
  std::printf("%s%s\n", text.c_str(), runs.size() > kMostShown ? " ..." : "");
}

void PrintBaseline(const BaselinePairs& pairs, const std::string& word) {
  const int count =
      pairs.counts.both + pairs.counts.only_a + pairs.counts.only_b + pairs.counts.neither;
  std::printf("%s, %d of them the same bit for bit\n", CountText(count, "pair").c_str(),
              pairs.same_bits);
  PrintRuns(pairs.lost, word + " in the baseline alone");
  PrintRuns(pairs.won, word + " here alone");
  PrintRuns(pairs.only_here, "is not in the baseline", "are not in the baseline");
  PrintRuns(pairs.only_there, "is in the baseline alone", "are in the baseline alone");
  PrintRuns(pairs.other_draw, "has another seed or other labels there, and no partner",
            "have another seed or other labels there, and no partner");
}

void PrintRate(const std::string& name, const std::string& word, int successes, int runs) {
  std::printf("%s: %s %s\n", name.c_str(), word.c_str(), RateText(successes, runs).c_str());
}

void PrintGroups(const GroupCounts& counts, const Comparison& found) {
  const char *a = found.a.c_str(), *b = found.b.c_str();
  PrintRate(found.a, found.word, counts.successes_a, counts.runs_a);
  PrintRate(found.b, found.word, counts.successes_b, counts.runs_b);
  const Estimate difference = GroupDifference(counts);
  std::printf("%s less %s: %+.3f (95 %%, %+.3f to %+.3f; Newcombe)\n", a, b, difference.value,
              difference.interval.low, difference.interval.high);
  std::printf("the groups share no draws: %s exact (Fisher)\n", PText(FisherExact(counts)).c_str());
}

void Print(const Comparison& found) {
  const PairedCounts& counts = found.counts;
  const char *a = found.a.c_str(), *b = found.b.c_str();
  if (found.apart) return PrintGroups(*found.apart, found);
  if (found.whole) {
    const int pairs = counts.both + counts.only_a + counts.only_b + counts.neither;
    PrintRate(found.a, found.word, counts.both + counts.only_a, pairs);
    PrintRate(found.b, found.word, counts.both + counts.only_b, pairs);
    const Estimate difference = PairedDifference(counts);
    std::printf("%s less %s: %+.3f (95 %%, %+.3f to %+.3f; Newcombe)\n", a, b, difference.value,
                difference.interval.low, difference.interval.high);
  }
  std::printf("only %s %s %s, only %s %s: %s exact, %s mid-p (McNemar)\n", a, found.word.c_str(),
              CountText(counts.only_a, "time").c_str(), b, CountText(counts.only_b, "time").c_str(),
              PText(McNemarExact(counts.only_a, counts.only_b)).c_str(),
              ChanceText(McNemarMidP(counts.only_a, counts.only_b)).c_str());
  if (found.baseline) PrintBaseline(*found.baseline, found.word);
}

int Compare(const CompareArguments& arguments, Invocation& call) {
  const Comparison found = Find(arguments, call);
  if (found.unpaired > 0) {
    Warn(CountText(found.unpaired, "run has", "runs have") + " no partner yet", &call.warnings);
  }
  if (arguments.json) {
    PrintJson(found, call.warnings);
  } else {
    Print(found);
  }
  if (!arguments.fail_if_worse) return kExitDone;
  const double chance = found.ChanceOfWorse();
  const bool worse = chance <= *arguments.fail_if_worse;
  PrintNote(found.a + (worse ? " is worse than " : " is not shown to be worse than ") + found.b +
            ": p = " + BriefNumber(chance) + ", one-sided, exact");
  return worse ? kExitWorse : kExitDone;
}

}  // namespace

void AddCompareCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", kCompareHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign")->type_name("DIR");
  command->add_option("A", arguments->a, "name of an arm, or KEY=VALUE with a label");
  command->add_option("B", arguments->b, "another, of the same key");
  command->add_option("--baseline", arguments->baseline,
                      "results folder of the same campaign by another build");
  const CLI::Range count(0, 1000000000);
  command->add_option("--only-a", arguments->only_a, "pairs in which A alone succeeded")
      ->check(count);
  command->add_option("--only-b", arguments->only_b, "pairs in which B alone succeeded")
      ->check(count);
  command
      ->add_option("--fail-if-worse", arguments->fail_if_worse,
                   "exit code 23 where A is worse with at most this chance of error")
      ->check(NumberWithin(1e-12, 0.5));
  command->add_flag("--json", arguments->json, "print JSON");
  command->callback([arguments, &call] { call.exit_code = Compare(*arguments, call); });
}

}  // namespace dockyard
