#include "controller/rocky7/mast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "controller/rocky7/place_plan.h"
#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

NominalMast Mast() {
  NominalMast mast = NominalRover().mast;
  mast.link1_m = 0.45;  // unequal, so that they are not taken for one another
  mast.link2_m = 0.55;
  return mast;
}

// In the mast's plane, by sines and cosines of absolute angles.
TEST(Mast, FaceLiesWhereTheLinksLeadByPlaneTrigonometry) {
  const NominalMast mast = Mast();
  const double roll = 0.4, shoulder = -1.1, elbow = 1.7;
  const double out = 0.45 * std::cos(shoulder) + 0.55 * std::cos(shoulder + elbow);
  const double up = -0.45 * std::sin(shoulder) - 0.55 * std::sin(shoulder + elbow);
  const Eigen::Vector3d p = FaceCentre(mast, {roll, shoulder, elbow});
  EXPECT_NEAR(p.x(), 0.05 + out * std::cos(roll), 1e-12);
  EXPECT_NEAR(p.y(), out * std::sin(roll), 1e-12);
  EXPECT_NEAR(p.z(), 0.28 + up, 1e-12);
  const Eigen::Vector3d tool = SecondLink(mast, {roll, shoulder, elbow}).R.col(0);
  EXPECT_NEAR(std::asin(tool.z()), -(shoulder + elbow), 1e-12);
}

TEST(Mast, StretchedOutPointsStraightAheadAndLevel) {
  EXPECT_LT((FaceCentre(Mast(), {0, 0, 0}) - Eigen::Vector3d(1.05, 0.0, 0.28)).norm(), 1e-12);
}

TEST(Mast, AnglesToAPointBringTheFaceThereWithTheElbowUp) {
  const NominalMast mast = Mast();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> roll(-2.5, 2.5), shoulder(-2.5, 0.0), elbow(0.1, 2.8);
  for (int i = 0; i < 2000; ++i) {
    const MastAngles angles{roll(random), shoulder(random), elbow(random)};
    const Eigen::Vector3d p = FaceCentre(mast, angles);
    // Beyond the shoulder the roll would be the opposite.
    const Eigen::Vector2d out = RotZ(-angles[0]).topLeftCorner<2, 2>() * (p - mast.p_RM).head<2>();
    if (out.x() < 0.01) continue;
    const auto found = AnglesTo(mast, p);
    ASSERT_TRUE(found);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR((*found)[k], angles[k], 1e-9);
  }
}

TEST(Mast, RefusesPointsOutOfReachAndBelowTheShouldersLimit) {
  const NominalMast mast = Mast();
  EXPECT_FALSE(AnglesTo(mast, {1.2, 0.0, 0.28}));
  // So far below that the first link would have to point down.
  EXPECT_FALSE(AnglesTo(mast, {0.5, 0.0, -0.55}));
  EXPECT_TRUE(AnglesTo(mast, {0.9, 0.0, 0.2}));
}

TEST(Mast, WatchingBringsThePointBetweenTheCamerasAxesHoweverItLeans) {
  const NominalMast mast = Mast();
  const Eigen::Vector2d middle_px = mast.pair_K.left.centre_px();
  for (const double lean : {0.0, Radians(-20.0), Radians(20.0)}) {
    for (const Eigen::Vector3d& p :
         {Eigen::Vector3d(6.0, 1.0, 0.4), {1.0, -0.4, 0.3}, {0.8, 0.5, 0.1}}) {
      const MastAngles angles = AnglesToWatch(mast, p, lean);
      EXPECT_DOUBLE_EQ(angles[1], mast.watch_rad[1] + lean);
      const Pose3 X_RK = SecondLink(mast, angles);
      const auto left = mast.pair_K.left.Project(Inverse(X_RK * mast.pair_K.X_RL) * p);
      const auto right = mast.pair_K.right.Project(Inverse(X_RK * mast.pair_K.X_RQ) * p);
      ASSERT_TRUE(left && right);
      EXPECT_NEAR(left->x() + right->x(), 2.0 * middle_px.x(), 0.1);
      EXPECT_NEAR(left->y(), middle_px.y(), 0.1);
    }
  }
}

// rocky7.md, 4.5: sin a = (z - z0 - l2 sin b) / l1, stand-off = l1 cos a + l2 cos b.
TEST(Mast, StanceIsThePapersClosedForm) {
  const NominalMast mast = Mast();
  const double up_m = 0.1, tool_up = Radians(-30.0);
  const auto stance = StanceFor(mast, up_m, tool_up, 0.0);
  ASSERT_TRUE(stance);
  const double a = std::asin((0.1 + 0.55 * 0.5) / 0.45);
  EXPECT_NEAR(stance->first_up_rad, a, 1e-12);
  EXPECT_NEAR(stance->stand_off_m, 0.45 * std::cos(a) + 0.55 * std::cos(tool_up), 1e-12);
  EXPECT_EQ(stance->off_rad, 0.0);
}

TEST(Mast, AtItsStanceTheToolMeetsTheFaceAlongItsNormal) {
  const Nominal nominal = NominalRover();
  for (const double up_deg : {10.0, 30.0, 50.0}) {
    for (const double aside_deg : {-40.0, 0.0, 25.0}) {
      const FaceAt face{{2.0, 0.3, 0.33},
                        RotZ(Radians(aside_deg)) * Eigen::Vector3d(-std::cos(Radians(up_deg)), 0.0,
                                                                   std::sin(Radians(up_deg)))};
      const auto goal = GoalFor(nominal, face, 0.0);
      ASSERT_TRUE(goal);
      EXPECT_EQ(goal->stance.off_rad, 0.0) << up_deg;
      EXPECT_NEAR(goal->X_RG.heading, Radians(aside_deg), 1e-12);
      EXPECT_LT(ToolOff(nominal.mast, SeenFrom(goal->X_RG, face)), 1e-9);
    }
  }
}

TEST(Mast, GivesTheNearestTiltWhereTheFirstLinkWouldPointDown) {
  const NominalMast mast = NominalRover().mast;
  // A vertical face 15 cm below the shoulder: level at most, so the tool points down by asin(0.3)
  // and a little, for the links must not be stretched out.
  const auto stance = StanceFor(mast, -0.15, 0.0, 0.0);
  ASSERT_TRUE(stance);
  EXPECT_NEAR(Degrees(stance->tool_up_rad), -17.5, 0.1);
  EXPECT_NEAR(stance->off_rad, stance->tool_up_rad, 1e-12);
  EXPECT_GE(stance->first_up_rad, 0.0);
}

TEST(Mast, KeepsTheStandOffThatTheWheelsNeed) {
  const NominalMast mast = NominalRover().mast;
  const auto free = StanceFor(mast, 0.0, Radians(-60.0), 0.0);
  ASSERT_TRUE(free);
  EXPECT_LT(free->stand_off_m, 0.6);
  const auto kept = StanceFor(mast, 0.0, Radians(-60.0), 0.7);
  ASSERT_TRUE(kept);
  EXPECT_GE(kept->stand_off_m, 0.7);
  EXPECT_LT(kept->stand_off_m, 0.703);
  EXPECT_GT(kept->off_rad, 0.0);
}

}  // namespace
}  // namespace dockyard::rocky7
