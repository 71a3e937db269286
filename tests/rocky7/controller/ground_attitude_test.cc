#include "controller/rocky7/ground_attitude.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard::rocky7 {
namespace {

// Attitude of a body that is parallel to a plane, at a heading: roll and pitch of its normal.
ImuSample On(const Eigen::Vector3d& normal_W, double yaw_rad) {
  const Eigen::Vector3d n = RotZ(yaw_rad).transpose() * normal_W;
  ImuSample sample;
  sample.yaw_rad = yaw_rad;
  sample.pitch_rad = std::atan2(n.x(), n.z());
  sample.roll_rad = -std::asin(n.y());
  return sample;
}

Eigen::Vector3d Slope(double rise) { return Eigen::Vector3d(-rise, 0.0, 1.0).normalized(); }

TEST(GroundPlane, IsTheBodysOwnAtFirstWhateverTheHeading) {
  for (const double yaw_rad : {0.0, 1.0, -2.5}) {
    GroundPlane ground;
    const ImuSample now = On(Slope(0.15), yaw_rad);
    ground.Add(now, 0.0);
    const Eigen::Vector2d rise = 0.15 * Eigen::Vector2d(std::cos(yaw_rad), -std::sin(yaw_rad));
    EXPECT_LT((ground.Rise(now) - rise).norm(), 2e-3) << yaw_rad;
    EXPECT_NEAR(ground.Parallel(now).pitch_rad, now.pitch_rad, 1e-12);
    EXPECT_NEAR(ground.Parallel(now).roll_rad, now.roll_rad, 1e-12);
  }
}

// A slope that was learnt at one heading holds at another; stones under a wheel tilt the body by
// 3 deg now and then.
TEST(GroundPlane, HoldsWhileTheRoverTurnsAndTiltsOverStones) {
  GroundPlane ground;
  for (int i = 0; i < 40; ++i) {
    ImuSample now = On(Slope(0.12), 0.05 * i);
    now.roll_rad += Radians(3.0) * std::sin(2.1 * i);
    now.pitch_rad += Radians(3.0) * std::cos(1.7 * i);
    ground.Add(now, 0.1);
  }
  const ImuSample turned = On(Slope(0.12), -1.2);
  EXPECT_NEAR(ground.Parallel(turned).pitch_rad, turned.pitch_rad, Radians(0.7));
  EXPECT_NEAR(ground.Parallel(turned).roll_rad, turned.roll_rad, Radians(0.7));
}

}  // namespace
}  // namespace dockyard::rocky7
