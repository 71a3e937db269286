#include <memory>
#include <string>
#include <vector>

#include "sim/app/campaign_end.h"
#include "sim/app/commands.h"
#include "sim/app/judging.h"
#include "sim/app/kept_campaign.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/merge.h"
#include "sim/plan/make_run.h"

namespace dockyard {
namespace {

struct MergeArguments {
  std::string dir;
  std::vector<std::string> from;
  bool json = false;
  JudgingOptions judging;
};

constexpr const char* kMergeHelp = R"(Make tables, plots and a summary of the shards of a campaign.

Examples:
  dockyard campaign {campaign} --shard 1/2 --out out/yard
  dockyard campaign {campaign} --shard 2/2 --out out/yard
  dockyard merge out/yard
  dockyard merge out/all out/yard

Shards of other results folders of the same campaign are copied in first, with the logs of their
runs. Exit code 10: runs are missing, crashed or were stopped; 22: a requirement is not met.)";

int Merge(const MergeArguments& arguments, const Invocation& call) {
  for (const std::string& from : arguments.from) TakeShards(from, arguments.dir);
  const KeptCampaign kept = OpenKeptCampaign(arguments.dir, call.systems);
  const std::vector<Requirement> requirements =
      ReadRequirements(arguments.judging, kept.columns, kept.campaign);
  const CampaignEnd end = MergeShards(arguments.dir, kept.campaign, kept.columns);
  const int code = ReportEnd(end, arguments.dir, arguments.json, call);
  return JudgeResults(arguments.judging, requirements, end, kept.campaign, kept.columns,
                      arguments.dir, arguments.json, code, call);
}

}  // namespace

void AddMergeCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = app.add_subcommand("merge", kMergeHelp);
  command->add_option("DIR", arguments->dir, "results folder of the campaign")
      ->required()
      ->type_name("DIR");
  command->add_option("FROM", arguments->from, "results folders whose shards are copied in")
      ->type_name("DIR");
  command->add_flag("--json", arguments->json, "the result as a line of JSON");
  AddJudgingOptions(*command, arguments->judging);
  command->callback([arguments, &call] { call.exit_code = Merge(*arguments, call); });
}

}  // namespace dockyard
