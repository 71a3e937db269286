#include "sim/app/campaign_setup.h"

#include <utility>

#include "sim/app/commands.h"
#include "sim/app/identity.h"
#include "sim/app/kept_campaign.h"
#include "sim/app/kept_run.h"
#include "sim/app/misplaced_file.h"
#include "sim/app/number_option.h"
#include "sim/log/result_row.h"
#include "sim/plan/file_keys.h"
#include "sim/plan/make_run.h"
#include "sim/run/loop.h"

namespace dockyard {
namespace {

/// Returns the first run.
CampaignRun CheckAll(const Campaign& campaign, const RunOptions& options,
                     const std::vector<System>& systems) {
  const std::vector<KnownSystem> known = KnownSystems(systems);
  CheckRuns(campaign, known, [&](const Scenario& scenario) {
    RequireAllowed(scenario, options);
    FindSystem(systems, scenario.system).check(scenario);
  });
  return RunMaker(campaign, known).Make(0);
}

std::string OutDir(const CampaignArguments& arguments, const Campaign& campaign) {
  return arguments.out_dir.empty() ? "results/" + campaign.name : arguments.out_dir;
}

CampaignOptions OptionsFor(const CampaignArguments& arguments, const Campaign& campaign,
                           const System& system, const std::vector<System>& systems) {
  CampaignOptions options;
  options.systems = KnownSystems(systems);
  options.out_dir = OutDir(arguments, campaign);
  options.retry_lost = arguments.retry_lost;
  options.identity = IdentityOf(campaign, options.systems);
  options.columns = system.Columns(campaign.labels);
  options.facts = {{"name", campaign.name},
                   {"system", system.name},
                   {"seed", campaign.seed.number},
                   {"runs", campaign.run_count()},
                   {"columns", ColumnNames(options.columns)}};
  if (arguments.commands.answer_limit_s != CommandOptions{}.answer_limit_s) {
    options.facts[kAnswerLimitFact] = arguments.commands.answer_limit_s;
  }
  if (arguments.commands.sandbox) options.facts[kSandboxFact] = true;
  options.environment = EnvironmentJson();
  return options;
}

}  // namespace

void AddCampaignOptions(CLI::App& command, CampaignArguments& arguments) {
  command.add_option("--out", arguments.out_dir, "results folder [results/<name>]")
      ->type_name("DIR");
  AddSeedOption(command, arguments.seed);
  command
      .add_option("--sealed", arguments.secret_file,
                  "seal the runs' worlds by the secret in this file, which is made if missing")
      ->type_name("SECRET_FILE");
  AddSetOption(command, arguments.overrides);
  AddCommandOptions(command, arguments.commands);
  command.add_flag("--retry-crashed", arguments.retry_lost,
                   "simulate runs again that crashed or were stopped");
  command
      .add_option("--run-limit", arguments.run_limit_s,
                  "wall time of one run [as the campaign's limits say, else 900 s]")
      ->type_name("SECONDS")
      ->check(NumberWithin(0.001, 1e6));
}

std::vector<std::string> OptionWords(const CampaignArguments& arguments) {
  std::vector<std::string> words;
  if (arguments.seed) words.insert(words.end(), {"--seed", std::to_string(*arguments.seed)});
  if (!arguments.secret_file.empty()) {
    words.insert(words.end(), {"--sealed", arguments.secret_file});
  }
  for (const std::string& override : arguments.overrides) {
    words.insert(words.end(), {"--set", override});
  }
  const std::vector<std::string> of_commands = OptionWords(arguments.commands);
  words.insert(words.end(), of_commands.begin(), of_commands.end());
  if (arguments.retry_lost) words.push_back("--retry-crashed");
  if (arguments.run_limit_s > 0.0) {
    words.insert(words.end(), {"--run-limit", NumberText(arguments.run_limit_s)});
  }
  return words;
}

Shard ShardOption(const std::string& text) {
  if (text.empty()) return {};
  const auto shard = ShardFromText(text);
  if (shard) return *shard;
  throw UsageError("--shard: expected K/N with K from 1 to N, found '" + text + "'");
}

Campaign LoadCampaign(const CampaignArguments& arguments, const std::vector<System>& systems) {
  std::vector<std::string> overrides = arguments.overrides;
  if (arguments.seed) overrides.push_back("seed=" + std::to_string(*arguments.seed));
  Campaign campaign = LoadAs(kWantedCampaign, arguments.file, systems, [&] {
    return LoadCampaign(arguments.file, overrides, CampaignSystemsOf(systems));
  });
  if (arguments.run_limit_s > 0.0) campaign.limits.wall_s = arguments.run_limit_s;
  if (!arguments.secret_file.empty()) {
    campaign.Seal(SecretIn(arguments.secret_file, /*make=*/true));
  }
  return campaign;
}

ReadyCampaign MakeReady(Campaign campaign, const CampaignArguments& arguments,
                        const std::vector<System>& systems) {
  RunOptions of_run{
      .log_dir = {}, .labels = campaign.labels, .results_dir = OutDir(arguments, campaign)};
  arguments.commands.Fill(of_run);
  const System& system = FindSystem(systems, CheckAll(campaign, of_run, systems).scenario.system);
  ReadyCampaign ready;
  ready.campaign = WithAbsolutePaths(std::move(campaign), KnownSystems(systems));
  ready.options = OptionsFor(arguments, ready.campaign, system, systems);
  // Runs read the copies: somebody may edit a model while the campaign runs.
  ready.campaign = OnCopies(ready.campaign, ready.options.systems, ready.options.identity,
                            ready.options.out_dir);
  ready.run = [&system, of_run](const CampaignRun& what, const RunLogging& logging) {
    RunOptions logged = of_run;
    logged.log_dir = logging.dir;
    logged.log_images = logging.images;
    logged.log_commands_alone = logging.commands_alone;
    logged.recorded_dir = logging.recorded;
    return Simulate(system, what, logged);
  };
  return ready;
}

}  // namespace dockyard
