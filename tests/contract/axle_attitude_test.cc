#include "controller/geometry/axle_attitude.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

TEST(AxleAttitude, ComposesToTheRotationThatItCameFrom) {
  for (double roll : {-1.4, -0.3, 0.0, 0.9}) {
    for (double pitch = -3.1; pitch < 3.14; pitch += 0.31) {
      for (double heading : {-3.0, -0.4, 0.0, 2.2}) {
        const Eigen::Matrix3d R = ToRotation(AxleAttitude{roll, pitch, heading});
        const AxleAttitude found = ToAxleAttitude(R);
        EXPECT_NEAR(found.roll, roll, 1e-12);
        EXPECT_NEAR(found.pitch, pitch, 1e-12);
        EXPECT_NEAR(found.heading, heading, 1e-12);
        EXPECT_LT((ToRotation(found) - R).cwiseAbs().maxCoeff(), 1e-14);
      }
    }
  }
}

// Roll, pitch and yaw about moving axes jump there: a body on end has no yaw of its own.
TEST(AxleAttitude, HeadingAndRollStayAsTheBodyTurnsOver) {
  for (double pitch_deg = 0.0; pitch_deg <= 360.0; pitch_deg += 1.0) {
    const Eigen::Matrix3d R = RotZ(0.7) * RotX(0.05) * RotY(Radians(pitch_deg));
    EXPECT_NEAR(ToAxleAttitude(R).heading, 0.7, 1e-12) << pitch_deg;
    EXPECT_NEAR(ToAxleAttitude(R).roll, 0.05, 1e-12) << pitch_deg;
    EXPECT_NEAR(AxleOnGround({R, {1.0, 2.0, 3.0}}).heading, 0.7, 1e-12) << pitch_deg;
  }
}

TEST(AxleAttitude, OfAnUprightBodyIsItsPlaceOnTheGround) {
  const Pose3 X_AB = FromGround({1.0, -2.0, 2.5}, 0.3);
  EXPECT_EQ(AxleOnGround(X_AB).x, 1.0);
  EXPECT_EQ(AxleOnGround(X_AB).y, -2.0);
  EXPECT_NEAR(AxleOnGround(X_AB).heading, ToGround(X_AB).heading, 1e-15);
}

}  // namespace
}  // namespace dockyard
