#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/kept_campaign.h"
#include "sim/app/scenario_options.h"
#include "sim/base/count_text.h"
#include "sim/base/random.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/shard_file.h"
#include "sim/log/result_row.h"
#include "sim/log/run_log.h"
#include "sim/plan/make_run.h"
#include "sim/report/until_accepted.h"
#include "sim/run/loop.h"

namespace dockyard {
namespace {

struct AuditArguments {
  std::string dir;
  int sample = 10;
  std::optional<std::uint64_t> seed;  // of the choice; none: from the system
  CommandOptions commands;
  bool json = false;
};

constexpr const char* kAuditHelp =
    R"(Simulate some runs of a campaign again and compare their rows bit for bit.

Examples:
  dockyard audit results/{campaign_name}
  dockyard audit results/{campaign_name} --sample 2 --json

The runs are drawn at random, so that nobody knows beforehand which rows are compared. A program
that is the controller is started with --allow-commands. Without it the commands in the run's log
are given again. Each line of results.csv must be the row of its run.

Exit code 0: all runs of the sample are the same; 1: a row differs; 10: a run of the sample could
not be compared, as it has no row, was lost, or has no log of its commands.

--json prints {sampled, same, differs: [{run, why}], not_compared: [{run, why}], warnings}.)";

struct Audited {
  int run = 0;
  bool compared = true;
  std::string why;  // empty: the row is the same
};

std::string TextOf(const std::vector<DifferingCell>& cells) {
  std::string text;
  for (const DifferingCell& cell : cells) {
    text += (text.empty() ? "" : ", ") + cell.column + " was " + cell.was + ", is " + cell.is;
  }
  return text;
}

Audited AuditRun(const RunResult& row, const std::filesystem::path& dir, const RunMaker& maker,
                 const KeptCampaign& kept, const System& system, const CommandOptions& commands) {
  const std::int64_t index = maker.IndexOf(row.run);
  if (IsLost(row.outcome)) return {row.run, false, "it " + row.outcome};
  RunOptions options{.log_dir = {}, .labels = kept.columns.labels, .results_dir = dir};
  commands.Fill(options);
  if (StartsProgram(row) && !commands.allow) {
    options.recorded_dir = FolderOfCommands(dir, row.run);
    if (!options.recorded_dir->HasFile(kRunLogFile)) {
      return {row.run, false, "there is no log of its commands"};
    }
  }
  try {
    const RunRecord now = Simulate(system, maker.Make(index), options);
    return {row.run, true, TextOf(DifferingCells(row, now.result, kept.columns))};
  } catch (const DataError& error) {
    return {row.run, true, error.what()};
  }
}

/// Lines of results.csv that are not the rows of the shards.
std::vector<Audited> AuditTable(const std::filesystem::path& dir, const KeptCampaign& kept) {
  const auto text = Folder(dir).Read("results.csv", kMostShardBytes);
  if (!text) return {};
  std::vector<Audited> differing;
  std::istringstream lines(*text);
  std::string line;
  std::getline(lines, line);
  const bool former = line == CsvHeader(FormerColumns(kept.columns));
  const RowColumns columns = former ? FormerColumns(kept.columns) : kept.columns;
  if (line != CsvHeader(columns)) return {{0, true, "results.csv has other columns"}};
  std::size_t place = 0;
  const std::vector<RunResult>& rows = kept.runs.results;
  for (; std::getline(lines, line); ++place) {
    if (place >= rows.size()) return {{0, true, "results.csv has more lines than there are rows"}};
    if (line != CsvRow(rows[place], columns)) {
      differing.push_back({rows[place].run, true, "its line in results.csv is not its row"});
    }
  }
  if (place < rows.size()) differing.push_back({rows[place].run, true, "it is not in results.csv"});
  return differing;
}

/// So many of the places from 0 to count - 1, in order; each choice is as likely as another.
std::vector<std::size_t> Sample(std::size_t count, int wanted, std::uint64_t seed) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  RandomStream random(StreamKey(seed, "audit"));
  const std::size_t size = std::min(count, static_cast<std::size_t>(wanted));
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t left = count - i;
    const auto further = static_cast<std::size_t>(random.Uniform() * static_cast<double>(left));
    std::swap(places[i], places[i + std::min(further, left - 1)]);
  }
  places.resize(size);
  std::sort(places.begin(), places.end());
  return places;
}

void PrintText(const std::vector<Audited>& all, int sampled, int same) {
  for (const Audited& each : all) {
    const std::string found = each.why.empty() ? "the same, bit for bit"
                              : each.compared  ? "differs: " + each.why
                                               : "not compared: " + each.why;
    std::printf("run %d: %s\n", each.run, found.c_str());
  }
  std::printf("%d of %s the same\n", same, CountText(sampled, "run").c_str());
}

/// @param sampled  how many, from the first on, are runs of the sample; the others are lines of the
///                 table
int Answer(const std::vector<Audited>& all, int sampled, bool as_json, const Invocation& call) {
  Json differs = Json::array(), not_compared = Json::array();
  for (const Audited& each : all) {
    if (each.why.empty()) continue;
    (each.compared ? differs : not_compared).push_back({{"run", each.run}, {"why", each.why}});
  }
  const int same = static_cast<int>(std::count_if(
      all.begin(), all.begin() + sampled, [](const Audited& each) { return each.why.empty(); }));
  if (as_json) {
    const Json answer{{"sampled", sampled},
                      {"same", same},
                      {"differs", differs},
                      {"not_compared", not_compared},
                      {"warnings", call.warnings}};
    std::printf("%s\n", answer.dump(1).c_str());
  } else {
    PrintText(all, sampled, same);
  }
  if (!differs.empty()) return kExitOurBug;
  return same < sampled ? kExitIncomplete : kExitDone;
}

int Audit(const AuditArguments& arguments, const Invocation& call) {
  const std::filesystem::path dir = arguments.dir;
  const KeptCampaign kept = ReadKeptCampaign(dir, call.systems, call.secret_file);
  const std::vector<KnownSystem> known = KnownSystems(call.systems);
  const RunMaker maker(kept.campaign, known);
  const System& system = FindSystem(call.systems, kept.system);
  const std::uint64_t seed =
      arguments.seed ? *arguments.seed : SealedBits(NewSecret(), "audit", {});
  std::vector<Audited> all;
  // Of all that were planned: a row that somebody took away is missed, too.
  const bool decided =
      DecidedRuns(Folder(dir).Read(kAcceptanceFile, kMostTextBytes).value_or("")) > 0;
  const std::size_t planned =
      decided ? kept.runs.size() : static_cast<std::size_t>(maker.run_count());
  for (const std::size_t index : Sample(planned, arguments.sample, seed)) {
    const int run = maker.Number(static_cast<std::int64_t>(index));
    const std::size_t place = kept.runs.Find(run);
    all.push_back(place == kept.runs.size() ? Audited{run, false, "it has no row"}
                                            : AuditRun(kept.runs.results[place], dir, maker, kept,
                                                       system, arguments.commands));
  }
  const int sampled = static_cast<int>(all.size());
  for (Audited& line : AuditTable(dir, kept)) all.push_back(std::move(line));
  return Answer(all, sampled, arguments.json, call);
}

}  // namespace

void AddAuditCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<AuditArguments>();
  CLI::App* command = app.add_subcommand("audit", kAuditHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign")
      ->required()
      ->type_name("DIR");
  command->add_option("--sample", arguments->sample, "how many runs [10]")
      ->check(CLI::Range(1, 1000000000));
  command->add_option("--seed", arguments->seed, "of the choice of the runs [from the system]");
  AddCommandOptions(*command, arguments->commands);
  AddSecretOption(*command, call);
  command->add_flag("--json", arguments->json, "print what was found as JSON");
  command->callback([arguments, &call] { call.exit_code = Audit(*arguments, call); });
}

}  // namespace dockyard
