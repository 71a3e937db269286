#include "sim/app/campaign_end.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "sim/app/exit_codes.h"
#include "sim/app/kept_run.h"
#include "sim/app/terminal.h"
#include "sim/base/json.h"
#include "sim/campaign/campaign_folder.h"

namespace dockyard {
namespace {

/// Those with a log first: they can be replayed in full.
void PrintReplays(const FinishedRuns& runs, const std::filesystem::path& dir,
                  const Invocation& call) {
  constexpr int kMost = 10;
  const ReplayOptions options = KeptReplayOptions(dir, call.secret_file);
  int shown = 0;
  for (const bool logged : {true, false}) {
    for (const RunResult& result : runs.results) {
      if (result.success || IsLost(result.outcome)) continue;
      if (Folder(dir).HasFolder(RunFolder("", result.run)) != logged) continue;
      if (shown++ == kMost) return;
      const std::string command = ReplayCommand(call.program, dir, std::to_string(result.run),
                                                StartsProgram(result), options);
      std::printf("%s%s   # %s\n", shown == 1 ? "\nto run a failure again:\n" : "", command.c_str(),
                  result.outcome.c_str());
    }
  }
}

Json EndJson(const CampaignEnd& end, const std::vector<std::string>& warnings) {
  std::map<std::string, int> outcomes;
  int successes = 0, lost = 0;
  for (const RunResult& result : end.runs.results) {
    ++outcomes[result.outcome];
    successes += result.success ? 1 : 0;
    lost += IsLost(result.outcome) ? 1 : 0;
  }
  return {{"done", end.runs.size()}, {"total", end.total},
          {"successes", successes},  {"lost", lost},
          {"outcomes", outcomes},    {"warnings", warnings}};
}

}  // namespace

int ReportEnd(const CampaignEnd& end, const std::filesystem::path& dir, bool json,
              const Invocation& call) {
  if (json) {
    std::printf("%s\n", EndJson(end, call.warnings).dump().c_str());
  } else {
    std::printf("%s", end.summary.c_str());
    PrintReplays(end.runs, dir, call);
  }
  for (const std::string& place : end.damaged) {
    PrintNote("note: " + place + ": a damaged row was left out");
  }
  PrintNote("results and plots in " + dir.string());
  const bool any_lost = std::any_of(end.runs.results.begin(), end.runs.results.end(),
                                    [](const RunResult& result) { return IsLost(result.outcome); });
  return end.complete() && !any_lost ? kExitDone : kExitIncomplete;
}

}  // namespace dockyard
