#include "sim/app/raposa/belt_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "models/raposa/load_ground.h"
#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "sim/app/raposa/number_check.h"
#include "sim/app/raposa/words.h"
#include "sim/base/json.h"
#include "sim/raposa/ground_trials.h"

namespace dockyard::raposa {
namespace {

const char* const kBeltHelp =
    R"(Drive one belt of a tracked robot over a ground at a set load, slip and side slip.

Examples:
  dockyard belt --robot models/raposa/raposa.yaml --ground models/raposa/grounds/grass.yaml \
    --slip 0.05,0.2,1
  dockyard belt --robot models/raposa/raposa.yaml --ground models/raposa/grounds/hard_floor.yaml \
    --turn-in-place --arm 0,19.5

A command of the system raposa, as `dockyard wheel` is for wheels. Slip is (u - v) / max(|u|, |v|),
u of the belt's surface, v of the travel; beta is the angle from the belt's plane to its travel, to
the right. Fx_N > 0 is drawbar, Fy_N the ground's force against the side slip, Fz_N the load that it
carries, torque_Nm what the motor must give the sprocket, sinkage_m that of the lower run; all are
means over whole pads. Lists make every combination.
With --turn-in-place the whole robot turns on its belts: gauge_m is the effective gauge, the belts'
difference of speeds over the turning rate; centre_m the x of the point that stays; current_A and
torque_Nm are of one side's motor.)";

struct BeltArguments {
  std::string robot, ground, pyramid = "models/raposa/pyramid/pyramid.yaml";
  std::vector<double> slips{0.0}, betas_deg{0.0}, loads_n, arms_deg{0.0};
  double speed_m_s = 0.05;
  bool turn = false, json = false;
};

void AddBeltOptions(CLI::App& app, BeltArguments& in) {
  const auto list = [&](const char* name, std::vector<double>& values, const char* what, double low,
                        double high) {
    return app.add_option(name, values, what)
        ->delimiter(',')
        ->check(NumberBetween(low, high))
        ->allow_extra_args(false);
  };
  app.add_option("--robot", in.robot, "a tracked robot's file")->required();
  app.add_option("--ground", in.ground, "a file of a ground for belts")->required();
  CLI::Option* turn = app.add_flag("--turn-in-place", in.turn, "the whole robot turns instead");
  list("--slip", in.slips, "slip, -1 to 1 [0]", -1.0, 1.0)->excludes(turn);
  list("--beta", in.betas_deg, "side slip in degrees, 0 to 90 [0]", 0.0, 90.0)->excludes(turn);
  list("--load", in.loads_n, "load in N [half of the robot's weight]", 0.1, 1e5)->excludes(turn);
  list("--arm", in.arms_deg, "the arm's angle, down, in degrees, -60 to 25 [0]", -60.0, 25.0)
      ->needs(turn);
  app.add_option("--speed", in.speed_m_s, "of the faster of belt and travel in m/s [0.05]")
      ->check(NumberBetween(1e-3, 1.0));
  app.add_option("--pyramid", in.pyramid, "a pyramid's file [models/raposa/pyramid/pyramid.yaml]")
      ->needs(turn);
  app.add_flag("--json", in.json, "JSON on standard output");
}

Json DriveRows(const BeltArguments& in, const RobotModel& robot, const GroundModel& ground) {
  Json rows = Json::array();
  const std::vector<double> loads =
      in.loads_n.empty() ? std::vector<double>{0.5 * 9.81 * robot.mass_kg()} : in.loads_n;
  for (const double load : loads) {
    for (const double beta : in.betas_deg) {
      for (const double slip : in.slips) {
        const BeltTrialResult r = TryBelt(robot, ground, {load, slip, Radians(beta), in.speed_m_s});
        rows.push_back({{"load_N", load},
                        {"beta_deg", beta},
                        {"slip", slip},
                        {"Fx_N", r.drawbar_n},
                        {"Fy_N", r.side_n},
                        {"Fz_N", r.carried_n},
                        {"torque_Nm", r.torque_nm},
                        {"sinkage_m", r.sinkage_m},
                        {"contact_m", r.contact_m}});
      }
    }
  }
  return rows;
}

Json TurnRows(const BeltArguments& in, const RobotModel& robot, const GroundModel& ground) {
  Json rows = Json::array();
  // The pyramid is out of reach.
  const WorldSetup base = OnLevelGround(robot, LoadPyramid(in.pyramid), ground, 2.5);
  for (const double arm : in.arms_deg) {
    const TurningResult r = TryTurning(base, Radians(arm), in.speed_m_s);
    rows.push_back({{"arm_deg", arm},
                    {"gauge_m", r.gauge_m},
                    {"centre_m", r.centre_m},
                    {"turn_deg_s", Degrees(r.turn_rad_s)},
                    {"current_A", r.current_a},
                    {"torque_Nm", r.torque_nm}});
  }
  return rows;
}

/// With a heading of the keys, in their order.
void PrintRows(const Json& rows, const std::vector<const char*>& keys) {
  for (const char* key : keys) std::printf("%11s", key);
  std::printf("\n");
  for (const Json& row : rows) {
    for (const char* key : keys) std::printf("%11.4g", row.at(key).get<double>());
    std::printf("\n");
  }
}

}  // namespace

std::vector<CommandOption> BeltOptions() {
  BeltArguments unread;
  CLI::App app;
  AddBeltOptions(app, unread);
  return OptionsOf(app);
}

int BeltOnGround(const std::string& program, const std::vector<std::string>& words) {
  BeltArguments in;
  CLI::App app(WithProgram(kBeltHelp, program), program + " belt");
  AddBeltOptions(app, in);
  if (const auto ended = ParseWords(app, words, program + " help belt")) return *ended;
  const RobotModel robot = LoadRobot(in.robot);
  const GroundModel ground = LoadGround(in.ground);
  const Json rows = in.turn ? TurnRows(in, robot, ground) : DriveRows(in, robot, ground);
  if (in.json) {
    std::printf("%s\n", Json{{"trials", rows}, {"warnings", Json::array()}}.dump(2).c_str());
  } else if (in.turn) {
    PrintRows(rows, {"arm_deg", "gauge_m", "centre_m", "turn_deg_s", "current_A", "torque_Nm"});
  } else {
    PrintRows(rows, {"load_N", "beta_deg", "slip", "Fx_N", "Fy_N", "Fz_N", "torque_Nm", "sinkage_m",
                     "contact_m"});
  }
  return 0;
}

}  // namespace dockyard::raposa
