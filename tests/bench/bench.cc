// Speeds of the parts, all in one run, so that their ratios mean something on any machine. CPU time
// of this process; on a busy machine only the ratios hold. Each peer's row says what it leaves out.
#include <cstdio>
#include <string>
#include <utility>

#include "axel/sim/scenarios.h"
#include "bench/image_speed.h"
#include "bench/physics_speed.h"
#include "bench/pipe_speed.h"
#include "bench/vision_speed.h"

namespace dockyard::axel {
namespace {

constexpr const char* kLoose = "loose_sand.yaml";
constexpr const char* kCompact = "compact_gravel.yaml";

struct Soils {
  double loose = 0.0, compact = 0.0;
};

void Row(const char* name, const Soils& speed) {
  std::printf("  %-44s %9.0f  %9.0f\n", name, speed.loose, speed.compact);
}

/// A peer that has no soil: one speed, and how many times as fast ours is.
void PeerRow(const char* name, double peer, const Soils& ours) {
  std::printf("  %-44s %9.0f  ours is %.2f, %.2f times as fast\n", name, peer, ours.loose / peer,
              ours.compact / peer);
}

/// Prints the table of the physics; returns the steps per second of driving on loose sand.
double ReportPhysics() {
  const Soils drive{DrivingStepsPerSecond(DrivingSetup(kLoose)),
                    DrivingStepsPerSecond(DrivingSetup(kCompact))};
  std::printf("%-46s %9s  %9s\n", "physics, steps/s", "loose", "compact");
  Row("driving, both wheels in soil", drive);
  PeerRow("MuJoCo twin on a plane", TwinStepsPerSecond(DrivingSetup(kLoose), false), drive);
  PeerRow("MuJoCo twin on the same undulation", TwinStepsPerSecond(DrivingSetup(kLoose), true),
          drive);
  std::printf(
      "    without: soil, ruts, paddles (its wheels are rigid smooth cylinders), the arm's ground\n"
      "    contact, a station that moves, a tether that bends\n");
  const Soils cone{ConeStepsPerSecond(kLoose), ConeStepsPerSecond(kCompact)};
  Row("arm pressed on the cone", cone);
  PeerRow("MuJoCo twin, cone of 48 hulls, on a plane", TwinConeStepsPerSecond(kLoose), cone);
  std::printf(
      "    without: the same, and round surfaces (sectors of 15 deg); its contacts end a step at\n"
      "    MuJoCo's own tolerance\n");
  Row("braked and at rest", {RestingStepsPerSecond(kLoose), RestingStepsPerSecond(kCompact)});
  std::printf("set-up of a run, models kept: %.4f s on loose sand, %.4f s on compact soil\n",
              SetUpSeconds(kLoose), SetUpSeconds(kCompact));
  return drive.loose;
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
  std::printf(
      "    MuJoCo draws in colour with four samples a pixel, on the same OSMesa, but without: a\n"
      "    fish-eye lens, the sun's penumbra, a ground finer than 150 x 150, the sensor\n");
}

void ReportPipe() {
  const PipeSpeed pipe = TimePipe("/proc/self/exe", 1024, 768);
  std::printf(
      "a call of a controller in another process: %.3f ms of wall time without images, %.2f ms "
      "with a pair at 1024 x 768\n",
      1e3 * pipe.without_images_s, 1e3 * pipe.with_pair_s);
}

}  // namespace
}  // namespace dockyard::axel

int main(int argc, char** argv) {
  using namespace dockyard::axel;
  const std::string mode = argc > 1 ? argv[1] : "all";
  if (mode == "all") {
    ReportVision(ReportPhysics());
    ReportPipe();
  } else if (mode == "physics") {
    ReportPhysics();
  } else if (mode == "images") {
    ReportVision(0.0);
  } else if (mode == "pair" && argc == 4) {  // one of the images' figures, for a profile
    std::printf("%.4f\n", PairSeconds(argv[2], argv[3]));
  } else if (mode == "pipe") {
    ReportPipe();
  } else if (mode == "peer") {  // the other end of the pipe
    return dockyard::RunPeer();
  } else if (mode == "one-second") {  // under callgrind, see scripts/bench
    const bool compact = argc > 2 && std::string(argv[2]) == "compact";
    World world(DrivingSetup(compact ? kCompact : kLoose));
    DriveOneSecond(world);
  } else if (mode == "cone") {
    std::printf("%.0f\n", ConeStepsPerSecond(kLoose));
  } else {
    std::fprintf(stderr,
                 "usage: %s [all|physics|images|pair LIGHT RANGE_M|pipe|cone|one-second "
                 "[loose|compact]]\n",
                 argv[0]);
    return 2;
  }
  return 0;
}
