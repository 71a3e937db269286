#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "models/read/load_soil.h"
#include "models/read/load_wheel.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/number_option.h"
#include "sim/app/terminal.h"
#include "sim/app/wheel_premises.h"
#include "sim/app/wheel_sweep.h"
#include "sim/base/files.h"
#include "sim/soil/wheel_data.h"

namespace dockyard {
namespace {

struct WheelArguments {
  std::string wheel_file, soil_file, out_dir, data_file, data_wheel;
  std::vector<double> slips{0.0}, betas_deg{0.0}, loads_n;
  double speed_m_s = 0.01;
  bool sweep = false, json = false;
};

constexpr const char* kWheelHelp =
    R"(Drive one wheel over soil at a set load, slip and side slip, to steady state.

Examples:
  dockyard wheel --wheel models/wheels/pavlov_grouser.yaml --soil models/soils/pavlov_90.yaml \
    --slip 0.2 --beta 0 --load 24
  dockyard wheel --wheel models/wheels/pavlov_smooth.yaml --soil models/soils/loose_sand.yaml \
    --slip 0.2 --beta 15 --load 200 --json
  dockyard wheel --sweep --wheel models/wheels/pavlov_grouser.yaml \
    --soil models/soils/pavlov_90.yaml --slip -0.5,0.2,0.5 --beta 0,15 --load 24 --out out/wheel \
    --data tests/soil/data/single_wheel.csv --data-wheel grouser

Slip is (w r - v) / max(|w r|, |v|), r the rim's radius, v the speed of travel; beta is the angle
from the wheel's plane to its travel, to the right. Fx_N > 0 is drawbar, Fy_N the soil's force
against the side slip, Fz_N the load that it carries, torque_Nm what a motor must give, sinkage_m
that of the paddles' tips; all are means over whole paddle pitches. With --sweep the options --slip,
--beta and --load take lists; --out gets sweep.csv, drawbar.svg and sinkage.svg. --data draws
measured rows over the curves of their side slip: a CSV table with the columns slip, Fx_N, Fz_N and,
where measured, beta_deg, sinkage_mm and torque_Nm; if it holds several wheels, wheel.
A row has a warning where the soil's laws were never compared with a measured wheel: sinkage beyond
0.64 of the radius, slip beyond 0.8, side slip beyond 45 deg. It also has one where the wheel was
still changing at the end of its path. In sweep.csv, warnings counts them.
Exit code 10: a wheel was still changing at the end of its path, or its axle is below the ground;
its row says steady 0.)";

SingleWheelSetup MakeSetup(const WheelArguments& arguments) {
  SingleWheelSetup setup;
  setup.wheel = LoadWheel(arguments.wheel_file).wheel;
  setup.soil = LoadSoil(arguments.soil_file);
  CheckCarries(setup.soil, arguments.soil_file, setup.wheel.width_m);
  setup.speed_m_s = arguments.speed_m_s;
  return setup;
}

WheelRow RowOf(SingleWheelSetup setup, double load_n, double beta_deg, double slip) {
  setup.load_n = load_n;
  setup.side_slip_rad = Radians(beta_deg);
  setup.slip = slip;
  WheelRow row{load_n, beta_deg, slip, RunSingleWheel(setup)};
  row.buried = IsBuried(setup.wheel, row.result);
  row.warnings = BrokenPremises(setup, row.result);
  return row;
}

// After the rows, so that a table on the terminal stays whole.
void PrintWarnings(const std::vector<WheelRow>& table, std::vector<std::string>* warnings) {
  for (const WheelRow& row : table) {
    char place[96];
    std::snprintf(place, sizeof place, "load %g N, side slip %g deg, slip %g: ", row.load_n,
                  row.beta_deg, row.slip);
    for (const std::string& warning : row.warnings) {
      Warn((table.size() > 1 ? place : "") + warning, warnings);
    }
  }
}

int Drive(const WheelArguments& arguments, Invocation& call) {
  const std::size_t rows =
      arguments.slips.size() * arguments.betas_deg.size() * arguments.loads_n.size();
  if (!arguments.sweep && rows > 1) {
    throw UsageError("several values of --slip, --beta or --load need --sweep");
  }
  if (!arguments.sweep && !arguments.out_dir.empty()) throw UsageError("--out needs --sweep");
  if (!arguments.data_file.empty() && arguments.out_dir.empty()) {
    throw UsageError("--data needs --sweep and --out");
  }
  const SingleWheelSetup setup = MakeSetup(arguments);
  std::vector<MeasuredRow> measured;
  if (!arguments.data_file.empty()) {
    measured = LoadMeasuredRows(arguments.data_file, arguments.data_wheel);
  }
  if (!arguments.out_dir.empty()) MakeFolder(arguments.out_dir);
  std::vector<WheelRow> table;
  bool all_hold = true;
  for (const double load : arguments.loads_n) {
    for (const double beta : arguments.betas_deg) {
      for (const double slip : arguments.slips) {
        table.push_back(RowOf(setup, load, beta, slip));
        all_hold = all_hold && table.back().holds();
        if (arguments.sweep && !arguments.json) PrintWheelRow(table.back(), table.size() == 1);
      }
    }
  }
  if (arguments.json) {
    std::printf("%s\n", WheelJson(table, arguments.sweep).c_str());
  } else if (!arguments.sweep) {
    PrintWheelResult(table.front());
  }
  if (!arguments.out_dir.empty()) WriteWheelSweep(table, measured, arguments.out_dir);
  PrintWarnings(table, &call.warnings);
  return all_hold ? kExitDone : kExitIncomplete;
}

}  // namespace

void AddWheelCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<WheelArguments>();
  CLI::App* command = app.add_subcommand("wheel", kWheelHelp);
  command->add_option("--wheel", arguments->wheel_file, "a wheel file")->required();
  command->add_option("--soil", arguments->soil_file, "a soil file")->required();
  command->add_option("--slip", arguments->slips, "slip, -1 to 1 [0]")
      ->delimiter(',')
      ->check(NumberWithin(-1.0, 1.0))
      ->allow_extra_args(false);
  command->add_option("--beta", arguments->betas_deg, "side slip in degrees, 0 to 90 [0]")
      ->delimiter(',')
      ->check(NumberWithin(0.0, 90.0))
      ->allow_extra_args(false);
  command->add_option("--load", arguments->loads_n, "load in N")
      ->delimiter(',')
      ->check(NumberWithin(0.1, 1e5))
      ->allow_extra_args(false)
      ->required();
  command->add_option("--speed", arguments->speed_m_s, "speed of travel in m/s [0.01]")
      ->check(NumberWithin(1e-4, 2.0));
  command->add_flag("--sweep", arguments->sweep, "every combination of the lists");
  command->add_option("--out", arguments->out_dir, "folder for the sweep's table and plots");
  CLI::Option* data = command->add_option("--data", arguments->data_file,
                                          "a table of measured rows, drawn over the sweep's plots");
  command->add_option("--data-wheel", arguments->data_wheel, "only the data's rows of this wheel")
      ->needs(data);
  command->add_flag("--json", arguments->json, "the result as JSON");
  command->callback([arguments, &call] { call.exit_code = Drive(*arguments, call); });
}

}  // namespace dockyard
