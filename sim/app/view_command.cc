#include <memory>
#include <string>
#include <vector>

#include "models/load_scenario.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/terminal.h"
#include "sim/log/files.h"
#include "sim/run/view_start.h"

namespace dockyard {
namespace {

struct ViewArguments {
  std::string scenario_file;
  std::vector<std::string> overrides;
  std::string out_dir;
};

constexpr const char* kHelp = R"(Render the stereo pair at a scenario's start pose.

Examples:
  dockyard view scenarios/axel_typical.yaml --out out/view
  dockyard view scenarios/axel_typical.yaml --set start.r_m=2 --set light=hard_shadow --out out/near

Writes left.png, right.png and view.json: the board's true pose and, for each fiducial and camera,
its projected centre, the centroid of the projected disc and the share that is hidden.)";

int View(const ViewArguments& arguments) {
  const Scenario scenario = LoadScenario(arguments.scenario_file, arguments.overrides);
  MakeFolder(arguments.out_dir);
  WriteStartView(scenario, arguments.out_dir);
  PrintNote("left.png, right.png and view.json in " + arguments.out_dir);
  return kExitDone;
}

}  // namespace

void AddViewCommand(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand("view", kHelp);
  command->add_option("SCENARIO", arguments->scenario_file, "a scenario file")->required();
  command->add_option("--set", arguments->overrides, "key.path=value, on top of the file")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--out", arguments->out_dir, "folder for the pictures")->required();
  command->callback([arguments, &exit_code] { exit_code = View(*arguments); });
}

}  // namespace dockyard
