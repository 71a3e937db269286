#include "controller/stereo/rectify.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/read/load_cameras.h"
#include "sim/base/random.h"
#include "stereo/ray_scene.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Pixel of a point in the rectified left or right image.
Vector2d Rectified(const RectifiedPair& pair, const Vector3d& p_C, bool right) {
  const Vector3d p = p_C - Vector3d(right ? pair.baseline_m : 0.0, 0.0, 0.0);
  return pair.centre_px + pair.focal_px * p.head<2>() / p.z();
}

// How far the lookup of points' rectified pixels misses where the cameras show them, at most [px].
double WorstMiss(const StereoRig& rig, const RectifySettings& settings, double near_m, double far_m,
                 bool on_ground) {
  const Rectifier rectifier(rig, settings);
  const RectifiedPair& pair = rectifier.pair();
  RandomStream random(StreamKey(1, "points"));
  double worst = 0.0;
  int seen = 0;
  for (int i = 0; i < 10'000; ++i) {
    const double depth_m = random.Uniform(near_m, far_m);
    Vector3d p_C = depth_m * Vector3d(random.Uniform(-0.9, 0.9), random.Uniform(-0.7, 0.7), 1.0);
    if (on_ground) {
      const Plane& ground = *settings.ground_R;
      const double up = ground.normal.dot(pair.X_RC * p_C) - ground.offset_m;
      const double from = ground.normal.dot(pair.X_RC.p) - ground.offset_m;
      if (up >= from) continue;
      p_C *= from / (from - up);
    }
    for (const bool right : {false, true}) {
      const Camera& camera = right ? rig.right : rig.left;
      const auto shown = camera.Project(Inverse(right ? rig.X_RQ : rig.X_RL) * (pair.X_RC * p_C));
      const auto found = rectifier.Source(Rectified(pair, p_C, right), right);
      if (!shown || !found || !camera.Sees(*shown)) continue;
      ++seen;
      worst = std::max(worst, (*shown - *found).norm());
    }
  }
  EXPECT_GT(seen, 2000);
  return worst;
}

TEST(Rectifier, ShowsPointsAtAllDistancesInEqualRows) {
  StereoRig rig = BodyPair();
  rig.X_RQ.R = rig.X_RQ.R * RotX(0.02) * RotY(-0.03) * RotZ(0.01);  // not quite parallel
  EXPECT_LT(WorstMiss(rig, {}, 0.3, 5.0, false), 1e-6);
}

// Navcams' pupils move with the angle (E != 0): exact on the ground that is told, and off it by
// less than a pixel at 1 m and beyond.
TEST(Rectifier, TakesAMovingPupilToTheGround) {
  const StereoRig rig = LoadRig(SourceFile("models/cameras/navcam.yaml"));
  RectifySettings settings;
  settings.ground_R = Plane{Vector3d::UnitZ(), -0.7};
  EXPECT_LT(WorstMiss(rig, settings, 0.5, 5.0, true), 1e-3);
  EXPECT_LT(WorstMiss(rig, settings, 1.0, 5.0, false), 1.0);
}

TEST(Rectifier, KeepsTheResolutionOfTheCentreAndTheLeftView) {
  const StereoRig rig = BodyPair();
  const RectifiedPair pair = Rectifier(rig).pair();
  EXPECT_NEAR(pair.focal_px, 320.0 / Radians(95.0), 1e-9);
  EXPECT_NEAR(pair.baseline_m, 0.1, 1e-12);
  EXPECT_NEAR((pair.X_RC.R - rig.X_RL.R).norm(), 0.0, 1e-12);
  // The corners see farther aside than the middle of the sides, at most what the settings let them.
  EXPECT_GT(pair.width, 2.0 * pair.focal_px * std::tan(Radians(47.5)));
  EXPECT_LT(pair.width, 2.0 * pair.focal_px * std::tan(Radians(57.0)) + 2.0);
}

TEST(Rectifier, RefusesAPairWithoutABaselineOrAlongIt) {
  StereoRig rig = BodyPair();
  rig.X_RQ = rig.X_RL;
  EXPECT_THROW(Rectifier{rig}, std::invalid_argument);
  rig.X_RQ.p += rig.X_RL.R.col(2);
  EXPECT_THROW(Rectifier{rig}, std::invalid_argument);
}

TEST(RectifiedPair, FindsAPointByItsDisparity) {
  const RectifiedPair pair = Rectifier(BodyPair()).pair();
  const Vector3d p_C(0.1, -0.2, 0.8);
  const Vector2d left = Rectified(pair, p_C, false), right = Rectified(pair, p_C, true);
  EXPECT_NEAR(left.y(), right.y(), 1e-12);
  EXPECT_LT((pair.Point(left.x(), left.y(), left.x() - right.x()) - p_C).norm(), 1e-12);
}

// Two pinholes side by side, the right image cut off by 7.5 px on its left.
StereoRig CroppedPair() {
  StereoRig rig = BodyPair();
  const BrownPinhole lens{250.0, 250.0, 159.5, 119.5};
  rig.left.lens = rig.right.lens = lens;
  std::get<BrownPinhole>(rig.right.lens).cx -= 7.5;
  return rig;
}

TEST(Rectifier, LeavesImagesOfARectifiedRigAsTheyAre) {
  const StereoRig rig = CroppedPair();
  ASSERT_TRUE(IsRectified(rig));
  const StereoImages images = RayScene{}.Pair(rig);
  const Rectifier kept(rig, {.keep_rectified = true});
  EXPECT_EQ(kept.Rectified(images), images);
  EXPECT_TRUE(kept.IsSeen(0, 0, true));
  EXPECT_FALSE(Rectifier(rig).Rectified(images) == images);
}

TEST(IsRectified, IsNoneThatIsTurnedBentOrShifted) {
  StereoRig turned = CroppedPair(), bent = turned, raised = turned, shifted = turned,
            exchanged = turned, wide = turned;
  turned.X_RQ.R = turned.X_RQ.R * RotX(1e-4);  // 0.025 px
  std::get<BrownPinhole>(bent.left.lens).k1 = 0.001;
  raised.X_RQ.p += 1e-5 * raised.X_RL.R.col(1);
  std::get<BrownPinhole>(shifted.right.lens).cy += 0.1;
  std::swap(exchanged.X_RL, exchanged.X_RQ);
  std::get<BrownPinhole>(wide.right.lens).fx += 0.1;
  for (const StereoRig& rig : {turned, bent, raised, shifted, exchanged, wide, BodyPair()}) {
    EXPECT_FALSE(IsRectified(rig));
  }
}

// The cameras' own projections of a point, and OpenCV's equation: Q (u, v, d, 1) ~ (p, 1).
TEST(RectifiedPair, ReprojectsAPointAsOpenCvDoes) {
  const StereoRig rig = CroppedPair();
  const RectifiedPair pair = Rectifier(rig, {.keep_rectified = true}).pair();
  EXPECT_NEAR(pair.doffs_px, -7.5, 1e-12);
  const Vector3d p_L(0.1, -0.2, 0.8);
  const Vector2d left = *rig.left.Project(p_L),
                 right = *rig.right.Project(Inverse(rig.X_RQ) * (rig.X_RL * p_L));
  const double disparity_px = left.x() - right.x();
  EXPECT_LT((pair.Point(left.x(), left.y(), disparity_px) - p_L).norm(), 1e-12);
  const Eigen::Vector4d p =
      ReprojectionOf(pair) * Eigen::Vector4d(left.x(), left.y(), disparity_px, 1.0);
  EXPECT_LT((p.head<3>() / p.w() - p_L).norm(), 1e-12);
}

}  // namespace
}  // namespace dockyard
