// A docking's physics at steps of 2, 1 and 0.5 ms: scripted reeling with free wheels, no brain.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "physics/axel_numbers.h"

namespace dockyard {
namespace {

constexpr std::array<double, 3> kSteps = {2e-3, 1e-3, 0.5e-3};

struct Reeled {
  Truth end;
  double peak_n = 0.0, peak_cone_n = 0.0;
};

Reeled ReelIn(const SoilModel& soil, const Pose2& X_DR, double step_s, double seconds) {
  WorldSetup setup = TestSetup(soil, X_DR);
  setup.slack_start_m = 0.05;
  setup.station.cone.stop_depth_m = 0.22;
  setup.station.foot_friction = 0.6;
  setup.step_s = step_s;
  World world(setup);
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
  At(commands, Motor::kSpool) = Velocity(0.8, 1.94);
  Reeled reeled;
  for (long i = 0; i < std::lround(seconds / step_s); ++i) {
    world.Step(commands);
    reeled.end = world.truth();
    reeled.peak_n = std::max(reeled.peak_n, reeled.end.tether_tension_n);
    reeled.peak_cone_n = std::max(reeled.peak_cone_n, reeled.end.cone_force_n);
  }
  const Pose3& X = reeled.end.X_DR;
  std::printf(
      "%s, %.1f ms: x %.5f y %.5f m, heading %.3f deg, peak tension %.2f N, on cone %.1f N\n",
      soil.name.c_str(), 1e3 * step_s, X.p.x(), X.p.y(), Degrees(ToGround(X).heading),
      reeled.peak_n, reeled.peak_cone_n);
  return reeled;
}

// Paddles take soil along and let it go from one step to the next, and rim strips enter one by one,
// so that differences over the step have no clean order; they are small against what is measured.
TEST(Convergence, WayReeledOverSandHardlyDependsOnTheStep) {
  std::array<double, 3> x{};
  for (int i = 0; i < 3; ++i) {
    x[i] = ReelIn(LooseSand(), {1.6, 0.0, kPi}, kSteps[i], 10.0).end.X_DR.p.x();
  }
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(x[i], x[2], 1e-3);  // of 0.4 m
}

TEST(Convergence, PeakTensionAndPoseOfAStraightDockingConvergeOverTheStep) {
  std::array<Reeled, 3> reeled;
  for (int i = 0; i < 3; ++i) reeled[i] = ReelIn(LooseSand(), {1.6, 0.0, kPi}, kSteps[i], 22.0);
  EXPECT_LT(reeled[2].end.p_MT.x(), -0.219);
  EXPECT_NEAR(reeled[0].peak_n, reeled[2].peak_n, 1e-3 * reeled[2].peak_n);
  // At least first order: the error of 1 ms is a third of that of 2 ms or less.
  EXPECT_LT(3.0 * std::abs(reeled[1].peak_n - reeled[2].peak_n),
            1.01 * std::abs(reeled[0].peak_n - reeled[2].peak_n));
  EXPECT_NEAR(reeled[1].peak_cone_n, reeled[2].peak_cone_n, 0.01 * reeled[2].peak_cone_n);
  EXPECT_LT((reeled[0].end.X_DR.p - reeled[2].end.X_DR.p).norm(), 2e-4);
}

TEST(Convergence, DockingFromAsideOnEachSoilEndsInTheSamePlace) {
  // The arm rests in the socket by friction, anywhere in its clearance of 2.5 mm; that is what is
  // left of the pose's error, and it has no order.
  for (const SoilModel& soil : {LooseSand(), CompactSand()}) {
    std::array<Reeled, 3> reeled;
    for (int i = 0; i < 3; ++i) reeled[i] = ReelIn(soil, {1.6, 0.08, 3.1}, kSteps[i], 24.0);
    for (int i = 0; i < 2; ++i) {
      EXPECT_LT(reeled[i].end.p_MT.x(), -0.218) << soil.name;
      const Pose3 &X = reeled[i].end.X_DR, &fine = reeled[2].end.X_DR;
      EXPECT_NEAR(X.p.x(), fine.p.x(), 1e-4) << soil.name;
      EXPECT_NEAR(X.p.y(), fine.p.y(), 1.5e-3) << soil.name;
      EXPECT_NEAR(ToGround(X).heading, ToGround(fine).heading, Radians(0.1)) << soil.name;
      EXPECT_NEAR(reeled[i].peak_n, reeled[2].peak_n, 5e-3 * reeled[2].peak_n) << soil.name;
      EXPECT_NEAR(reeled[i].peak_cone_n, reeled[2].peak_cone_n, 0.02 * reeled[2].peak_cone_n)
          << soil.name;
    }
  }
}

}  // namespace
}  // namespace dockyard
