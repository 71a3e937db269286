// A docking's physics at steps of 2, 1 and 0.5 ms: scripted reeling with free wheels, no brain.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "physics/product.h"

namespace dockyard {
namespace {

constexpr std::array<double, 3> kSteps = {2e-3, 1e-3, 0.5e-3};

struct Reeled {
  Truth end;
  double peak_n = 0.0, held_on_cone_n = 0.0;  // on the cone: largest mean over 10 ms
  double x_after_10_s = 0.0;
};

Reeled ReelIn(const SoilModel& soil, const Pose2& X_DR, double step_s) {
  WorldSetup setup = TestSetup(soil, X_DR);
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

std::array<Reeled, 3> AtEachStep(const SoilModel& soil, const Pose2& X_DR) {
  return {ReelIn(soil, X_DR, kSteps[0]), ReelIn(soil, X_DR, kSteps[1]),
          ReelIn(soil, X_DR, kSteps[2])};
}

/// Of values at 2, 1 and 0.5 ms whose errors go with the step, the first differs from the last by
/// (2 - 0.5) / (1 - 0.5) = 3 times as much as the second; 5 times, if they go with its square.
/// floor: what a sum taken in another order or one step of the sampling moves.
void ExpectFirstOrder(const std::array<double, 3>& value, double largest, double floor,
                      const char* what) {
  const double coarse = std::abs(value[0] - value[2]), middle = std::abs(value[1] - value[2]);
  EXPECT_LT(middle, coarse / 2.2 + floor) << what;
  EXPECT_GT(middle, coarse / 5.0 - floor) << what;
  EXPECT_LT(coarse, largest) << what;
}

template <typename Value>
std::array<double, 3> Each(const std::array<Reeled, 3>& reeled, const Value& value) {
  return {value(reeled[0]), value(reeled[1]), value(reeled[2])};
}

/// way_floor_m: over which paddle a settling wheel comes to rest moves the whole way by so much.
void ExpectWayAndPeaksOfFirstOrder(const std::array<Reeled, 3>& reeled, double way_floor_m) {
  ExpectFirstOrder(Each(reeled, [](const Reeled& r) { return r.x_after_10_s; }), 3e-4, way_floor_m,
                   "x");
  ExpectFirstOrder(Each(reeled, [](const Reeled& r) { return r.peak_n; }), 0.6, 0.04, "tension");
  ExpectFirstOrder(Each(reeled, [](const Reeled& r) { return r.held_on_cone_n; }), 1.5, 0.2,
                   "on the cone");
}

TEST(Convergence, StraightDockingIsOfFirstOrderInTheStepOnEachSoil) {
  for (const SoilModel& soil : {LooseSand(), CompactGravel()}) {
    SCOPED_TRACE(soil.name);
    const auto reeled = AtEachStep(soil, {1.6, 0.0, kPi});
    EXPECT_LT(reeled[2].end.p_MT.x(), -0.26);
    ExpectWayAndPeaksOfFirstOrder(reeled, 2e-5);
    // The arm rests in the socket by friction, anywhere in its clearance of 0.8 mm.
    for (int i = 0; i < 2; ++i) {
      EXPECT_LT((reeled[i].end.X_DR.p - reeled[2].end.X_DR.p).norm(), 5e-4);
    }
  }
}

TEST(Convergence, DockingFromAsideOverSandIsOfFirstOrder) {
  const auto reeled = AtEachStep(LooseSand(), {1.6, 0.08, 3.1});
  ExpectWayAndPeaksOfFirstOrder(reeled, 4e-5);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT((reeled[i].end.X_DR.p - reeled[2].end.X_DR.p).norm(), 5e-4);
    EXPECT_NEAR(ToGround(reeled[i].end.X_DR).heading, ToGround(reeled[2].end.X_DR).heading,
                Radians(0.02));
  }
}

TEST(Convergence, DockingFromAsideOverPaddlesTipsEndsAlikeAtEveryStep) {
  // On compact soil a wheel that stands on a tip can fall to either side, and which decides over
  // way and heading by centimetres for a while: no order is to be had. It ends in the same socket.
  const auto reeled = AtEachStep(CompactGravel(), {1.6, 0.08, 3.1});
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(reeled[i].peak_n, reeled[2].peak_n, 0.01 * reeled[2].peak_n);
    EXPECT_NEAR(reeled[i].held_on_cone_n, reeled[2].held_on_cone_n,
                0.03 * reeled[2].held_on_cone_n);
    EXPECT_LT((reeled[i].end.X_DR.p - reeled[2].end.X_DR.p).norm(), 1e-3);
    EXPECT_NEAR(ToGround(reeled[i].end.X_DR).heading, ToGround(reeled[2].end.X_DR).heading,
                Radians(0.1));
  }
}

}  // namespace
}  // namespace dockyard
