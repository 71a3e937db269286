#include "controller/rocky7/ground_perception.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/nominal_rover.h"
#include "stereo/ray_scene.h"

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector2d;

const ImuSample kTilted{.roll_rad = 0.06, .pitch_rad = -0.04};

TEST(FrontPixel, ShowsThePlaceOfLevelGround) {
  const Nominal nominal = NominalRover();
  const Vector2d p_E(0.8, 0.15);
  const auto pixel = FrontPixel(nominal, kTilted, p_E);
  ASSERT_TRUE(pixel);
  // Back along the ray, in E.
  const Eigen::Matrix3d R_ER = RotY(-0.04) * RotX(0.06);
  const Eigen::Vector3d from = R_ER * nominal.front.X_RL.p;
  const Eigen::Vector3d along = R_ER * nominal.front.X_RL.R * nominal.front.left.Direction(*pixel);
  const double share = (-nominal.rolling_radius_m - from.z()) / along.z();
  EXPECT_LT(((from + share * along).head<2>() - p_E).norm(), 1e-6);
}

TEST(GroundReport, HasTheTargetInTheTiltedBodyAndItsPixel) {
  const Nominal nominal = NominalRover();
  const TargetSighting sighting{.found = true, .p_E = {0.8, 0.15}, .height_m = 0.0};
  const SightingReport report = ReportOf(sighting, nominal, kTilted);
  EXPECT_TRUE(report.accepted);
  const Eigen::Matrix3d R_ER = RotY(-0.04) * RotX(0.06);
  EXPECT_LT((R_ER * report.X_RB.p - Eigen::Vector3d(0.8, 0.15, -0.07)).norm(), 1e-12);
  ASSERT_EQ(report.marks.size(), 1u);
  const auto pixel = FrontPixel(nominal, kTilted, {0.8, 0.15});
  EXPECT_NEAR(report.marks[0].u_px, pixel->x(), 1e-9);
  EXPECT_NEAR(report.marks[0].v_px, pixel->y(), 1e-9);
}

TEST(GroundReport, OfAMissHasItsReasonAndNoMark) {
  const SightingReport report = ReportOf({.why = "nothing there"}, NominalRover(), {});
  EXPECT_FALSE(report.accepted);
  EXPECT_EQ(report.reason, "nothing there");
  EXPECT_TRUE(report.marks.empty());
}

// A shift of the frame and back is none.
TEST(OdometryTarget, ComesBackFromAnotherFrame) {
  OdometryTarget target{.p_RT = {1.0, 0.2}, .turned_rad = 0.1, .driven_m = 0.5};
  target.spread_m2 << 4e-4, 1e-4, 1e-4, 2e-4;
  const Pose2 X_NR{0.3, -0.1, 0.4};
  const OdometryTarget there = InFrame(target, X_NR, -0.4);
  EXPECT_NEAR(there.spread_m2.trace(), target.spread_m2.trace(), 1e-15);
  EXPECT_NEAR(there.spread_m2.determinant(), target.spread_m2.determinant(), 1e-18);
  const OdometryTarget back = InFrame(there, Inverse(X_NR), 0.4);
  EXPECT_LT((back.p_RT - target.p_RT).norm(), 1e-12);
  EXPECT_LT((back.spread_m2 - target.spread_m2).norm(), 1e-15);
  EXPECT_NEAR(back.turned_rad, 0.1, 1e-15);
}

// A tracker that finds what the test puts where it was asked to.
struct Recorder final : TargetTracker {
  std::vector<Vector2d>* asked;
  bool finds = true;
  explicit Recorder(std::vector<Vector2d>* where) : asked(where) {}
  TargetSighting Begin(const GroundMaps&, const Clicked& clicked) override {
    asked->push_back(clicked.p_E);
    return {.found = finds, .p_E = clicked.p_E};
  }
  TargetSighting Follow(const GroundMaps&, const Predicted& target) override {
    asked->push_back({target.X_ET.x, target.X_ET.y});
    return {.found = finds, .p_E = asked->back()};
  }
};

StereoImages GroundFrom(const Nominal& nominal) {
  const Pose3 X_up = Pose3::Translation(0.0, 0.0, nominal.rolling_radius_m);
  StereoRig rig = nominal.front;
  rig.X_RL = X_up * rig.X_RL;
  rig.X_RQ = X_up * rig.X_RQ;
  return RayScene{}.Pair(rig);
}

// The first pair has the click's place, later ones what odometry predicts.
TEST(DetectTarget, AsksTheTrackerAtTheClickAndThenAtThePrediction) {
  const Nominal nominal = NominalRover();
  const GroundStereo stereo(nominal);
  const StereoImages images = GroundFrom(nominal);
  const Vector2d p_E(0.8, 0.1);
  std::vector<Vector2d> asked;
  GroundMemory memory{.tracker = std::make_unique<Recorder>(&asked)};
  ExposurePrior prior;
  DetectTarget(stereo, images, prior, *FrontPixel(nominal, {}, p_E), memory);
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_LT((asked[0] - p_E).norm(), 0.01);
  EXPECT_TRUE(memory.begun);
  prior.target.p_RT = {0.6, -0.05};
  const GroundDetection second = DetectTarget(stereo, images, prior, {}, memory);
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[1], prior.target.p_RT);
  EXPECT_FALSE(second.X_BE);
}

}  // namespace
}  // namespace dockyard::rocky7
