#include "controller/rocky7/touch_place.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

// A ball whose point with that normal is the target.
struct BallAhead {
  double radius_m = 0.12;
  FaceAt face;

  BallAhead(double x_m, double up_deg) {
    face.p_RT = {x_m, 0.05, 0.3};
    face.normal_R = {-std::cos(Radians(up_deg)), 0.0, std::sin(Radians(up_deg))};
    face.bend_R =
        (Eigen::Matrix3d::Identity() - face.normal_R * face.normal_R.transpose()) / radius_m;
  }
  Eigen::Vector3d NormalAt(const Eigen::Vector3d& p_R) const {
    return (p_R - (face.p_RT - radius_m * face.normal_R)).normalized();
  }
};

// The tool's error against the ball's own normal, in closed form.
TEST(TouchPlace, OnABallTheToolIsNearerToTheNormalThanAtTheTarget) {
  const NominalMast mast = NominalRover().mast;
  int tried = 0;
  for (const double x_m : {0.84, 0.88, 0.92, 0.95}) {
    const BallAhead ball(x_m, 25.0);
    const double at_target_rad = ToolOff(mast, ball.face);
    ASSERT_LT(at_target_rad, kPi);
    const TouchPlace touch = PlaceToTouch(mast, ball.face);
    const Eigen::Vector3d& p = touch.face.p_RT;
    EXPECT_LE((p - ball.face.p_RT).norm(), 0.0102);
    const Eigen::Vector3d middle = ball.face.p_RT - ball.radius_m * ball.face.normal_R;
    EXPECT_NEAR((p - middle).norm(), ball.radius_m, 1e-4);
    const double off_rad = ToolOff(mast, {p, ball.NormalAt(p)});
    EXPECT_NEAR(off_rad, touch.off_rad, Radians(0.3));
    if (at_target_rad < Radians(2.0)) continue;
    EXPECT_LT(off_rad, 0.6 * at_target_rad) << x_m;
    ++tried;
  }
  EXPECT_GE(tried, 2);
}

TEST(TouchPlace, OfAFlatFaceItIsTheTarget) {
  BallAhead flat(0.9, 25.0);
  flat.face.bend_R.setZero();
  const NominalMast mast = NominalRover().mast;
  const TouchPlace touch = PlaceToTouch(mast, flat.face);
  EXPECT_EQ(touch.face.p_RT, flat.face.p_RT);
  EXPECT_EQ(touch.off_rad, ToolOff(mast, flat.face));
}

// Where the mast is stretched out it ends before a surface that is a centimetre further.
TEST(TouchPlace, IsNotWhereTheMastEnds) {
  const NominalMast mast = NominalRover().mast;
  BallAhead far(1.0, 0.0);
  far.face.bend_R.setZero();
  far.face.p_RT = {mast.p_RM.x() + mast.link1_m + mast.link2_m - 0.005, 0.0, mast.p_RM.z()};
  ASSERT_LT(ToolOff(mast, far.face), kPi);
  EXPECT_EQ(PlaceToTouch(mast, far.face).off_rad, kPi);
}

}  // namespace
}  // namespace dockyard::rocky7
