#include "controller/axel/tether_observer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {
namespace {

// The distance to a place shrinks by no more than one moves, wherever the place is.
TEST(TakenBeyond, IsNoneHoweverTheRoverMoves) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  for (int i = 0; i < 10'000; ++i) {
    const Eigen::Vector2d station(place(random), place(random));
    const Eigen::Vector2d before(place(random), place(random)), after(place(random), place(random));
    const TetherCount since{.reeled_m = 1.0, .p_OT = before};
    const TetherCount now{.reeled_m = 1.0 + (station - before).norm() - (station - after).norm(),
                          .p_OT = after};
    EXPECT_LE(TakenBeyond(since, now), 1e-12);
  }
}

TEST(TakenBeyond, IsWhatTheStationSlidTowardsARoverAtRest) {
  const TetherCount since{.reeled_m = 0.5, .p_OT = {1.0, 2.0}};
  const TetherCount now{.reeled_m = 0.62, .p_OT = {1.0, 2.0}};
  EXPECT_NEAR(TakenBeyond(since, now), 0.12, 1e-12);
}

class Observed : public testing::Test {
 protected:
  void Move(double rolled_m, double reeled_m) {
    rolled_m_ += rolled_m;
    reeled_m_ += reeled_m;
    frame_.tick += kControlPeriod;
    Turn(Motor::kSpool, reeled_m_ / nominal_.drum_radius_m);
    Turn(Motor::kLeftWheel, rolled_m_ / nominal_.wheel_radius_m);
    Turn(Motor::kRightWheel, rolled_m_ / nominal_.wheel_radius_m);
    senses_.Update(frame_);
  }
  void Turn(Motor motor, double angle_rad) {
    const auto i = static_cast<std::size_t>(motor);
    frame_.motors[i].encoder_counts =
        static_cast<std::int64_t>(angle_rad / nominal_.motors[i].rad_per_count);
  }
  /// How far the wheels roll before they are said to dig, at most 2 m; none: they do not dig.
  std::optional<double> DigsAfter(double step_m, double borne_out) {
    senses_.Update(frame_);
    senses_.filter().Restart(PoseFixAt({4.0, 0.0, kPi}));
    DigWatch watch(TetherGeometryOf(nominal_), options_.dig);
    while (std::abs(rolled_m_) < 2.0) {
      Move(step_m, step_m * borne_out);
      if (watch.Digs(senses_)) return std::abs(rolled_m_);
    }
    return std::nullopt;
  }
  BoardFix PoseFixAt(const Pose2& X_DR) const {
    const Eigen::Vector2d to = nominal_.X_DB.p.head<2>() - Eigen::Vector2d(X_DR.x, X_DR.y);
    return {to.norm(), WrapPi(std::atan2(to.y(), to.x()) - X_DR.heading), X_DR.heading};
  }

  const Nominal nominal_ = TestNominal();
  const AxelOptions options_{};
  SensorFrame frame_ = StillFrame();
  Senses senses_{nominal_, options_};
  double rolled_m_ = 0.0, reeled_m_ = 0.0;
};

TEST_F(Observed, StationSlidesWhereTheDrumTakesUpTetherAndNothingRolls) {
  SlideWatch watch(nominal_.arm_length_m, options_.slide);
  Move(0.0, 0.0);
  watch.Begin(senses_);
  watch.Stalled(senses_);
  Move(0.0, 0.015);
  EXPECT_FALSE(watch.Slides(senses_));
  Move(0.0, 0.015);
  EXPECT_TRUE(watch.Slides(senses_));
}

// The tether stretches, and the rover is dragged a little before its wheels roll.
TEST_F(Observed, StationDoesNotSlideAsThePullBegins) {
  SlideWatch watch(nominal_.arm_length_m, options_.slide);
  Move(0.0, 0.0);
  watch.Begin(senses_);
  Move(0.0, 0.06);
  EXPECT_FALSE(watch.Slides(senses_));
  for (int i = 0; i < 100; ++i) Move(0.01, 0.01);
  EXPECT_FALSE(watch.Slides(senses_));
}

// A wheel that slips rolls more than the rover moves.
TEST_F(Observed, SlideIsNotHiddenByWheelsThatSlippedBefore) {
  SlideWatch watch(nominal_.arm_length_m, options_.slide);
  Move(0.0, 0.0);
  watch.Begin(senses_);
  watch.Stalled(senses_);
  Move(0.2, 0.0);
  watch.NextStage(senses_);
  Move(0.0, 0.04);
  EXPECT_TRUE(watch.Slides(senses_));
}

TEST_F(Observed, WheelsThatSlipByHalfDoNotDig) { EXPECT_FALSE(DigsAfter(-0.001, 0.5)); }
TEST_F(Observed, WheelsDigWhereTheDrumGivesNothingOut) {
  const auto rolled = DigsAfter(-0.001, 0.1);
  ASSERT_TRUE(rolled);
  EXPECT_LT(*rolled, 0.35);
}
TEST_F(Observed, WheelsDigWhereTheDrumTakesNothingUp) { EXPECT_TRUE(DigsAfter(0.001, 0.1)); }

// mu m g cos(slope) - m g sin(slope) with 0.8 of the friction and 0.95 of the weight.
TEST(SureHold, IsTheLeastThatTheTolerancesAllow) {
  const Nominal nominal = TestNominal();
  const HoldOptions options{};
  EXPECT_NEAR(SureHold(nominal, options, 0.0, 0.0), 0.95 * 343.0 * 0.32, 1e-9);
  EXPECT_NEAR(SureHold(nominal, options, Radians(5.0), 0.0), 75.5, 0.5);
  EXPECT_EQ(SureHold(nominal, options, Radians(20.0), 0.0), 0.0);
}

// By the upper bound theorem: of all motions of four loaded soles, with force F0 together, the one
// that a pull at the mouth begins takes the least force, what is rubbed away over the mouth's speed
// along the pull.
double LeastForce(double aside_rad) {
  const double back_m = 0.40, half_m = 0.25;
  double least = 1e9;
  for (int i = -400; i <= 400; ++i) {
    const double turn = 0.025 * i;
    for (int j = 0; j < 720; ++j) {
      const double vx = std::cos(j * kPi / 360.0), vy = std::sin(j * kPi / 360.0);
      const double along = vx * std::cos(aside_rad) + (vy + turn * back_m) * std::sin(aside_rad);
      if (along < 1e-6) continue;
      double rubbed = 0.0;
      for (const double x : {-half_m, half_m}) {
        for (const double y : {-half_m, half_m}) {
          rubbed += 0.25 * std::hypot(vx - turn * y, vy + turn * x);
        }
      }
      least = std::min(least, rubbed / along);
    }
  }
  return least;
}

TEST(SureHold, OfAPullFromAsideIsThatOfFourSoles) {
  const Nominal nominal = TestNominal();
  const HoldOptions options{};
  const double straight_n = SureHold(nominal, options, 0.0, 0.0);
  for (const double aside_deg : {0.0, 30.0, 45.0, 60.0, 90.0}) {
    const double aside_rad = Radians(aside_deg);
    EXPECT_NEAR(SureHold(nominal, options, 0.0, aside_rad) / straight_n, LeastForce(aside_rad),
                0.06 * LeastForce(aside_rad))
        << aside_deg;
    EXPECT_LT(SureHold(nominal, options, Radians(5.0), aside_rad),
              SureHold(nominal, options, 0.0, aside_rad));
  }
}

}  // namespace
}  // namespace dockyard::axel
