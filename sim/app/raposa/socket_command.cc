#include "sim/app/raposa/socket_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "models/raposa/load_ground.h"
#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "sim/app/raposa/number_check.h"
#include "sim/app/raposa/words.h"
#include "sim/base/json.h"
#include "sim/raposa/socket_trial.h"

namespace dockyard::raposa {
namespace {

const char* const kSocketHelp =
    R"(Drive RAPOSA straight onto its guide and say whether the socket lets it in.

Examples:
  dockyard socket --robot models/raposa/raposa.yaml --pyramid models/raposa/pyramid/pyramid.yaml \
    --ground models/raposa/grounds/hard_floor.yaml --arm 8 --high 0,4,6 --short 2
  dockyard socket --robot models/raposa/raposa.yaml --pyramid models/raposa/pyramid/pyramid.yaml \
    --ground models/raposa/grounds/hard_floor.yaml --aside=-10,0,10 --turned 6 --json

A command of the system raposa, without controller and camera. The options take lists; each
combination is a trial: the arm is pressed down, the robot drives the last 0.12 m, stops so far
before the guide's seat, and closes its doors. pushed_mm is how far the pyramid moved until they
begin to close, before_mm the guide's place then, in the robot's x: negative is outside of its seat.
seat_mm is the guide's distance from the seat at the end; held means less than 3 mm.)";

struct SocketArguments {
  std::string robot, pyramid, ground;
  std::vector<double> arms_deg{8.0}, highs_mm{0.0}, asides_mm{0.0}, turned_deg{0.0}, shorts_mm{3.0};
  double speed_m_s = 0.09;
  bool json = false;
};

void AddSocketOptions(CLI::App& app, SocketArguments& in) {
  const auto list = [&](const char* name, std::vector<double>& values, const char* what, double low,
                        double high) {
    app.add_option(name, values, what)
        ->delimiter(',')
        ->check(NumberBetween(low, high))
        ->allow_extra_args(false);
  };
  app.add_option("--robot", in.robot, "a tracked robot's file")->required();
  app.add_option("--pyramid", in.pyramid, "a pyramid's file")->required();
  app.add_option("--ground", in.ground, "a file of a ground for belts")->required();
  list("--arm", in.arms_deg, "the arm's angle, down, in degrees, 0 to 25 [8]", 0.0, 25.0);
  list("--high", in.highs_mm, "the guide above its file's height, in mm, -30 to 30 [0]", -30.0,
       30.0);
  list("--aside", in.asides_mm, "the robot's path left of the guide's axis, in mm, -60 to 60 [0]",
       -60.0, 60.0);
  list("--turned", in.turned_deg, "the path off the axis, in degrees, -30 to 30 [0]", -30.0, 30.0);
  list("--short", in.shorts_mm, "it stops before the seat, in mm, -20 to 60 [3]", -20.0, 60.0);
  app.add_option("--speed", in.speed_m_s, "in m/s, 0.01 to 0.3 [0.09]")
      ->check(NumberBetween(0.01, 0.3));
  app.add_flag("--json", in.json, "JSON on standard output");
}

Json JsonOf(const SocketTrial& trial, const SocketResult& result) {
  return {{"arm_deg", Degrees(trial.arm_rad)},  {"high_mm", 1e3 * trial.high_m},
          {"aside_mm", 1e3 * trial.aside_m},    {"turned_deg", Degrees(trial.turned_rad)},
          {"short_mm", 1e3 * trial.short_m},    {"held", result.held},
          {"pushed_mm", 1e3 * result.pushed_m}, {"before_mm", 1e3 * result.before_m},
          {"seat_mm", 1e3 * result.seat_m},     {"peak_n", result.peak_n}};
}

void PrintTrial(const SocketTrial& trial, const SocketResult& result) {
  std::printf("%7.1f %7.1f %8.1f %10.1f %8.1f  %-4s %9.1f %9.1f %7.1f %6.0f\n",
              Degrees(trial.arm_rad), 1e3 * trial.high_m, 1e3 * trial.aside_m,
              Degrees(trial.turned_rad), 1e3 * trial.short_m, result.held ? "yes" : "no",
              1e3 * result.pushed_m, 1e3 * result.before_m, 1e3 * result.seat_m, result.peak_n);
}

std::vector<SocketTrial> TrialsOf(const SocketArguments& in) {
  std::vector<SocketTrial> trials;
  for (const double arm : in.arms_deg) {
    for (const double high : in.highs_mm) {
      for (const double aside : in.asides_mm) {
        for (const double turned : in.turned_deg) {
          for (const double shorts : in.shorts_mm) {
            trials.push_back({.arm_rad = Radians(arm),
                              .high_m = 1e-3 * high,
                              .aside_m = 1e-3 * aside,
                              .turned_rad = Radians(turned),
                              .short_m = 1e-3 * shorts,
                              .speed_m_s = in.speed_m_s});
          }
        }
      }
    }
  }
  return trials;
}

}  // namespace

std::vector<CommandOption> SocketOptions() {
  SocketArguments unread;
  CLI::App app;
  AddSocketOptions(app, unread);
  return OptionsOf(app);
}

int Socket(const std::string& program, const std::vector<std::string>& words) {
  SocketArguments in;
  CLI::App app(WithProgram(kSocketHelp, program), program + " socket");
  AddSocketOptions(app, in);
  if (const auto ended = ParseWords(app, words, program + " help socket")) return *ended;
  const WorldSetup base =
      OnLevelGround(LoadRobot(in.robot), LoadPyramid(in.pyramid), LoadGround(in.ground), 0.5);
  Json rows = Json::array();
  if (!in.json) {
    std::printf(
        "arm_deg high_mm aside_mm turned_deg short_mm  held pushed_mm before_mm seat_mm "
        "peak_n\n");
  }
  for (const SocketTrial& trial : TrialsOf(in)) {
    const SocketResult result = TrySocket(base, trial);
    if (in.json) {
      rows.push_back(JsonOf(trial, result));
    } else {
      PrintTrial(trial, result);
      std::fflush(stdout);
    }
  }
  if (in.json) {
    std::printf("%s\n", Json{{"trials", rows}, {"warnings", Json::array()}}.dump(2).c_str());
  }
  return 0;
}

}  // namespace dockyard::raposa
