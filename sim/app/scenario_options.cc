#include "sim/app/scenario_options.h"

#include <charconv>

#include "sim/app/misplaced_file.h"
#include "sim/app/number_option.h"
#include "sim/report/points.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {

void AddSetOption(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "key.path=value, on top of the file")
      ->type_name("KEY=VALUE")
      ->check([](const std::string& text) {
        const std::size_t equals = text.find('=');
        const bool fine = equals != std::string::npos && equals > 0;
        return fine ? "" : "expected key=value such as start.r_m=5, found '" + text + "'";
      })
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void AddCommandOptions(CLI::App& command, CommandOptions& options) {
  command.add_flag("--allow-commands", options.allow,
                   "let a scenario start the program that it names as its controller");
  command
      .add_option("--answer-limit", options.answer_limit_s,
                  "wall time of one answer of such a program [10 s]")
      ->type_name("SECONDS")
      ->check(NumberWithin(0.001, 1e6));
  command.add_flag("--sandbox", options.sandbox,
                   "such a program reaches its own folder only, no network and no other process");
}

std::vector<std::string> OptionWords(const CommandOptions& options) {
  std::vector<std::string> words;
  if (options.allow) words.push_back("--allow-commands");
  if (options.answer_limit_s != CommandOptions{}.answer_limit_s) {
    words.insert(words.end(), {"--answer-limit", NumberText(options.answer_limit_s)});
  }
  if (options.sandbox) words.push_back("--sandbox");
  return words;
}

void AddSeedOption(CLI::App& command, std::optional<std::uint64_t>& seed) {
  command.add_option("--seed", seed, "of all random draws; overrides the file's")
      ->type_name("INTEGER")
      ->check([](const std::string& text) {  // else -1 and 2^64 would read as 2^64 - 1
        std::uint64_t number = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
        return whole ? "" : "expected a whole number from 0 to 2^64 - 1, found '" + text + "'";
      });
}

void AddScenarioOptions(CLI::App& command, ScenarioOptions& options) {
  command.add_option("SCENARIO", options.file, "a scenario file")->required()->type_name("FILE");
  AddSeedOption(command, options.seed);
  AddSetOption(command, options.overrides);
}

Scenario Load(const ScenarioOptions& options, const std::vector<System>& systems) {
  Scenario scenario = LoadAs(kWantedScenario, options.file, systems, [&] {
    return LoadScenario(options.file, options.overrides, KnownSystems(systems));
  });
  if (options.seed) scenario.seed = *options.seed;
  return scenario;
}

CampaignSystems CampaignSystemsOf(const std::vector<System>& systems) {
  const auto measures = [&systems](const std::string& name) {
    std::vector<std::string> names;
    for (const Column& column : SummedColumns(FindSystem(systems, name).Columns({}))) {
      names.push_back(column.name);
    }
    return names;
  };
  return {KnownSystems(systems), measures};
}

CampaignRun SingleRun(const Scenario& scenario) {
  CampaignRun run;
  run.scenario = scenario;
  run.run = 1;
  return run;
}

}  // namespace dockyard
