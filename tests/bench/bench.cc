// Speeds of the parts, all in one run, so that their ratios mean something on any machine. CPU time
// of this process; on a busy machine only the ratios hold.
#include <ctime>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "controller/docking/axel.h"
#include "controller/vision/fiducials.h"
#include "controller/vision/locate.h"
#include "models/load_scenario.h"
#include "render/stereo_renderer.h"
#include "sim/run/build_run.h"
#include "sim/run/loop.h"
#include "sim/run/view.h"

namespace dockyard {
namespace {

const std::string kScenario = std::string(DOCKYARD_SOURCE_DIR) + "/scenarios/axel_typical.yaml";

double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double Time(const std::function<void()>& work) {
  const double start = CpuSeconds();
  work();
  return CpuSeconds() - start;
}

std::unique_ptr<Controller> MakeBrain(const std::string&, const RoverSheet& sheet) {
  return MakeAxelController(sheet);
}

/// Both wheels driven over their soil, far from the station, the tether in tow.
double StepsPerSecond(const std::string& soil) {
  const BuiltRun built = BuildRun(LoadScenario(
      kScenario, {"soil=" + std::string(DOCKYARD_SOURCE_DIR) + "/models/soils/" + soil}));
  World world(built.world);
  std::array<MotorCommand, kMotorCount> commands{};
  for (int wheel = 0; wheel < 2; ++wheel) {
    commands[wheel] = {.mode = MotorMode::kVelocity,
                       .target = 0.17,  // 0.05 m/s
                       .accel_rad_s2 = 1.0,
                       .current_limit_a = 2.8};
  }
  commands[3] = {
      .mode = MotorMode::kVelocity, .target = 1.2, .accel_rad_s2 = 2.0, .current_limit_a = 0.5};
  constexpr int kSteps = 20000;
  const double seconds = Time([&] {
    for (int i = 0; i < kSteps; ++i) world.Step(commands);
  });
  return kSteps / seconds;
}

struct EyesSpeed {
  double pair_s = 0.0, detect_s = 0.0, locate_s = 0.0;
};

EyesSpeed TimeEyes(int width, int height) {
  const Scenario scenario = LoadScenario(kScenario, {"camera.width_px=" + std::to_string(width),
                                                     "camera.height_px=" + std::to_string(height)});
  const BuiltRun built = BuildRun(scenario);
  const World world(built.world);
  const Truth truth = world.truth();
  const SceneBuilder builder(built.world.rover, built.world.station, built.world.soil,
                             built.lighting, scenario.X_WG, scenario.seed);
  StereoRenderer renderer;
  StereoImages images;
  const auto render = [&](int index) {
    images = renderer.Render(builder.Make(truth, world.ground()), built.built_rig, truth.X_WR,
                             CameraSensor(built.world.rover.stereo, scenario.seed, index));
  };
  render(0);  // shaders and meshes are made once
  constexpr int kRounds = 8;
  EyesSpeed speed;
  speed.pair_s = Time([&] {
                   for (int i = 1; i <= kRounds; ++i) render(i);
                 }) /
                 kRounds;
  std::size_t found = 0;
  speed.detect_s = Time([&] {
                     for (int i = 0; i < kRounds; ++i) {
                       found += DetectFiducials(images.left, built.sheet.board).size();
                     }
                   }) /
                   kRounds;
  speed.locate_s = Time([&] {
                     for (int i = 0; i < kRounds; ++i) {
                       found += static_cast<bool>(
                           LocateBoard(images, built.sheet.rig, built.sheet.board, {}).sighting);
                     }
                   }) /
                   kRounds;
  if (found == 0) std::printf("  nothing was found in the picture\n");
  return speed;
}

void Report() {
  const double loose = StepsPerSecond("loose_sand.yaml");
  const double compact = StepsPerSecond("compact_gravel.yaml");
  std::printf("physics, both wheels in soil, steps/s      loose %.0f, compact %.0f\n", loose,
              compact);
  for (const auto& [width, height] : {std::pair(1024, 768), std::pair(640, 480)}) {
    const EyesSpeed eyes = TimeEyes(width, height);
    std::printf(
        "%4d x %3d: stereo pairs/s %.2f; detection %.1f ms an image; board from a pair %.1f ms\n",
        width, height, 1.0 / eyes.pair_s, 1e3 * eyes.detect_s, 1e3 * eyes.locate_s);
    std::printf("            a pair costs as much as %.0f physics steps on loose sand\n",
                eyes.pair_s * loose);
  }
  CampaignRun run;
  run.scenario = LoadScenario(kScenario);
  const RunRecord record = RunDocking(run, MakeBrain, {});
  std::printf("whole docking (%s): %.1f s simulated, %.2f simulated seconds per CPU second\n",
              Name(record.result.outcome), record.result.sim_time_s,
              record.result.sim_time_s / record.timing.cpu_time_s);
}

}  // namespace
}  // namespace dockyard

int main() {
  dockyard::Report();
  return 0;
}
