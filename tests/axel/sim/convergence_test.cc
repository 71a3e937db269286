// A docking's physics at steps of 2, 1 and 0.5 ms: scripted reeling with free wheels, no
// controller.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "axel/sim/product.h"

namespace dockyard::axel {
namespace {

constexpr std::array<double, 3> kSteps = {2e-3, 1e-3, 0.5e-3};

struct Reeled {
  Truth end;
  double peak_n = 0.0, held_on_cone_n = 0.0;  // on the cone: largest mean over 10 ms
  double x_after_10_s = 0.0;
};

enum class Wheels { kWithPaddles, kSmooth };

Reeled ReelIn(const SoilModel& soil, const Pose2& X_DR, Wheels wheels, double step_s) {
  WorldSetup setup = TestSetup(soil, X_DR);
  if (wheels == Wheels::kSmooth) {
    for (WheelModel* wheel : {&setup.rover.left_wheel_soil, &setup.rover.right_wheel_soil}) {
      *wheel = {.rim_radius_m = 0.3, .width_m = 0.15};
    }
  }
  setup.slack_start_m = 0.05;
  setup.step_s = step_s;
  World world(setup);
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
  At(commands, Motor::kSpool) = Velocity(0.8, 1.94);
  Reeled reeled;
  const long window = std::lround(10e-3 / step_s);
  double sum_n = 0.0;
  for (long i = 1; i <= std::lround(24.0 / step_s); ++i) {
    world.Step(commands);
    reeled.end = world.truth();
    reeled.peak_n = std::max(reeled.peak_n, reeled.end.tether_tension_n);
    sum_n += reeled.end.cone_force_n / static_cast<double>(window);
    if (i % window == 0) {
      reeled.held_on_cone_n = std::max(reeled.held_on_cone_n, std::exchange(sum_n, 0.0));
    }
    if (i == std::lround(10.0 / step_s)) reeled.x_after_10_s = reeled.end.X_DR.p.x();
  }
  const Pose3& X = reeled.end.X_DR;
  std::printf(
      "%s, %.1f ms: after 10 s x %.6f; at the end x %.5f y %.5f m, heading %.3f deg, tip %.4f m "
      "deep; peak tension %.2f N, held on cone %.1f N\n",
      soil.name.c_str(), 1e3 * step_s, reeled.x_after_10_s, X.p.x(), X.p.y(),
      Degrees(ToGround(X).heading), -reeled.end.p_MT.x(), reeled.peak_n, reeled.held_on_cone_n);
  return reeled;
}

std::array<Reeled, 3> AtEachStep(const SoilModel& soil, const Pose2& X_DR, Wheels wheels) {
  return {ReelIn(soil, X_DR, wheels, kSteps[0]), ReelIn(soil, X_DR, wheels, kSteps[1]),
          ReelIn(soil, X_DR, wheels, kSteps[2])};
}

TEST(Convergence, DockingOnSmoothWheelsIsOfFirstOrderInTheStep) {
  // Where errors go with the step, 2 ms differs from 0.5 ms by (2 - 0.5) / (1 - 0.5) = 3 times as
  // much as 1 ms, by 5 times where they go with its square. A sum taken in another order moves the
  // peak by some hundredths of a newton.
  const auto reeled = AtEachStep(LooseSand(), {1.6, 0.0, kPi}, Wheels::kSmooth);
  const Reeled& fine = reeled[2];
  const double coarse_n = std::abs(reeled[0].peak_n - fine.peak_n);
  const double middle_n = std::abs(reeled[1].peak_n - fine.peak_n);
  EXPECT_LT(coarse_n, 0.5);
  EXPECT_LT(middle_n, coarse_n / 2.2 + 0.02);
  EXPECT_GT(middle_n, coarse_n / 5.0 - 0.02);
  // The pose's error has no order any more: it is what rest and rounding leave.
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(reeled[i].x_after_10_s, fine.x_after_10_s, i == 0 ? 0.5e-3 : 0.2e-3);  // of 0.42 m
    EXPECT_LT((reeled[i].end.X_DR.p - fine.end.X_DR.p).norm(), 5e-5);
  }
}

// With paddles there is no order: over which tip a settling wheel comes to rest is decided by less
// than a step, and moves the way by tenths of a millimetre at any step, and by a millimetre on firm
// soil, where a wheel stands on one or two tips.
void ExpectAlike(const std::array<Reeled, 3>& reeled, double held_share, double way_m) {
  const Reeled& fine = reeled[2];
  EXPECT_NEAR(-fine.end.p_MT.x(), Station().cone.stop_depth_m, 0.005);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(reeled[i].x_after_10_s, fine.x_after_10_s, way_m);
    EXPECT_NEAR(reeled[i].peak_n, fine.peak_n, 0.005 * fine.peak_n);
    EXPECT_NEAR(reeled[i].held_on_cone_n, fine.held_on_cone_n, held_share * fine.held_on_cone_n);
    // The arm rests in the socket by friction, anywhere in the disc's clearance of 0.8 mm.
    EXPECT_LT((reeled[i].end.X_DR.p - fine.end.X_DR.p).norm(), 1e-3);
    EXPECT_NEAR(ToGround(reeled[i].end.X_DR).heading, ToGround(fine.end.X_DR).heading,
                Radians(0.1));
  }
}

TEST(Convergence, StraightDockingIsAlikeAtEveryStepOnEachSoil) {
  ExpectAlike(AtEachStep(LooseSand(), {1.6, 0.0, kPi}, Wheels::kWithPaddles), 0.01, 0.5e-3);
  ExpectAlike(AtEachStep(CompactGravel(), {1.6, 0.0, kPi}, Wheels::kWithPaddles), 0.03, 1.5e-3);
}

TEST(Convergence, DockingFromAsideIsAlikeAtEveryStepOnEachSoil) {
  ExpectAlike(AtEachStep(LooseSand(), {1.6, 0.08, 3.1}, Wheels::kWithPaddles), 0.03, 0.5e-3);
  ExpectAlike(AtEachStep(CompactGravel(), {1.6, 0.08, 3.1}, Wheels::kWithPaddles), 0.03, 2e-3);
}

}  // namespace
}  // namespace dockyard::axel
