#include "bench/physics_speed.h"

#include <algorithm>
#include <ctime>
#include <functional>

#include "axel/sim/scenarios.h"
#include "axel/twin/mujoco_twin.h"
#include "sim/axel/build_run.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

using MotorCommands = std::array<MotorCommand, kMotorCount>;

WorldSetup Setup(const std::string& soil, const std::vector<std::string>& more) {
  std::vector<std::string> changes = {"soil=" + SourceFile("models/soils/" + soil)};
  changes.insert(changes.end(), more.begin(), more.end());
  return Build(TypicalScenario(changes)).world;
}

MotorCommand Run(double rad_s, double current_a) {
  return {.mode = MotorMode::kVelocity,
          .target = rad_s,
          .accel_rad_s2 = 2.0,
          .current_limit_a = current_a};
}

MotorCommands Drive() {
  MotorCommands commands{};
  commands[0] = commands[1] = Run(0.17, 2.8);  // 0.05 m/s
  commands[3] = Run(1.2, 0.5);
  return commands;
}

WorldSetup ConeSetup(const std::string& soil) {
  return Setup(soil, {"start.r_m=1.3", "start.alpha_deg=8", "start.heading_deg=8"});
}

// The spool draws the arm into the cone; of twenty steps each, those are counted before and after
// which it is pressed.
double PressedStepsPerSecond(const std::function<bool()>& pressed,
                             const std::function<void(const MotorCommands&)>& step) {
  MotorCommands commands{};
  commands[0] = commands[1] = MotorCommand{.mode = MotorMode::kFree};
  commands[3] = Run(1.2, 2.0);
  constexpr int kChunk = 20, kChunks = 600;
  int counted = 0;
  double seconds = 0.0;
  for (int i = 0; i < kChunks; ++i) {
    const bool before = pressed();
    const double start = CpuSeconds();
    for (int j = 0; j < kChunk; ++j) step(commands);
    const double took = CpuSeconds() - start;
    if (!before || !pressed()) continue;
    counted += kChunk;
    seconds += took;
  }
  return counted > 0 ? counted / seconds : 0.0;
}

}  // namespace

double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

WorldSetup DrivingSetup(const std::string& soil) { return Setup(soil, {}); }

double DrivingStepsPerSecond(const WorldSetup& setup) {
  World world(setup);
  constexpr int kSteps = 20000;
  const double start = CpuSeconds();
  for (int i = 0; i < kSteps; ++i) world.Step(Drive());
  return kSteps / (CpuSeconds() - start);
}

double ConeStepsPerSecond(const std::string& soil) {
  World world(ConeSetup(soil));
  return PressedStepsPerSecond([&] { return world.truth().cone_force_n > 0.0; },
                               [&](const MotorCommands& commands) { world.Step(commands); });
}

namespace {

constexpr double kTwinFriction = 0.5;  // of the wheels on the ground, of the arm on the cone

void PutAtStart(const WorldSetup& setup, MujocoTwin& twin) {
  const Pose2 X_GR = setup.X_GD * setup.X_DR_start;
  const double ground_m = setup.ground.Height(X_GR.x, X_GR.y);
  twin.SetPose(FromGround(X_GR, std::max(ground_m, 0.0) + setup.rover.left_wheel_soil.rim_radius_m),
               0.0);
  twin.PowerOn(setup.slack_start_m);
}

}  // namespace

double TwinStepsPerSecond(const WorldSetup& setup, bool uneven) {
  MujocoTwin twin(setup, kTwinFriction, 9.81, {.uneven = uneven, .cone = false});
  PutAtStart(setup, twin);
  const int steps = uneven ? 5000 : 20000;
  const double start = CpuSeconds();
  for (int i = 0; i < steps; ++i) twin.Step(Drive());
  return steps / (CpuSeconds() - start);
}

double TwinConeStepsPerSecond(const std::string& soil) {
  const WorldSetup setup = ConeSetup(soil);
  MujocoTwin twin(setup, setup.station.cone.funnel_friction, 9.81, {.uneven = false, .cone = true});
  PutAtStart(setup, twin);
  return PressedStepsPerSecond([&] { return twin.ConePresses(); },
                               [&](const MotorCommands& commands) { twin.Step(commands); });
}

double RestingStepsPerSecond(const std::string& soil) {
  World world(Setup(soil, {}));
  const MotorCommands braked{};
  for (int i = 0; i < 20000; ++i) world.Step(braked);
  constexpr int kSteps = 20000;
  const double start = CpuSeconds();
  for (int i = 0; i < kSteps; ++i) world.Step(braked);
  return kSteps / (CpuSeconds() - start);
}

double SetUpSeconds(const std::string& soil) {
  const Scenario scenario = TypicalScenario({"soil=" + SourceFile("models/soils/" + soil)});
  const AxelModels models = LoadModels(scenario);
  constexpr int kRounds = 10;
  const double start = CpuSeconds();
  for (int i = 0; i < kRounds; ++i) World world(BuildRun(scenario, models).world);
  return (CpuSeconds() - start) / kRounds;
}

[[gnu::noinline]] void DriveOneSecond(World& world) {
  const MotorCommands commands = Drive();
  for (int i = 0; i < 1000; ++i) world.Step(commands);
}

}  // namespace dockyard::axel
