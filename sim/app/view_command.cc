#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/film_files.h"
#include "sim/app/number_option.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/base/json.h"

namespace dockyard {
namespace {

struct ViewArguments {
  ScenarioOptions scenario;
  std::string out_dir;
  bool colour = false, outside = false, json = false;
  double time_s = 0.0;  // of the view from outside
  OutsideArguments camera;
  CommandOptions commands;
};

constexpr const char* kViewHelp = R"(Render the stereo pair at a scenario's start pose.

Examples:
  dockyard view {scenario} --out out/view
  dockyard view {scenario} --set start.r_m=2 --set light=hard_shadow --out out/near
  dockyard view {scenario} --colour --set sun.temperature_k=4500 --out out/warm
  dockyard view {scenario} --outside --time 20 --out out/outside
  dockyard view {scenario} --outside --at target --out out/target

Of Axel it writes left.png, right.png and view.json: the board's true pose and, for each fiducial
and camera, its projected centre, the centroid of the projected disc and the share that is hidden.
With --colour (or camera.colour in the scenario) also left_colour.png and right_colour.png, linear
red, green and blue of the same views; with sensor.bits above 8 left_deep.png and right_deep.png of
16 bits.

--outside writes outside.png instead: the world as a spectator sees it, at the start or, with
--time, as the run has made it by then. --at names the point that it shows from near.)";

void PrintAnswer(Json answer, const std::vector<std::string>& warnings) {
  answer["warnings"] = warnings;
  std::printf("%s\n", answer.dump(1).c_str());
}

int ViewOutside(const ViewArguments& arguments, Scenario scenario, Invocation& call) {
  const System& system = FindSystem(call.systems, scenario.system);
  const StageShapes shapes = ShapesToDraw(system, scenario);
  const OutsideOptions options = arguments.camera.options(shapes);
  // The run need not go on beyond the picture; its first sample is at its beginning.
  constexpr double kSample_s = 0.1;
  scenario.time_limit_s = std::min(scenario.time_limit_s, arguments.time_s + kSample_s);
  scenario.log_images = false;
  RunOptions run;
  arguments.commands.Fill(run);
  const LoggedRun log = LogAnew(system, SingleRun(scenario), std::move(run));
  MakeFolder(arguments.out_dir);
  const std::filesystem::path file = std::filesystem::path(arguments.out_dir) / "outside.png";
  const double shown_s = WriteOutside(log, shapes, options, arguments.time_s, file);
  PrintNote("the world at " + Fixed(shown_s, 1) + " s in " + file.string());
  if (shown_s < arguments.time_s - kSample_s) {
    Warn("the run ended before --time", &call.warnings);
  }
  if (arguments.json) PrintAnswer({{"file", file.string()}, {"time_s", shown_s}}, call.warnings);
  return kExitDone;
}

/// Of a view through the robot's own cameras: else they would be left out in silence.
void RefuseOutsideOptions(const ViewArguments& arguments) {
  if (arguments.time_s > 0.0) throw UsageError("--time is of --outside alone");
  if (!arguments.camera.at.empty()) throw UsageError("--at is of --outside alone");
  if (!arguments.camera.from_D.empty()) throw UsageError("--from is of --outside alone");
}

int View(const ViewArguments& arguments, Invocation& call) {
  Scenario scenario = Load(arguments.scenario, call.systems);
  const System& system = FindSystem(call.systems, scenario.system);
  if (arguments.outside) return ViewOutside(arguments, std::move(scenario), call);
  RefuseOutsideOptions(arguments);
  if (!system.view) throw UsageError("the system " + system.name + " has no cameras to view with");
  scenario.colour = scenario.colour || arguments.colour;
  MakeFolder(arguments.out_dir);
  system.view(scenario, arguments.out_dir);
  PrintNote("the images and what is true of them are in " + arguments.out_dir);
  if (arguments.json) PrintAnswer({{"folder", arguments.out_dir}}, call.warnings);
  return kExitDone;
}

}  // namespace

void AddViewCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand("view", kViewHelp);
  AddScenarioOptions(*command, arguments->scenario);
  command->add_option("--out", arguments->out_dir, "folder for the images")
      ->required()
      ->type_name("DIR");
  command->add_flag("--colour", arguments->colour, "write colour images beside the grey ones");
  command->add_flag("--outside", arguments->outside, "the world as a spectator sees it");
  command->add_option("--time", arguments->time_s, "of --outside, since the start [0 s]")
      ->type_name("SECONDS")
      ->check(NumberWithin(0.0, 86400.0));
  command->add_flag("--json", arguments->json, "print what was written as JSON");
  AddOutsideOptions(*command, arguments->camera);
  AddCommandOptions(*command, arguments->commands);
  command->callback([arguments, &call] { call.exit_code = View(*arguments, call); });
}

}  // namespace dockyard
