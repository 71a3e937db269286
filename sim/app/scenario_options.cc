#include "sim/app/scenario_options.h"

#include <filesystem>

#include "models/load_scenario.h"

namespace dockyard {

void AddSetOption(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "key.path=value, on top of the file")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void AddScenarioOptions(CLI::App& command, ScenarioOptions& options) {
  command.add_option("SCENARIO", options.file, "a scenario file")->required();
  command.add_option("--seed", options.seed, "of all that is random; overrides the file's")
      ->check([](const std::string& text) {  // else -1 would read as 2^64 - 1
        return text.empty() || text[0] == '-' ? "expected a whole number >= 0" : "";
      });
  AddSetOption(command, options.overrides);
}

Scenario Load(const ScenarioOptions& options) {
  Scenario scenario = LoadScenario(options.file, options.overrides);
  if (options.seed) scenario.seed = *options.seed;
  return scenario;
}

CampaignRun SingleRun(const Scenario& scenario) {
  CampaignRun run;
  run.scenario = scenario;
  run.run = 1;
  run.region = "single";
  run.soil = std::filesystem::path(scenario.soil_file).stem().string();
  return run;
}

}  // namespace dockyard
