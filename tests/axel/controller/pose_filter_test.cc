#include "controller/axel/pose_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/kinematic_rover.h"

namespace dockyard::axel {
namespace {

using testing::DoubleNear;

BoardFix TrueFix(const Pose2& X_DR, const Pose3& X_DB) {
  const double dx = X_DB.p.x() - X_DR.x, dy = X_DB.p.y() - X_DR.y;
  return {std::hypot(dx, dy), WrapPi(std::atan2(dy, dx) - X_DR.heading), X_DR.heading,
          Eigen::Vector3d::Zero()};
}

class Filter : public testing::Test {
 protected:
  const Nominal nominal_ = TestNominal();
  const TetherGeometry tether_ = TetherGeometryOf(nominal_);
  // Wheels that roll as far as they turn.
  const FilterNoise noise_{.slip = {}};
  PoseFilter filter_{noise_, tether_, nominal_.X_DB};
  const Pose2 start_ = FromDockingCoords({4.0, 0.3, 0.1});
};

TEST_F(Filter, IsWhereTheFirstLookSays) {
  filter_.Correct(TrueFix(start_, nominal_.X_DB));
  EXPECT_THAT(filter_.pose().x, DoubleNear(start_.x, 1e-9));
  EXPECT_THAT(filter_.pose().y, DoubleNear(start_.y, 1e-9));
  EXPECT_THAT(filter_.pose().heading, DoubleNear(start_.heading, 1e-9));
}

TEST_F(Filter, LevelsATiltedSighting) {
  ImuSample imu;
  imu.pitch_rad = 0.2;
  imu.roll_rad = -0.1;
  const Pose3 X_HR{Tilt(AttitudeOf(imu)), Eigen::Vector3d::Zero()};
  const Pose3 X_RB = Inverse(FromGround(start_, 0.3) * X_HR) * nominal_.X_DB;
  const Pose2 pose = PoseOf(LevelSighting(X_RB, imu, nominal_.X_DB, {}), nominal_.X_DB);
  EXPECT_THAT(pose.x, DoubleNear(start_.x, 1e-9));
  EXPECT_THAT(pose.y, DoubleNear(start_.y, 1e-9));
  EXPECT_THAT(WrapPi(pose.heading - start_.heading), DoubleNear(0.0, 1e-9));
}

TEST_F(Filter, DeadReckonsAlongTheArc) {
  filter_.Correct(TrueFix(start_, nominal_.X_DB));
  filter_.Predict({1.0, 0.4}, 20.0);
  const Pose2 expected = Advance(start_, Arc{1.0, 0.4});
  EXPECT_THAT(filter_.pose().x, DoubleNear(expected.x, 1e-9));
  EXPECT_THAT(filter_.pose().y, DoubleNear(expected.y, 1e-9));
}

// On the axis a range tells of x alone: a filter of one state, in closed form.
TEST_F(Filter, TrustsARangeMoreAfterAWayWithout) {
  const FilterNoise noise;
  const auto variance_m2 = [&](double range_m) {
    return std::pow(noise.range_floor_m + noise.range_m_per_m2 * range_m * range_m, 2);
  };
  const Pose2 start = FromDockingCoords({4.0, 0.0, 0.0}), after = Advance(start, Arc{1.0, 0.0});
  const BoardFix first = TrueFix(start, nominal_.X_DB), second = TrueFix(after, nominal_.X_DB);
  ASSERT_THAT(first.bearing_rad, DoubleNear(0.0, 1e-9));
  for (int i = 0; i < 100; ++i) filter_.Correct(first);
  filter_.Predict({1.0, 0.0}, 20.0);
  const double p_m2 = variance_m2(first.range_m) / 100 + std::pow(noise.along_m_per_sqrt_m, 2) +
                      std::pow(noise.rolling_sigma, 2);

  BoardFix farther = second;
  farther.range_m += 0.01;
  filter_.Correct(farther);
  const double gain = p_m2 / (p_m2 + variance_m2(farther.range_m));
  // The first pose is known to 32 m at first: 1e-5 of the gain.
  EXPECT_THAT((filter_.pose().x - after.x) / 0.01, DoubleNear(gain, 1e-4));
  EXPECT_GT(gain, 0.3);  // before the way 0.01, after a hundred looks
}

TEST_F(Filter, TautTetherTellsOfWheelSlip) {
  const Pose2 ahead = FromDockingCoords({4.0, 0.0, 0.0});
  filter_.Correct(TrueFix(ahead, nominal_.X_DB));
  filter_.CorrectByTether(0.0, 0.0);
  // Wheels say 1 m, the drum only took up 0.9 m.
  for (int i = 0; i < 100; ++i) filter_.Predict({0.01, 0.0}, 0.2);
  filter_.CorrectByTether(0.9, 0.0);
  EXPECT_THAT(filter_.pose().x, DoubleNear(3.1, 0.03));
}

TEST_F(Filter, TetherKnowsTheExposedLength) {
  filter_.Correct(TrueFix(start_, nominal_.X_DB));
  filter_.CorrectByTether(1.25, 0.05);
  EXPECT_THAT(filter_.ExposedLength(1.25), DoubleNear(ExposedTether(tether_, start_, 0.05), 1e-3));
}

TEST_F(Filter, ManyNoisyHeadingsAverageOut) {
  RandomStream random(StreamKey(5, "filter"));
  for (int i = 0; i < 40; ++i) {
    BoardFix fix = TrueFix(start_, nominal_.X_DB);
    fix.heading_rad += Radians(4.0) * random.Normal();
    filter_.Correct(fix);
  }
  EXPECT_THAT(Degrees(WrapPi(filter_.pose().heading - start_.heading)), DoubleNear(0.0, 1.5));
}

TEST_F(Filter, ALookFromAnotherPlaceDoesNotFit) {
  for (int i = 0; i < 2; ++i) filter_.Correct(TrueFix(start_, nominal_.X_DB));
  BoardFix wrong = TrueFix(start_, nominal_.X_DB);
  EXPECT_TRUE(filter_.Fits(wrong));
  wrong.heading_rad += 0.6;
  EXPECT_FALSE(filter_.Fits(wrong));
}

// Drives legs across a slope of 6 % with a sighting after each, slipping downhill by this much more
// than the force's share; what the filter believes of the slip.
WheelSlip LearnedFrom(PoseFilter* filter, const Pose3& X_DB, double true_slip) {
  const GroundForce force{-0.06, 0.0};
  Pose2 at = FromDockingCoords({6.0, 0.0, 0.0});
  filter->Correct(TrueFix(at, X_DB));
  for (int leg = 0; leg < 3; ++leg) {
    for (int i = 0; i < 140; ++i) {
      at = Advance(at, Arc{0.01, 0.0}) * Pose2{0.0, 0.01 * true_slip * force.slope, 0.0};
      filter->Predict({0.01, 0.0}, 0.2, force);
    }
    filter->Correct(TrueFix(at, X_DB));
  }
  return filter->slip();
}

TEST_F(Filter, LearnsTheSideSlipFromWhereSightingsFindIt) {
  for (const double true_slip : {0.5, 1.0, 1.6}) {
    PoseFilter filter{noise_, tether_, nominal_.X_DB};
    const WheelSlip learned = LearnedFrom(&filter, nominal_.X_DB, true_slip);
    // Most of the way from what is assumed.
    const double assumed = noise_.slip.slope;
    EXPECT_THAT(learned.slope, DoubleNear(true_slip, 0.4 * std::abs(true_slip - assumed) + 0.02));
    EXPECT_THAT(learned.tether, DoubleNear(noise_.slip.tether, 1e-9));
  }
}

TEST_F(Filter, DriftsByTheSideForceAndTheLean) {
  filter_.Correct(TrueFix(start_, nominal_.X_DB));
  filter_.Predict({1.0, 0.0, 0.01}, 20.0, {-0.05, 0.02});
  const double left_m = -0.05 * noise_.slip.slope + 0.02 * noise_.slip.tether + 0.01;
  const Pose2 moved = Inverse(start_) * filter_.pose();
  EXPECT_THAT(moved.x, DoubleNear(1.0, 1e-6));
  EXPECT_THAT(moved.y, DoubleNear(left_m, 1e-6));
}

// Forwards and backwards, downhill and with the tether: the same slip of a shared law.
TEST_F(Filter, LearnsTheSlipAheadFromWhereSightingsFindIt) {
  const WheelSlip truth{.rolling = 0.15, .ahead = 1.7};
  PoseFilter filter{FilterNoise{}, tether_, nominal_.X_DB};
  Pose2 at = FromDockingCoords({5.0, 0.0, 0.0});
  filter.Correct(TrueFix(at, nominal_.X_DB));
  double last_error_m = 0.0;
  for (int leg = 0; leg < 8; ++leg) {
    const GroundForce force{0.0, 0.0, leg % 4 < 2 ? 0.15 : -0.05};
    const double rolled_m = leg % 2 == 0 ? 0.01 : -0.01;
    for (int i = 0; i < 150; ++i) {
      at = Advance(at, Arc{truth.Way(rolled_m, force), 0.0});
      filter.Predict({rolled_m, 0.0}, 0.2, force);
    }
    last_error_m = filter.pose().x - at.x;
    BoardFix fix = TrueFix(at, nominal_.X_DB);
    fix.variance = {1e-4, 1e-6, 1e-5};
    filter.Correct(fix);
  }
  EXPECT_THAT(filter.slip().rolling, DoubleNear(truth.rolling, 0.015));
  EXPECT_THAT(filter.slip().ahead, DoubleNear(truth.ahead, 0.2));
  EXPECT_THAT(last_error_m, DoubleNear(0.0, 0.03));  // of 1.5 m, 0.34 m by the wheels
}

TEST_F(Filter, FreeWheelsDoNotSlipAhead) {
  PoseFilter filter{FilterNoise{}, tether_, nominal_.X_DB};
  filter.Correct(TrueFix(start_, nominal_.X_DB));
  filter.Predict({1.0, 0.0}, 20.0, {0.0, 0.0, 0.3}, true);
  EXPECT_THAT((Inverse(start_) * filter.pose()).x, DoubleNear(1.0, 1e-9));
}

// Facing the station on its axis, the left is -y of D. A tether from straight ahead has no share
// across the arm.
TEST_F(Filter, SideForcesPushDownhillAndTowardsTheMouth) {
  ImuSample imu;
  imu.roll_rad = 0.1;  // left side up
  const GroundForce on_axis = GroundForceOn(imu, {}, tether_, {3.0, 0.0, kPi}, 40.0, 400.0);
  EXPECT_THAT(on_axis.slope, DoubleNear(-std::sin(0.1), 1e-12));
  EXPECT_THAT(on_axis.tether, DoubleNear(0.0, 1e-12));
  EXPECT_THAT(on_axis.ahead, DoubleNear(0.1, 1e-12));  // the whole tension, on level ground
  // The mouth lies 45 deg to the right of the arm.
  const double to_mouth = std::atan2(-1.0, tether_.p_DQ.x() - 2.0);
  const Pose2 aside = {2.0 - std::cos(to_mouth + 0.25 * kPi), 1.0 - std::sin(to_mouth + 0.25 * kPi),
                       WrapPi(to_mouth + 0.25 * kPi)};
  EXPECT_THAT(GroundForceOn(imu, {}, tether_, aside, 40.0, 400.0).tether,
              DoubleNear(-0.1 * std::sqrt(0.5), 1e-9));
}

// From 6 m to 1.8 m on the axis with a drum that takes up another length than it is told to. Wheels
// slip, so between sightings the tether alone tells of the way.
TEST_F(Filter, LearnsTheDrumsRadiusFromSightings) {
  for (const double scale : {0.96, 1.0, 1.04}) {
    PoseFilter filter{noise_, tether_, nominal_.X_DB};
    Pose2 at = FromDockingCoords({6.0, 0.0, 0.0});
    const double whole_m = ExposedTether(tether_, at, 0.0);
    const auto reeled_m = [&] { return (whole_m - ExposedTether(tether_, at, 0.0)) / scale; };
    filter.Correct(TrueFix(at, nominal_.X_DB));
    filter.CorrectByTether(0.0, 0.0);
    double last_error_m = 0.0;
    for (int leg = 0; leg < 6; ++leg) {
      for (int i = 0; i < 70; ++i) {
        at = Advance(at, Arc{0.01, 0.0});
        filter.Predict({0.0108, 0.0}, 0.2);
        if (i % 2 == 0) filter.CorrectByTether(reeled_m(), 0.0);
      }
      last_error_m = filter.pose().x - at.x;
      BoardFix fix = TrueFix(at, nominal_.X_DB);
      fix.variance = {1e-4, 1e-6, 1e-5};
      filter.Correct(fix);
    }
    EXPECT_THAT(filter.drum_scale(), DoubleNear(scale, 0.01));
    EXPECT_THAT(last_error_m, DoubleNear(0.0, 0.025));  // of 5.6 cm by the wheels
  }
}

// Board 3 m ahead and 4 m to the left: range error lies along (0.6, 0.8).
TEST_F(Filter, TakesTheVariancesOfASightingAlongAndAcrossItsView) {
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::Vector2d along(0.6, 0.8), across(-0.8, 0.6);
  covariance.topLeftCorner<2, 2>() =
      4e-4 * along * along.transpose() + 25e-6 * across * across.transpose();
  covariance(5, 5) = 9e-4;
  const Eigen::Vector3d variance = FixVariance({3.0, 4.0, 0.2}, covariance);
  EXPECT_THAT(variance.x(), DoubleNear(4e-4, 1e-12));
  EXPECT_THAT(variance.y(), DoubleNear(1e-6, 1e-12));
  EXPECT_THAT(variance.z(), DoubleNear(9e-4, 1e-12));
}

}  // namespace
}  // namespace dockyard::axel
