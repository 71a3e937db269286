#include "sim/app/judging.h"

#include <algorithm>
#include <cstdio>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/kept_run.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/base/shell_word.h"
#include "sim/report/junit.h"

namespace dockyard {
namespace {

void Print(const Judgement& judged, bool json, const std::vector<std::string>& warnings) {
  if (!json) {
    std::printf("%s\n", judged.text.c_str());
    return;
  }
  Json line{{"requirement", judged.requirement.text},
            {"met", judged.met},
            {"found", nullptr},
            {"runs", judged.count},
            {"warnings", warnings}};
  if (judged.count > 0) line["found"] = judged.found;
  std::printf("%s\n", line.dump().c_str());
}

/// Labels that tell a run's settings: draws are many, and its number stands for point and repeat.
std::vector<std::string> NamedLabels(const Campaign& campaign) {
  std::vector<std::string> named;
  for (const std::string& label : campaign.labels) {
    const bool drawn =
        std::any_of(campaign.dispersions.begin(), campaign.dispersions.end(),
                    [&](const Dispersion& dispersion) { return dispersion.key.name == label; });
    if (!drawn && label != "arm" && label != "point" && label != "repeat") named.push_back(label);
  }
  return named;
}

}  // namespace

std::string JUnitOf(const FinishedRuns& finished, const Campaign& campaign,
                    const RowColumns& columns, const std::filesystem::path& dir,
                    const std::vector<Judgement>& judged, const Invocation& call) {
  const ReplayOptions options = KeptReplayOptions(dir, call.secret_file);
  std::vector<JUnitRun> runs;
  for (std::size_t i = 0; i < finished.size(); ++i) {
    const RunResult& row = finished.results[i];
    JUnitRun run{&row, finished.timings[i].wall_time_s, finished.notes[i], ""};
    if (!row.success && !IsLost(row.outcome)) {
      run.replay =
          ReplayCommand(call.program, dir, std::to_string(row.run), StartsProgram(row), options);
    }
    runs.push_back(run);
  }
  const JUnitSuite suite{
      campaign.name, NamedLabels(campaign), {{"planned", std::to_string(campaign.run_count())}}};
  return JUnitXml(suite, columns, runs, judged);
}

void AddJudgingOptions(CLI::App& command, JudgingOptions& options) {
  command.add_option("--require", options.require,
                     "exit code 22 unless the results meet it, such as 'success >= 0.9'; may be "
                     "given again (docs/reference/judging.md)");
  command.add_option("--junit", options.junit_file,
                     "write the results as JUnit XML into this file");
}

std::string WordsOf(const JudgingOptions& options) {
  std::string words;
  for (const std::string& text : options.require) words += " --require " + ShellWord(text);
  if (!options.junit_file.empty()) words += " --junit " + ShellWord(options.junit_file);
  return words;
}

std::vector<Requirement> ReadRequirements(const JudgingOptions& options, const RowColumns& columns,
                                          const Campaign& campaign) {
  std::vector<Requirement> requirements;
  for (const std::string& text : options.require) {
    const auto parsed = ParseRequirement(text, columns, campaign);
    if (!parsed) throw UsageError("--require: " + parsed.error());
    requirements.push_back(*parsed);
  }
  return requirements;
}

int JudgeResults(const JudgingOptions& options, const std::vector<Requirement>& requirements,
                 const CampaignEnd& end, const Campaign& campaign, const RowColumns& columns,
                 const std::filesystem::path& dir, bool json, int code, const Invocation& call) {
  std::vector<Judgement> judged;
  for (const Requirement& requirement : requirements) {
    judged.push_back(Judge(requirement, columns, end.runs.results));
    Print(judged.back(), json, call.warnings);
  }
  if (!options.junit_file.empty()) {
    WriteWhole(options.junit_file, JUnitOf(end.runs, campaign, columns, dir, judged, call));
  }
  const bool met =
      std::all_of(judged.begin(), judged.end(), [](const Judgement& each) { return each.met; });
  return met || !end.complete() ? code : kExitNotMet;
}

}  // namespace dockyard
