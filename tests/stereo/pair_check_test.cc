#include "controller/stereo/pair_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/stereo/match.h"
#include "stereo/ray_scene.h"

namespace dockyard {
namespace {

// Parallel pinholes, so that a pixel of an image is one of the rectified image.
StereoRig ParallelPair() {
  StereoRig rig = BodyPair();
  rig.left.lens = rig.right.lens = BrownPinhole{250.0, 250.0, 159.5, 119.5};
  return rig;
}

double ShareFound(const PairCheck& check) {
  return static_cast<double>(check.found.size()) / check.corners;
}

class CheckedPair : public ::testing::Test {
 protected:
  CheckedPair() : rectifier_(rig_, {.keep_rectified = true}) {
    scene_.grain_m = 0.006;
    images_ = scene_.Pair(rig_);
  }
  PairCheck Check(const StereoImages& images) const { return CheckPair(rectifier_, images); }

  const StereoRig rig_ = ParallelPair();
  RayScene scene_;
  Rectifier rectifier_;
  StereoImages images_;
};

// The ground's disparity in closed form.
TEST_F(CheckedPair, FindsMostCornersOfATruePairWhereTheyAre) {
  const PairCheck check = Check(images_);
  EXPECT_GT(check.corners, 100);
  EXPECT_GT(ShareFound(check), 0.4);
  EXPECT_NEAR(check.lower_px, 0.0, 0.1);
  EXPECT_NEAR(check.across_px, 0.0, 0.3);
  EXPECT_NEAR(check.down_px, 0.0, 0.3);
  const PlaneDisparity truth = DisparityOf(rectifier_.pair(), {});
  std::size_t near = 0;
  for (const FoundCorner& corner : check.found) {
    near += std::abs(corner.disparity_px - truth.At(corner.left.x(), corner.left.y())) < 1.0;
  }
  EXPECT_GT(near, 0.9 * static_cast<double>(check.found.size()));
}

TEST_F(CheckedPair, MeasuresHowManyRowsLowerTheRightImageIs) {
  for (const int rows : {3, -6}) {
    StereoImages shifted = images_;
    for (int v = 0; v < 240; ++v) {
      for (int u = 0; u < 320; ++u) {
        const int from = std::clamp(v - rows, 0, 239);
        shifted.right.pixels[static_cast<std::size_t>(v * 320 + u)] = images_.right.at(u, from);
      }
    }
    EXPECT_NEAR(Check(shifted).lower_px, rows, 0.2);
  }
}

TEST_F(CheckedPair, MeasuresATurnAboutTheView) {
  StereoRig turned = rig_;
  turned.X_RQ.R = turned.X_RQ.R * RotZ(Radians(2.0));
  const PairCheck check = Check(scene_.Pair(turned));
  EXPECT_NEAR(std::abs(Degrees(check.turn_rad)), 2.0, 0.3);
  EXPECT_GT(std::abs(check.across_px), 5.0);
}

TEST_F(CheckedPair, FindsExchangedImagesOnTheWrongSide) {
  const PairCheck check = Check({images_.right, images_.left});
  EXPECT_GT(ShareFound(check), 0.4);
  for (const FoundCorner& corner : check.found) EXPECT_LT(corner.disparity_px, 0.0);
}

TEST_F(CheckedPair, FindsHardlyAnyCornerOfAnotherScene) {
  StereoRig elsewhere = rig_;
  elsewhere.X_RQ.p.x() += 5.0;
  const PairCheck check = Check({images_.left, scene_.Pair(elsewhere).right});
  EXPECT_LT(ShareFound(check), 0.06);
}

TEST_F(CheckedPair, SearchesForNothingInImagesWithoutTexture) {
  StereoImages flat = images_;
  std::fill(flat.left.pixels.begin(), flat.left.pixels.end(), 90);
  EXPECT_EQ(Check(flat).corners, 0);
}

}  // namespace
}  // namespace dockyard
