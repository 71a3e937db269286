#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/kept_campaign.h"
#include "sim/app/terminal.h"
#include "sim/base/json.h"
#include "sim/report/rate_text.h"
#include "sim/statistics/paired.h"

namespace dockyard {
namespace {

struct CompareArguments {
  std::string dir, a, b;
  std::optional<int> only_a, only_b;
  bool json = false;
};

constexpr const char* kHelp =
    R"(Compare two arms of a campaign, run by run on the same draws.

Examples:
  dockyard compare --only-a 5 --only-b 14
  dockyard compare --only-a 5 --only-b 14 --json

Instead of counts, name the results folder of a campaign and two of its arms. Runs in which A alone
or B alone docked tell the two apart (McNemar's test, exact and mid-p).)";

struct Comparison {
  PairedCounts counts;
  int unpaired = 0;   // runs whose other half is missing
  bool whole = true;  // whether both and neither are known
};

/// Runs of both arms with the same seed and place are a pair.
Comparison CountPairs(const KeptCampaign& kept, const std::string& a, const std::string& b) {
  std::map<std::vector<std::string>, std::pair<const RunResult*, const RunResult*>> pairs;
  const auto add = [&](const std::string& arm, auto member) {
    for (const RunResult* run : RunsOfArm(kept, arm)) {
      std::vector<std::string> key(run->labels.begin() + 1, run->labels.end());
      key.push_back(std::to_string(run->seed));
      pairs[key].*member = run;
    }
  };
  using Pair = std::pair<const RunResult*, const RunResult*>;
  add(a, &Pair::first);
  add(b, &Pair::second);
  Comparison found;
  for (const auto& [key, pair] : pairs) {
    if (pair.first == nullptr || pair.second == nullptr) {
      ++found.unpaired;
      continue;
    }
    const bool of_a = pair.first->docked, of_b = pair.second->docked;
    found.counts.both += of_a && of_b;
    found.counts.only_a += of_a && !of_b;
    found.counts.only_b += !of_a && of_b;
    found.counts.neither += !of_a && !of_b;
  }
  return found;
}

Comparison Find(const CompareArguments& arguments, const std::vector<System>& systems) {
  const bool counted = arguments.only_a && arguments.only_b;
  const bool named = !arguments.dir.empty() && !arguments.a.empty() && !arguments.b.empty();
  if (counted == named || (!counted && (arguments.only_a || arguments.only_b))) {
    throw UsageError("expected DIR A B, or --only-a with --only-b");
  }
  if (counted) return {{0, *arguments.only_a, *arguments.only_b, 0}, 0, false};
  const KeptCampaign kept = ReadKeptCampaign(arguments.dir, systems);
  RequireArm(kept, arguments.a);
  RequireArm(kept, arguments.b);
  return CountPairs(kept, arguments.a, arguments.b);
}

void PrintJson(const Comparison& found) {
  const PairedCounts& counts = found.counts;
  Json json{{"only_a", counts.only_a},
            {"only_b", counts.only_b},
            {"exact", McNemarExact(counts.only_a, counts.only_b)},
            {"mid_p", McNemarMidP(counts.only_a, counts.only_b)}};
  if (found.whole) {
    const Estimate difference = PairedDifference(counts);
    json["both"] = counts.both;
    json["neither"] = counts.neither;
    json["difference"] = difference.value;
    json["difference_low"] = difference.interval.low;
    json["difference_high"] = difference.interval.high;
  }
  std::printf("%s\n", json.dump(2).c_str());
}

void Print(const Comparison& found, const std::string& a, const std::string& b) {
  const PairedCounts& counts = found.counts;
  if (found.whole) {
    const int pairs = counts.both + counts.only_a + counts.only_b + counts.neither;
    std::printf("%s: %s\n", a.c_str(), BriefRate(counts.both + counts.only_a, pairs).c_str());
    std::printf("%s: %s\n", b.c_str(), BriefRate(counts.both + counts.only_b, pairs).c_str());
    const Estimate difference = PairedDifference(counts);
    std::printf("%s less %s: %+.3f (95 %%, %+.3f to %+.3f; Newcombe)\n", a.c_str(), b.c_str(),
                difference.value, difference.interval.low, difference.interval.high);
  }
  std::printf("only %s docked %d times, only %s %d times: p = %.4f exact, %.4f mid-p (McNemar)\n",
              a.c_str(), counts.only_a, b.c_str(), counts.only_b,
              McNemarExact(counts.only_a, counts.only_b),
              McNemarMidP(counts.only_a, counts.only_b));
}

int Compare(const CompareArguments& arguments, const std::vector<System>& systems) {
  const Comparison found = Find(arguments, systems);
  if (found.unpaired > 0) {
    PrintNote("note: " + std::to_string(found.unpaired) + " runs have no partner yet");
  }
  if (arguments.json) {
    PrintJson(found);
  } else {
    Print(found, found.whole ? arguments.a : "A", found.whole ? arguments.b : "B");
  }
  return kExitDone;
}

}  // namespace

void AddCompareCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", kHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign with arms");
  command->add_option("A", arguments->a, "name of an arm");
  command->add_option("B", arguments->b, "name of another");
  const CLI::Range count(0, 1000000000);
  command->add_option("--only-a", arguments->only_a, "pairs in which A alone docked")->check(count);
  command->add_option("--only-b", arguments->only_b, "pairs in which B alone docked")->check(count);
  command->add_flag("--json", arguments->json, "print JSON");
  command->callback(
      [arguments, &systems, &exit_code] { exit_code = Compare(*arguments, systems); });
}

}  // namespace dockyard
