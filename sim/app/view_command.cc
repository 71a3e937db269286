#include <memory>
#include <string>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"

namespace dockyard {
namespace {

struct ViewArguments {
  ScenarioOptions scenario;
  std::string out_dir;
  bool colour = false;
};

constexpr const char* kHelp = R"(Render the stereo pair at a scenario's start pose.

Examples:
  dockyard view {scenario} --out out/view
  dockyard view {scenario} --set start.r_m=2 --set light=hard_shadow --out out/near
  dockyard view {scenario} --colour --set sun.temperature_k=4500 --out out/warm

Writes left.png, right.png and view.json: the board's true pose and, for each fiducial and camera,
its projected centre, the centroid of the projected disc and the share that is hidden. With --colour
(or camera.colour in the scenario) also left_colour.png and right_colour.png, linear red, green and
blue of the same views; with sensor.bits above 8 left_deep.png and right_deep.png of 16 bits.)";

int View(const ViewArguments& arguments, const std::vector<System>& systems) {
  Scenario scenario = Load(arguments.scenario, systems);
  const System& system = FindSystem(systems, scenario.system);
  if (!system.view) throw UsageError("the system " + system.name + " has no cameras to view with");
  scenario.colour = scenario.colour || arguments.colour;
  MakeFolder(arguments.out_dir);
  system.view(scenario, arguments.out_dir);
  PrintNote("left.png, right.png and view.json in " + arguments.out_dir);
  return kExitDone;
}

}  // namespace

void AddViewCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand("view", kHelp);
  AddScenarioOptions(*command, arguments->scenario);
  command->add_option("--out", arguments->out_dir, "folder for the images")->required();
  command->add_flag("--colour", arguments->colour, "write colour images beside the grey ones");
  command->callback([arguments, &systems, &exit_code] { exit_code = View(*arguments, systems); });
}

}  // namespace dockyard
