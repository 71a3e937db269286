// Speeds of the parts, all in one run, so that their ratios mean something on any machine. CPU time
// of this process; on a busy machine only the ratios hold.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "axel/sim/scenarios.h"
#include "bench/image_speed.h"
#include "bench/physics_speed.h"
#include "bench/pipe_speed.h"
#include "controller/vision/fiducials.h"
#include "controller/vision/locate.h"
#include "render/stereo_renderer.h"
#include "sim/axel/axel_view.h"

namespace dockyard::axel {
namespace {

constexpr const char* kLoose = "loose_sand.yaml";
constexpr const char* kCompact = "compact_gravel.yaml";

double Time(const std::function<void()>& work) {
  const double start = CpuSeconds();
  work();
  return CpuSeconds() - start;
}

double Middle(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct VisionSpeed {
  double pair_s = 0.0, detect_s = 0.0, locate_s = 0.0, alone_s = 0.0;
};

/// A rover at the start of a scenario, and its cameras' images there.
class StartView {
 public:
  explicit StartView(const std::vector<std::string>& overrides)
      : scenario_(TypicalScenario(overrides)),
        built_(Build(scenario_)),
        world_(built_.world),
        truth_(world_.truth()),
        builder_(built_.world.rover, built_.world.station, built_.world.soil, built_.lighting,
                 SiteOf(scenario_), scenario_.seed) {}

  const BuiltRun& built() const { return built_; }
  StereoImages Render(int index) {
    return renderer_.Render(builder_.Make(truth_, world_.ground()), built_.built_rig, truth_.X_WR,
                            CameraSensor(built_.world.rover.stereo, scenario_.seed, index));
  }

 private:
  Scenario scenario_;
  BuiltRun built_;
  World world_;
  Truth truth_;
  SceneBuilder builder_;
  StereoRenderer renderer_;
};

VisionSpeed TimeVision(int width, int height) {
  StartView view(
      {"camera.width_px=" + std::to_string(width), "camera.height_px=" + std::to_string(height)});
  const BuiltRun& built = view.built();
  StereoImages images;
  const auto render = [&](int index) { images = view.Render(index); };
  render(0);  // shaders and meshes are made once
  constexpr int kRounds = 8;
  VisionSpeed speed;
  speed.pair_s = Time([&] {
                   for (int i = 1; i <= kRounds; ++i) render(i);
                 }) /
                 kRounds;
  // Correspondence and pose are a small difference of large times: of each round, then the median.
  std::size_t found = 0;
  std::vector<double> detect_s, locate_s, alone_s;
  for (int i = 0; i < 2 * kRounds + 1; ++i) {
    detect_s.push_back(Time([&] {
      for (const GrayImage* image : {&images.left, &images.right}) {
        found += DetectFiducials(*image, built.nominal.board).size();
      }
    }));
    locate_s.push_back(Time([&] {
      found += static_cast<bool>(
          LocateBoard(images, built.nominal.rig, built.nominal.board, {}).sighting);
    }));
    alone_s.push_back(locate_s.back() - detect_s.back());
  }
  speed.detect_s = 0.5 * Middle(detect_s);
  speed.locate_s = Middle(locate_s);
  speed.alone_s = Middle(alone_s);
  if (found == 0) std::printf("  nothing was found in the image\n");
  return speed;
}

/// CPU of a pair at 1024 x 768; the least of several, which other programs disturb least.
double PairSeconds(const std::string& light, const std::string& range_m) {
  StartView view({"light=" + light, "start.r_m=" + range_m});
  double least_s = 1e9;
  for (int i = 0; i < 9; ++i) {
    const double pair_s = Time([&] { view.Render(i); });
    if (i > 0) least_s = std::min(least_s, pair_s);  // shaders and meshes are made once
  }
  return least_s;
}

/// Prints the table of the physics; returns the steps per second of driving on loose sand.
double ReportPhysics() {
  const auto drive = [](const char* soil) { return DrivingStepsPerSecond(DrivingSetup(soil)); };
  const double loose = drive(kLoose), compact = drive(kCompact);
  std::printf("physics, steps/s                          loose    compact\n");
  std::printf("  driving, both wheels in soil        %9.0f  %9.0f\n", loose, compact);
  const double twin = TwinStepsPerSecond(DrivingSetup(kLoose));
  std::printf(
      "  MuJoCo twin on a plane, smooth wheels %7.0f; driving is %.2f, %.2f times as fast\n", twin,
      loose / twin, compact / twin);
  std::printf("  arm pressed on the cone             %9.0f  %9.0f\n", ConeStepsPerSecond(kLoose),
              ConeStepsPerSecond(kCompact));
  std::printf("  braked and at rest                  %9.0f  %9.0f\n", RestingStepsPerSecond(kLoose),
              RestingStepsPerSecond(kCompact));
  std::printf("set-up of a run, models kept: %.4f s on loose sand, %.4f s on compact soil\n",
              SetUpSeconds(kLoose), SetUpSeconds(kCompact));
  return loose;
}

/// loose: physics steps per second to compare with; 0: none.
void ReportVision(double loose) {
  for (const char* light : {"even", "hard_shadow", "speckled"}) {
    std::printf("1024 x 768, %-11s: a pair takes %.3f s of CPU at 1.1 m, %.3f s at 3 m\n", light,
                PairSeconds(light, "1.1"), PairSeconds(light, "3"));
  }
  for (const auto& [width, height] : {std::pair(1024, 768), std::pair(640, 480)}) {
    const VisionSpeed speed = TimeVision(width, height);
    std::printf(
        "%4d x %3d: stereo pairs/s %.2f; detection %.1f ms an image; board from a pair %.1f ms, "
        "names and pose alone %.2f ms\n",
        width, height, 1.0 / speed.pair_s, 1e3 * speed.detect_s, 1e3 * speed.locate_s,
        1e3 * speed.alone_s);
    const double mujoco_s = MujocoPairSeconds(width, height);
    std::printf(
        "            a pair takes %.3f s of CPU, MuJoCo's renderer %.3f s: %.2f times as fast\n",
        speed.pair_s, mujoco_s, mujoco_s / speed.pair_s);
    if (loose > 0.0) {
      std::printf("            a pair costs as much as %.0f physics steps on loose sand\n",
                  speed.pair_s * loose);
    }
  }
}

void ReportPipe() {
  const PipeSpeed pipe = TimePipe("/proc/self/exe", 1024, 768);
  std::printf(
      "a call of a controller in another process: %.3f ms of wall time without images, %.2f ms "
      "with "
      "a pair at 1024 x 768\n",
      1e3 * pipe.without_images_s, 1e3 * pipe.with_pair_s);
}

void Report() {
  ReportVision(ReportPhysics());
  ReportPipe();
  const RunRecord record = SimulateTypical({});
  std::printf("whole docking (%s): %.1f s simulated, %.2f simulated seconds per CPU second\n",
              record.result.outcome.c_str(), record.result.sim_time_s,
              record.result.sim_time_s / record.timing.cpu_time_s);
}

}  // namespace
}  // namespace dockyard::axel

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "all";
  if (mode == "all") {
    dockyard::axel::Report();
  } else if (mode == "physics") {
    dockyard::axel::ReportPhysics();
  } else if (mode == "images") {
    dockyard::axel::ReportVision(0.0);
  } else if (mode == "pipe") {
    dockyard::axel::ReportPipe();
  } else if (mode == "peer") {  // the other end of the pipe
    return dockyard::RunPeer();
  } else if (mode == "one-second") {  // under callgrind, see scripts/bench
    const bool compact = argc > 2 && std::string(argv[2]) == "compact";
    dockyard::axel::World world(
        dockyard::axel::DrivingSetup(compact ? dockyard::axel::kCompact : dockyard::axel::kLoose));
    dockyard::axel::DriveOneSecond(world);
  } else if (mode == "cone") {
    std::printf("%.0f\n", dockyard::axel::ConeStepsPerSecond(dockyard::axel::kLoose));
  } else {
    std::fprintf(stderr, "usage: %s [all|physics|images|pipe|cone|one-second [loose|compact]]\n",
                 argv[0]);
    return 2;
  }
  return 0;
}
