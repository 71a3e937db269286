#include "controller/tracking/whole_shape.h"

#include <gtest/gtest.h>

#include "tracking/height_scene.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr double kSigma_m = 1.5e-3;  // a cell's, by stereo at 0.6 m

class ByWholeShape : public ::testing::Test {
 protected:
  // The target, seen from the start, looked for from X_WE with a prediction that is off.
  TrackedShape Track(const HeightScene& before, const HeightScene& after, const Vector2d& p_WT,
                     const Pose2& X_WE, const Pose2& off) {
    const HeightPatch shape =
        ShapeAbout(before.Map({}, kSigma_m, random_), {p_WT.x(), p_WT.y(), 0.0}, {});
    const Pose2 X_ET = Inverse(X_WE) * Pose2{p_WT.x(), p_WT.y(), 0.0};
    const Pose2 predicted{X_ET.x + off.x, X_ET.y + off.y, WrapPi(X_ET.heading + off.heading)};
    TrackedShape found = FindShape(shape, after.Map(X_WE, kSigma_m, random_), predicted, {});
    error_m_ = std::hypot(found.X_ET.x - X_ET.x, found.X_ET.y - X_ET.y);
    return found;
  }

  RandomStream random_{StreamKey(1, "whole shape")};
  double error_m_ = 0.0;
  const HeightScene field_{
      {{{0.8, 0.1}, 0.03, 0.03}, {{0.87, 0.12}, 0.02, 0.025}, {{0.75, 0.04}, 0.015, 0.012}}};
};

TEST_F(ByWholeShape, FindsAStoneWithinMillimetresThoughOdometryIsOff) {
  for (int i = 0; i < 20; ++i) {
    const Pose2 X_WE{random_.Uniform(0, 0.15), random_.Uniform(-0.05, 0.05),
                     random_.Uniform(-0.1, 0.1)};
    const Pose2 off{random_.Uniform(-0.05, 0.05), random_.Uniform(-0.05, 0.05),
                    random_.Uniform(-0.08, 0.08)};
    const TrackedShape found = Track(field_, field_, {0.8, 0.1}, X_WE, off);
    EXPECT_EQ(found.verdict, TrackVerdict::kFound);
    EXPECT_LT(error_m_, 3e-3);
    EXPECT_LT(found.misfit, 1.5);
  }
}

// Where the highest cell is another stone's, or the border uphill.
TEST_F(ByWholeShape, StaysOnASmallStoneBesideATallOneAndOnASlope) {
  EXPECT_EQ(Track(field_, field_, {0.75, 0.04}, {0.1, 0.02, 0.05}, {0.02, -0.02, 0.03}).verdict,
            TrackVerdict::kFound);
  EXPECT_LT(error_m_, 4e-3);
  HeightScene slope = field_;
  slope.slope_x = std::tan(Radians(10.0));
  EXPECT_EQ(Track(slope, slope, {0.8, 0.1}, {0.1, 0.0, 0.0}, {0.03, 0.03, 0.0}).verdict,
            TrackVerdict::kFound);
  EXPECT_LT(error_m_, 3e-3);
}

// A point on a stone's face is a place of the shape like any other.
TEST_F(ByWholeShape, FollowsATargetOnAFace) {
  EXPECT_EQ(Track(field_, field_, {0.785, 0.09}, {0.1, 0.0, 0.05}, {0.03, 0.0, 0.0}).verdict,
            TrackVerdict::kFound);
  EXPECT_LT(error_m_, 3e-3);
}

TEST_F(ByWholeShape, SaysThatTheTargetIsGone) {
  HeightScene without = field_;
  without.stones.erase(without.stones.begin());
  for (int i = 0; i < 20; ++i) {
    const Pose2 X_WE{random_.Uniform(0, 0.15), random_.Uniform(-0.05, 0.05),
                     random_.Uniform(-0.1, 0.1)};
    const TrackVerdict verdict = Track(field_, without, {0.8, 0.1}, X_WE, {}).verdict;
    EXPECT_TRUE(verdict == TrackVerdict::kMisfit || verdict == TrackVerdict::kAmbiguous);
  }
}

TEST_F(ByWholeShape, SaysThatBareGroundHasNoShape) {
  EXPECT_EQ(Track({}, {}, {0.8, 0.1}, {0.1, 0.0, 0.0}, {}).verdict, TrackVerdict::kFlat);
}

TEST_F(ByWholeShape, SaysThatTwoStonesAreAlike) {
  // Alike and alone: nothing about them tells which is which.
  const HeightScene one{{{{0.8, 0.1}, 0.02, 0.02}}};
  const HeightScene other{{{{0.84, 0.1}, 0.02, 0.02}, {{0.76, 0.1}, 0.02, 0.02}}};
  const TrackVerdict verdict = Track(one, other, {0.8, 0.1}, {}, {}).verdict;
  EXPECT_TRUE(verdict == TrackVerdict::kAmbiguous || verdict == TrackVerdict::kMisfit);
}

TEST_F(ByWholeShape, SaysThatTooLittleIsSeen) {
  const HeightPatch shape = ShapeAbout(field_.Map({}, kSigma_m, random_), {0.8, 0.1, 0.0}, {});
  ElevationMap map = field_.Map({}, kSigma_m, random_);
  Hide(map, {0.8, 0.1}, 0.14);
  EXPECT_EQ(FindShape(shape, map, {0.8, 0.1, 0.0}, {}).verdict, TrackVerdict::kUnseen);
}

}  // namespace
}  // namespace dockyard
