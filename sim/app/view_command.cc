#include <memory>
#include <string>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/log/files.h"
#include "sim/run/view_start.h"

namespace dockyard {
namespace {

struct ViewArguments {
  ScenarioOptions scenario;
  std::string out_dir;
};

constexpr const char* kHelp = R"(Render the stereo pair at a scenario's start pose.

Examples:
  dockyard view scenarios/axel_typical.yaml --out out/view
  dockyard view scenarios/axel_typical.yaml --set start.r_m=2 --set light=hard_shadow --out out/near

Writes left.png, right.png and view.json: the board's true pose and, for each fiducial and camera,
its projected centre, the centroid of the projected disc and the share that is hidden.)";

int View(const ViewArguments& arguments) {
  const Scenario scenario = Load(arguments.scenario);
  MakeFolder(arguments.out_dir);
  WriteStartView(scenario, arguments.out_dir);
  PrintNote("left.png, right.png and view.json in " + arguments.out_dir);
  return kExitDone;
}

}  // namespace

void AddViewCommand(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand("view", kHelp);
  AddScenarioOptions(*command, arguments->scenario);
  command->add_option("--out", arguments->out_dir, "folder for the pictures")->required();
  command->callback([arguments, &exit_code] { exit_code = View(*arguments); });
}

}  // namespace dockyard
