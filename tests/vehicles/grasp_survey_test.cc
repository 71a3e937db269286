// Grasps of many stones by a script, with steps of 1 and 0.5 ms: how many are held, through 10 s
// and a drive of half a metre, and whether the step changes that. Minutes.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "sim/base/random.h"
#include "vehicles/stone_rig.h"

namespace dockyard {
namespace {

constexpr int kSeeds = 20;

struct Outcome {
  bool lifted = false, held = false, kept = false;  // after the lift, 10 s more, the drive
  double creep_m = 0.0, steps_per_s = 0.0;
  int sweeps = 0;
};

/// The stone lies off the point under the arm by a distance in this range.
struct Off {
  double from_m = 0.0, to_m = 0.0;
};

Outcome Try(const std::string& soil, int seed, Off off, double step_s) {
  const RoverModel model = RoverRig::Model("rocky7");
  RandomStream random(StreamKey(static_cast<std::uint64_t>(seed), "grasp survey"));
  const double length_m = random.Uniform(0.03, 0.05), turn_rad = random.Uniform(-kPi, kPi);
  // Uniform on the ring.
  const double off_m = std::sqrt(random.Uniform(off.from_m * off.from_m, off.to_m * off.to_m));
  const double off_rad = random.Uniform(-kPi, kPi);
  ArmRig rig(model, soil, 0.6, step_s);
  rig.Run(1.0);
  const Eigen::Vector2d at = rig.PointUnderArm();
  rig.Add(OnGround(LooseStoneShape(length_m, static_cast<std::uint64_t>(seed)),
                   at.x() + off_m * std::cos(off_rad), at.y() + off_m * std::sin(off_rad),
                   turn_rad));
  Outcome outcome;
  rig.each_period = [&] { outcome.sweeps = std::max(outcome.sweeps, rig.world.sweeps()); };
  Grasp(rig, {}, 0.35);
  outcome.lifted = rig.StoneHeight(0) > 0.05;
  rig.Run(2.0);
  const Eigen::Vector3d before = rig.StoneInArm(0);
  const auto start = std::chrono::steady_clock::now();
  rig.Run(10.0);
  outcome.steps_per_s =
      10.0 / step_s /
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.creep_m = (rig.StoneInArm(0) - before).norm();
  outcome.held = rig.StoneHeight(0) > 0.05;
  rig.Drive(0.5);
  outcome.kept = rig.StoneHeight(0) > 0.05;
  return outcome;
}

TEST(GraspSurvey, HoldsMostStonesOfThreeToFiveCentimetresWhateverTheStep) {
  for (const char* soil : {"loose_sand", "compact_gravel"}) {
    int kept[2] = {}, lifted[2] = {}, held[2] = {}, same = 0;
    double creep_m = 0.0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      Outcome outcomes[2];
      for (int half = 0; half < 2; ++half) {
        Outcome& outcome = outcomes[half] = Try(soil, seed, {0.0, 0.01}, half == 0 ? 1e-3 : 0.5e-3);
        lifted[half] += outcome.lifted;
        held[half] += outcome.held;
        kept[half] += outcome.kept;
        if (outcome.held) creep_m = std::max(creep_m, outcome.creep_m);
        std::printf(
            "%s seed %d step %.1f ms: lifted %d held %d kept %d, creep %.3f mm, %.0f/s, %d\n", soil,
            seed, half == 0 ? 1.0 : 0.5, outcome.lifted, outcome.held, outcome.kept,
            1e3 * outcome.creep_m, outcome.steps_per_s, outcome.sweeps);
        std::fflush(stdout);
      }
      same += outcomes[0].kept == outcomes[1].kept;
    }
    std::printf(
        "%s: lifted %d and %d, held %d and %d, kept %d and %d of %d; same %d; creep %.3f mm\n",
        soil, lifted[0], lifted[1], held[0], held[1], kept[0], kept[1], kSeeds, same,
        1e3 * creep_m);
    EXPECT_GE(same, kSeeds - 2) << soil;
    EXPECT_LT(creep_m, 0.5e-3) << soil;
  }
}

// How far off the point under the arm a stone may lie: the valid place for a grasp.
TEST(GraspSurvey, LosesStonesThatLieTooFarOff) {
  for (const char* soil : {"loose_sand", "compact_gravel"}) {
    int first = 0, last = 0;
    for (int ring = 0; ring < 5; ++ring) {
      int kept = 0;
      for (int seed = 101; seed < 111; ++seed) {
        kept += Try(soil, seed, {0.01 * ring, 0.01 * ring + 0.01}, 1e-3).kept;
      }
      std::printf("%s %d to %d mm off: kept %d of 10\n", soil, 10 * ring, 10 * ring + 10, kept);
      std::fflush(stdout);
      (ring == 0 ? first : last) = kept;
    }
    EXPECT_GT(first, last) << soil;
  }
}

}  // namespace
}  // namespace dockyard
