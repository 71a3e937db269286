#include "controller/axel/ground_slope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/odometry.h"
#include "controller/axel/pose_filter.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {
namespace {

using testing::DoubleNear;

constexpr double kSharp = Radians(0.2);  // error of a near sighting

// A rover and a station on one plane that falls by slope_rad towards way_rad in D.
class OnSlope : public testing::TestWithParam<double> {
 protected:
  Eigen::Vector3d Up() const {
    return {std::sin(slope_rad_) * std::cos(way_rad_), std::sin(slope_rad_) * std::sin(way_rad_),
            std::cos(slope_rad_)};
  }
  Pose3 InDock(const Pose2& at, const Attitude& body) const {
    Pose3 X_DR = FromGround(at, 0.3);
    X_DR.R = X_DR.R * Tilt(body);
    return X_DR;
  }
  // Computed from the world's rotation, with any yaw of the yard in the world.
  ImuSample ImuAt(const Pose3& X_DR) const {
    const Eigen::Matrix3d R_WD = RotZ(0.7) * RotationBetween(Up(), Eigen::Vector3d::UnitZ());
    const RollPitchYaw turned = ToRollPitchYaw(R_WD * X_DR.R);
    ImuSample imu;
    imu.roll_rad = turned.roll;
    imu.pitch_rad = turned.pitch;
    imu.yaw_rad = turned.yaw;
    return imu;
  }
  GroundSlope Learned(const Pose3& X_DR) const {
    GroundSlope ground;
    ground.Take(Inverse(X_DR) * nominal_.X_DB, kSharp, ImuAt(X_DR), nominal_.X_DB);
    return ground;
  }

  const double slope_rad_ = Radians(18.0), way_rad_ = GetParam();
  const Nominal nominal_ = TestNominal();
  const Pose2 at_{3.0, 0.4, Radians(160.0)};
  const Attitude body_{0.0, Radians(-7.0)};
};

TEST_P(OnSlope, OneSharpSightingTeachesIt) {
  const GroundSlope ground = Learned(InDock(at_, body_));
  EXPECT_FALSE(ground.level());
  EXPECT_LT((ground.up_D() - Up()).norm(), 1e-9);
}

// D's x points out of the cone. Downhill of it the weight pulls the rover out.
TEST_P(OnSlope, SeatIsHeldAgainstTheWeight) {
  const AxelOptions options{};
  Senses senses(nominal_, options);
  senses.SetGround(Learned(InDock(at_, body_)));
  const double out_n = -390.0 * Up().x();
  EXPECT_NEAR(SeatTension(options, senses), 100.0 + std::max(0.0, out_n), 1e-6);
}

TEST_P(OnSlope, AttitudeAgainstTheGroundIsWhatTheRoverHas) {
  const GroundSlope ground = Learned(InDock(at_, body_));
  for (double heading_deg = -180.0; heading_deg < 180.0; heading_deg += 30.0) {
    for (double pitch_deg : {12.0, 90.0, -150.0}) {  // upright, on end, nearly upside down
      const Attitude body{Radians(2.0), Radians(pitch_deg)};
      const Pose2 at{2.0, -0.5, Radians(heading_deg)};
      const Attitude found = ground.Against(ImuAt(InDock(at, body)), at.heading);
      EXPECT_THAT(found.roll_rad, DoubleNear(body.roll_rad, 1e-9)) << heading_deg;
      EXPECT_THAT(found.pitch_rad, DoubleNear(body.pitch_rad, 1e-9)) << heading_deg;
    }
  }
}

TEST_P(OnSlope, SightingGivesThePoseOnThePlane) {
  const Pose3 X_DR = InDock(at_, body_);
  const Pose3 X_RB = Inverse(X_DR) * nominal_.X_DB;
  const Pose2 found =
      PoseOf(LevelSighting(X_RB, ImuAt(X_DR), nominal_.X_DB, Learned(X_DR)), nominal_.X_DB);
  EXPECT_THAT(found.x, DoubleNear(at_.x, 1e-9));
  EXPECT_THAT(found.y, DoubleNear(at_.y, 1e-9));
  EXPECT_THAT(WrapPi(found.heading - at_.heading), DoubleNear(0.0, 1e-9));
}

// About the vertical, the same turn is up to 2.9 % more or less.
TEST_P(OnSlope, OdometryTurnsAboutThePlanesNormal) {
  const GroundSlope ground = Learned(InDock(at_, body_));
  Odometer odometer(nominal_);
  SensorFrame frame = StillFrame();
  double heading = at_.heading;
  frame.imu = ImuAt(InDock({3.0, 0.4, heading}, body_));
  odometer.Read(frame, ground, heading);
  for (int i = 0; i < 12; ++i) {
    frame.imu = ImuAt(InDock({3.0, 0.4, heading + 0.25}, body_));
    const Motion motion = odometer.Read(frame, ground, heading);
    EXPECT_THAT(motion.turn_rad, DoubleNear(0.25, 1e-9));
    EXPECT_THAT(motion.length_m, DoubleNear(0.0, 1e-9));  // its body does not pitch on the plane
    heading = WrapPi(heading + 0.25);
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, OnSlope,
                         testing::Values(0.0, Radians(90.0), Radians(180.0), Radians(-50.0)));

TEST(LevelGround, StaysLevelUnderTheNoiseOfSightings) {
  const Nominal nominal = TestNominal();
  for (double error_deg : {-2.5, 2.5}) {
    GroundSlope ground;
    Pose3 X_DR = FromGround({4.0, 0.0, kPi}, 0.3);
    Pose3 X_RB = Inverse(X_DR) * nominal.X_DB;
    X_RB.R = X_RB.R * RotX(Radians(error_deg));
    for (int i = 0; i < 20; ++i) ground.Take(X_RB, Radians(2.0), ImuSample{}, nominal.X_DB);
    EXPECT_TRUE(ground.level()) << error_deg;
  }
}

TEST(LevelGround, HasTheInertialUnitsAttitudeAboutTheAxleAtAnyPitch) {
  for (double pitch_deg = -175.0; pitch_deg < 180.0; pitch_deg += 35.0) {
    const Attitude body{0.1, Radians(pitch_deg)};
    const RollPitchYaw turned = ToRollPitchYaw(RotZ(0.7) * Tilt(body));
    ImuSample imu;
    imu.roll_rad = turned.roll;
    imu.pitch_rad = turned.pitch;
    imu.yaw_rad = turned.yaw;
    const Attitude found = GroundSlope{}.Against(imu, 1.2);
    EXPECT_THAT(found.roll_rad, DoubleNear(0.1, 1e-12)) << pitch_deg;
    EXPECT_THAT(found.pitch_rad, DoubleNear(body.pitch_rad, 1e-12)) << pitch_deg;
    EXPECT_THAT(HeadingOf(imu), DoubleNear(0.7, 1e-12)) << pitch_deg;
  }
}

TEST(UpOfStation, TakesAStrongRollAsTheSlopesUntilItIsKnown) {
  const Attitude rolled{Radians(15.0), Radians(5.0)};
  const Eigen::Vector3d axle = Eigen::Vector3d::UnitY();
  EXPECT_THAT(UpOfStation(rolled, false).dot(axle), DoubleNear(0.0, 1e-12));
  EXPECT_THAT(UpOfStation(rolled, true).dot(axle), DoubleNear(std::sin(Radians(15.0)), 1e-12));
  // A wheel on a stone of 3 cm rolls it by 2 deg: gravity is the better guess.
  const Attitude on_a_stone{Radians(2.0), 0.0};
  EXPECT_THAT(UpOfStation(on_a_stone, false).dot(axle), DoubleNear(std::sin(Radians(2.0)), 1e-12));
}

}  // namespace
}  // namespace dockyard::axel
