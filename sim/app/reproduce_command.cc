#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "models/read/near_names.h"
#include "sim/app/campaign_setup.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/report_content.h"
#include "sim/app/reproduction_files.h"
#include "sim/app/terminal.h"
#include "sim/base/count_text.h"
#include "sim/base/files.h"
#include "sim/base/shell_word.h"
#include "sim/base/text.h"
#include "sim/campaign/campaign.h"
#include "sim/plan/make_run.h"
#include "sim/report/reproduction_text.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

struct ReproduceArguments {
  std::string name, only, shard;
  CampaignArguments campaign;  // its file and folder are those of the experiment
  int replications = 0;        // 0: as the experiment's file says
  int jobs = 0;                // 0: all processors
  bool quiet = false, dry_run = false, json = false, report = false;
};

constexpr const char* kReproduceHelp =
    R"(Simulate a published experiment and hold its counts against the publication's.

Examples:
  dockyard reproduce
  dockyard reproduce {reproduction} --jobs 2 --report
  dockyard reproduce {reproduction} --replications 1 --dry-run | sed -n 1,3p >out/two.csv
  dockyard reproduce {reproduction} --only grid --replications 1 --set table=out/two.csv \
    --out out/two || echo "exit code $?"

Without NAME, all experiments are listed. Each run of the experiment is simulated --replications
times with fresh noise. Then its table stands beside the publication's, with the interval in which
the published count is to be expected. Exit code 0: the total lies in its interval of 95 %, and each
of the m rows that count in its own of 1 - 0.05/m, causes alike; 30: one lies outside; 10: runs are
missing, crashed or were stopped, or are not those of the experiment. --set sets keys of the first
campaign, or of the one of --only. Stopped, the same command goes on where it was.)";

const Reproduction& FindReproduction(const std::string& name, const std::vector<System>& systems) {
  std::vector<std::string> known;
  for (const System& system : systems) {
    for (const Reproduction& each : system.reproductions) {
      if (each.name == name) return each;
      known.push_back(each.name);
    }
  }
  throw UsageError("NAME: expected one of " + Listed(known) + ", found '" + name + "'" +
                   DidYouMean(name, known));
}

int List(const Invocation& call, bool as_json) {
  Json list = Json::array();
  for (const System& system : call.systems) {
    for (const Reproduction& each : system.reproductions) {
      list.push_back({{"name", each.name}, {"system", system.name}, {"meaning", each.meaning}});
      if (!as_json) std::printf("%s: %s\n", each.name.c_str(), each.meaning.c_str());
    }
  }
  if (as_json) {
    const Json answer{{"experiments", list}, {"warnings", call.warnings}};
    std::printf("%s\n", answer.dump().c_str());
  }
  return kExitDone;
}

/// Whether this command runs the campaign.
bool Chosen(const ReproduceArguments& arguments, const PublishedCampaign& campaign) {
  return arguments.only.empty() || arguments.only == campaign.name;
}

fs::path OutDir(const ReproduceArguments& arguments, const Published& published) {
  return arguments.campaign.out_dir.empty() ? fs::path("results") / published.name
                                            : fs::path(arguments.campaign.out_dir);
}

/// The arguments of one of the experiment's campaigns. --set and --replications belong to the
/// first, or to the one chosen.
CampaignArguments ArgumentsOf(const ReproduceArguments& arguments, const Published& published,
                              std::size_t place, const std::vector<System>& systems) {
  const PublishedCampaign& campaign = published.campaigns[place];
  CampaignArguments its = arguments.campaign;
  its.file = campaign.file;
  its.out_dir = (OutDir(arguments, published) / campaign.name).string();
  const bool meant = arguments.only.empty() ? place == 0 : arguments.only == campaign.name;
  if (!meant) its.overrides.clear();
  if (place > 0) return its;
  const bool told = arguments.replications > 0;
  const std::int64_t runs = std::int64_t{told ? arguments.replications : published.replications} *
                            RunsOfOne(campaign, systems);
  its.overrides.insert(told ? its.overrides.end() : its.overrides.begin(),
                       "design.runs=" + std::to_string(runs));
  return its;
}

std::vector<Campaign> LoadAll(const ReproduceArguments& arguments, const Published& published,
                              const std::vector<System>& systems) {
  std::vector<Campaign> campaigns;
  std::vector<CampaignNames> names;
  for (std::size_t i = 0; i < published.campaigns.size(); ++i) {
    campaigns.push_back(LoadCampaign(ArgumentsOf(arguments, published, i, systems), systems));
    names.push_back(NamesOf(campaigns.back(), systems));
  }
  CheckPublished(published, names);
  return campaigns;
}

void RequireChoice(const ReproduceArguments& arguments, const Published& published) {
  std::string names;
  for (const PublishedCampaign& campaign : published.campaigns) {
    if (Chosen(arguments, campaign)) return;
    names += (names.empty() ? "" : ", ") + campaign.name;
  }
  throw UsageError("--only: expected one of " + names + ", found '" + arguments.only + "'");
}

/// A folder of the experiment's, or an empty one.
void RequireFree(const fs::path& dir, const Published& published) {
  if (!fs::exists(dir) || fs::is_empty(dir) || fs::exists(dir / "reproduction.json")) return;
  for (const PublishedCampaign& campaign : published.campaigns) {
    if (HoldsCampaign(dir / campaign.name)) return;
  }
  throw FolderTaken(dir.string() + " holds something else; choose another folder with --out");
}

std::string CommandToGoOn(const ReproduceArguments& arguments, const std::string& program) {
  std::string command = CommandText(program, {"reproduce", arguments.name});
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) command += std::string(" ") + option + " " + ShellWord(value);
  };
  add("--out", arguments.campaign.out_dir);
  add("--only", arguments.only);
  for (const std::string& word : OptionWords(arguments.campaign)) command += " " + ShellWord(word);
  const auto number = [](int value) { return value > 0 ? std::to_string(value) : std::string(); };
  add("--replications", number(arguments.replications));
  add("--jobs", number(arguments.jobs));
  add("--shard", arguments.shard);
  return command + (arguments.report ? " --report" : "");
}

/// Returns how the shard ended; tables are made when it is the whole campaign.
ShardEnd RunPart(const ReproduceArguments& arguments, const CampaignArguments& part,
                 Campaign loaded, const Invocation& call) {
  auto [campaign, run, options] = MakeReady(std::move(loaded), part, call.systems);
  options.shard = ShardOption(arguments.shard);
  options.jobs = arguments.jobs > 0 ? arguments.jobs : UsableProcessors();
  options.progress = arguments.json    ? ProgressStyle::kJson
                     : arguments.quiet ? ProgressStyle::kNone
                                       : ProgressStyleOfStderr();
  PrintNote(campaign.name + ": " + CountText(campaign.run_count(), "run") + " into " +
            options.out_dir.string());
  ShardEnd end = RunShard(campaign, run, options);
  if (options.shard.whole()) {
    MergeShards(options.out_dir, campaign, options.columns);
    if (end.signal == 0 && arguments.report) {
      WriteReport(options.out_dir, options.out_dir / "report.html", call);
    }
  }
  return end;
}

std::string ChoicesText(const Published& published) {
  if (published.choices_file.empty()) return "";
  return "\nwhat the paper leaves open and what was chosen, " + published.choices_file + ":\n\n" +
         ReadWhole(published.choices_file).value_or("");
}

int Tell(const ReproduceArguments& arguments, const Published& published, const Invocation& call) {
  const fs::path dir = OutDir(arguments, published);
  const std::vector<CampaignResults> results = ReadReproduced(published, dir, call.systems);
  const ReproductionFinding found = JudgeReproduction(published, results);
  const std::vector<std::string> figures = WriteFigures(published, dir, call);
  Json json = ReproductionJson(found);
  json["figures"] = figures;
  json["choices"] = published.choices_file;
  std::string text = ReproductionText(found);
  for (const std::string& figure : figures) text += "figure " + figure + "\n";
  WriteWhole(dir / "reproduction.json", json.dump(1) + "\n");
  WriteWhole(dir / "reproduction.txt", text);
  if (arguments.json) {
    json["warnings"] = call.warnings;
    std::printf("%s\n", json.dump().c_str());
  } else {
    std::printf("%s%s", text.c_str(), ChoicesText(published).c_str());
  }
  PrintNote("results and figures in " + dir.string());
  const bool lost = std::any_of(results.begin(), results.end(), [](const CampaignResults& each) {
    return std::any_of(each.rows.begin(), each.rows.end(),
                       [](const RunResult& row) { return IsLost(row.outcome); });
  });
  if (lost || found.verdict == ReproductionVerdict::kNotJudged) return kExitIncomplete;
  return found.verdict == ReproductionVerdict::kInside ? kExitDone : kExitOutside;
}

int Reproduce(const ReproduceArguments& arguments, const Invocation& call) {
  const std::vector<System>& systems = call.systems;
  if (arguments.name.empty()) return List(call, arguments.json);
  const Reproduction& reproduction = FindReproduction(arguments.name, systems);
  const Published published = LoadPublished(reproduction.file);
  RequireChoice(arguments, published);
  const bool sharded = !arguments.shard.empty();
  if (sharded && arguments.report) {
    throw UsageError("--shard: expected no --report; the command without --shard makes it");
  }
  std::vector<Campaign> campaigns = LoadAll(arguments, published, systems);
  RequireFree(OutDir(arguments, published), published);
  bool complete = true;
  for (std::size_t i = 0; i < campaigns.size(); ++i) {
    if (!Chosen(arguments, published.campaigns[i])) continue;
    if (arguments.dry_run) {
      std::printf("%s", PlanCsv(campaigns[i], KnownSystems(systems)).c_str());
      return kExitDone;
    }
    const ShardEnd end = RunPart(arguments, ArgumentsOf(arguments, published, i, systems),
                                 std::move(campaigns[i]), call);
    if (end.signal != 0) {
      PrintNote("stopped; to go on: " + CommandToGoOn(arguments, call.program));
      return kExitSignal + end.signal;
    }
    complete = complete && end.complete() && end.tally.lost == 0;
  }
  if (!sharded) return Tell(arguments, published, call);
  PrintNote("shard " + arguments.shard + " is done; when all are: the command without --shard");
  return complete ? kExitDone : kExitIncomplete;
}

}  // namespace

void AddReproduceCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<ReproduceArguments>();
  CLI::App* command = app.add_subcommand("reproduce", kReproduceHelp);
  command->add_option("NAME", arguments->name, "the experiment; without it, all are listed");
  command
      ->add_option("--replications", arguments->replications,
                   "how often each run is simulated [as the experiment's file says]")
      ->check(CLI::Range(1, 10000));
  AddCampaignOptions(*command, arguments->campaign);
  command->add_option("--only", arguments->only,
                      "run this campaign of the experiment; results of the others stay");
  command->add_option("--jobs", arguments->jobs, "processes at once [all processors]")
      ->check(CLI::Range(1, 1024));
  command->add_option("--shard", arguments->shard, "K/N: every N-th run, from the K-th on");
  command->add_flag("--report", arguments->report,
                    "make a page of each campaign: report.html in its folder");
  command->add_flag("--json", arguments->json, "progress and result as JSON, a line each");
  command->add_flag("--quiet", arguments->quiet, "no progress on stderr");
  command->add_flag("--dry-run", arguments->dry_run,
                    "print the runs of the first campaign as CSV, and run none");
  command->callback([arguments, &call] { call.exit_code = Reproduce(*arguments, call); });
}

}  // namespace dockyard
