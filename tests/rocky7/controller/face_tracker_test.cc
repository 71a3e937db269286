#include "controller/rocky7/face_tracker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "rocky7/controller/face_scene.h"

namespace dockyard::rocky7 {
namespace {

using testing::HasSubstr;

// A rover before a face, and what its image pairs give.
struct Watch {
  Nominal nominal = NominalRover();
  FaceStereo stereo{nominal};
  FaceScene scene;
  Pose2 X_WE;

  FaceView Look(bool first = false) {
    const Eigen::Vector3d p_E = FaceScene::InE(X_WE, scene.p_W);
    const Pose3 X_ER = LevelFrame(nominal, {});
    const MastAngles angles =
        first ? nominal.mast.watch_rad : AnglesToWatch(nominal.mast, Inverse(X_ER) * p_E);
    std::optional<Eigen::Vector3d> target;
    if (!first) target = p_E + Eigen::Vector3d(0.02, 0.01, 0.0);
    return stereo.Look(scene.Pair(nominal, X_WE, angles), angles, {}, target);
  }
  Eigen::Vector2d PixelIn(const FaceView& view) const {
    const Eigen::Vector3d p_C = Inverse(view.pair.X_RC) * FaceScene::InE(X_WE, scene.p_W);
    return view.pair.centre_px + view.pair.focal_px * p_C.head<2>() / p_C.z();
  }
};

TEST(FaceStereo, MeasuresPointAndNormalOfAFaceFromNearBy) {
  for (const double up_deg : {10.0, 30.0, 55.0}) {
    Watch watch;
    watch.scene.p_W = {0.9, 0.05, 0.4};
    watch.scene.normal_W = NormalOf(up_deg, 10.0);
    const FaceView view = watch.Look();
    const auto plane = watch.stereo.PlaneAt(view, watch.PixelIn(view));
    ASSERT_TRUE(plane);
    EXPECT_LT((plane->p - watch.scene.p_W).norm(), 0.003) << up_deg;
    EXPECT_LT(Degrees(AngleBetween(plane->normal, watch.scene.normal_W)), 1.0) << up_deg;
    EXPECT_LT(Degrees(plane->normal_sigma_rad), 2.0);
  }
}

// A rock's top is few pixels high from afar.
TEST(FaceStereo, EveryPixelWithARangeIsInACellOfItsHeights) {
  Watch watch;
  watch.scene.p_W = {0.9, 0.05, 0.4};
  watch.scene.normal_W = NormalOf(40.0, 30.0);
  const FaceView view = watch.Look();
  const ElevationMap map = watch.stereo.HeightsAbout(view, {0.9, 0.05}, 0.2);
  int within = 0;
  for (int v = 0; v < view.disparities.height; ++v) {
    for (int u = 0; u < view.disparities.width; ++u) {
      const float disparity_px = view.disparities.at(u, v);
      if (!(disparity_px > 0.0F)) continue;
      const Eigen::Vector3d p_E = view.pair.X_RC * view.pair.Point(u, v, disparity_px);
      const double ix = std::floor((p_E.x() - (map.x0_m - 0.5 * map.cell_m)) / map.cell_m);
      const double iy = std::floor((p_E.y() - (map.y0_m - 0.5 * map.cell_m)) / map.cell_m);
      within += ix >= 0 && iy >= 0 && ix < map.nx && iy < map.ny;
    }
  }
  int known = 0;
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    ASSERT_EQ(map.points[i] == 0, std::isnan(map.height_m[i])) << i;
    known += map.points[i];
  }
  EXPECT_EQ(known, within);
  EXPECT_GT(known, 1000);
}

TEST(FaceStereo, FindsAClickWithinAFewCentimetresFromSixMetres) {
  Watch watch;
  watch.scene.p_W = {6.0, 0.3, 0.4};
  watch.scene.normal_W = NormalOf(20.0, 0.0);
  const FaceView view = watch.Look(true);
  PatchTracker tracker;
  const FaceSighting seen = tracker.Begin(watch.stereo, view, watch.PixelIn(view));
  ASSERT_TRUE(seen.found) << seen.why;
  EXPECT_LT((seen.p_E - watch.scene.p_W).norm(), 0.08);
  ASSERT_TRUE(seen.normal_E);
}

// An approach: from 6 m to where the instrument is placed, 30 % of what is left a step.
// Odometry is off by 3 % of each step and 0.3 deg.
TEST(PatchTracker, KeepsAPointOfAFaceWithinMillimetresAllTheWay) {
  for (const double up_deg : {15.0, 45.0}) {
    Watch watch;
    watch.scene.p_W = {6.0, 0.3, 0.4};
    watch.scene.normal_W = NormalOf(up_deg, 0.0);
    PatchTracker tracker;
    FaceView view = watch.Look(true);
    FaceSighting seen = tracker.Begin(watch.stereo, view, watch.PixelIn(view));
    ASSERT_TRUE(seen.found) << seen.why;
    int looks = 1;
    while (watch.X_WE.x < 5.2) {
      const double step_m = std::clamp(0.3 * (5.21 - watch.X_WE.x), 0.12, 0.6);
      const double turn_rad = (looks % 3 - 1) * 0.05;
      const Pose2 since = Advance({}, Arc{step_m, turn_rad});
      const Pose2 counted = Advance({}, Arc{1.03 * step_m, turn_rad + Radians(0.3)});
      watch.X_WE = watch.X_WE * since;
      FaceExpected expected{.way_m = step_m};
      expected.p_E = Inverse(FromGround(counted, 0.0)) * seen.p_E;
      expected.turned_rad = counted.heading;
      view = watch.Look();
      seen = tracker.Follow(watch.stereo, view, expected);
      ++looks;
      ASSERT_TRUE(seen.found) << looks << ": " << seen.why;
    }
    const Eigen::Vector3d off = seen.p_E - FaceScene::InE(watch.X_WE, watch.scene.p_W);
    std::printf("%d looks, off by %.1f mm, score %.2f\n", looks, 1e3 * off.norm(), seen.score);
    EXPECT_LT(off.norm(), 0.006) << off.transpose();
    const Eigen::Vector3d normal_E = FaceScene::TurnedInE(watch.X_WE, watch.scene.normal_W);
    EXPECT_LT(Degrees(AngleBetween(*seen.normal_E, normal_E)), 1.0);
  }
}

struct Step {
  Watch watch;
  PatchTracker tracker;
  FaceSighting first;
  FaceExpected expected;

  // One step from 3 m to 2.6 m.
  Step() {
    watch.scene.p_W = {3.0, 0.2, 0.4};
    watch.scene.normal_W = NormalOf(20.0, 10.0);
    const FaceView view = watch.Look();
    first = tracker.Begin(watch.stereo, view, watch.PixelIn(view));
    watch.X_WE = {0.4, 0.0, 0.0};
    expected = {.p_E = first.p_E - Eigen::Vector3d(0.4, 0.0, 0.0), .way_m = 0.4};
  }
  FaceSighting Follow() { return tracker.Follow(watch.stereo, watch.Look(), expected); }
};

TEST(PatchTracker, FindsThePointAfterAStep) {
  Step step;
  ASSERT_TRUE(step.first.found);
  const FaceSighting seen = step.Follow();
  ASSERT_TRUE(seen.found) << seen.why;
  EXPECT_GT(seen.score, 0.8);
}

// Odometry is off by 10 cm to a side, five sigmas: the second pair is searched as far again.
TEST(PatchTracker, SearchesFurtherAfterAMiss) {
  Step step;
  step.expected.p_E.y() += 0.1;
  EXPECT_FALSE(step.Follow().found);
  const FaceSighting sighting = step.Follow();
  ASSERT_TRUE(sighting.found) << sighting.why;
  const Eigen::Vector3d p_E = FaceScene::InE(step.watch.X_WE, step.watch.scene.p_W);
  EXPECT_LT((sighting.p_E - p_E).norm(), 0.03);
}

// On a cross slope the rover drifted by 10 cm, which odometry held for possible.
TEST(PatchTracker, SearchesAsFarAsADriftMayHaveLed) {
  Step step;
  step.expected.p_E.y() += 0.1;
  step.expected.drift_m = 0.06;
  const FaceSighting sighting = step.Follow();
  ASSERT_TRUE(sighting.found) << sighting.why;
  const Eigen::Vector3d p_E = FaceScene::InE(step.watch.X_WE, step.watch.scene.p_W);
  EXPECT_LT((sighting.p_E - p_E).norm(), 0.03);
}

TEST(PatchTracker, SaysThatTheFaceIsAnother) {
  Step step;
  step.watch.scene.other = 7.0;
  const FaceSighting seen = step.Follow();
  EXPECT_FALSE(seen.found);
  EXPECT_THAT(seen.why, HasSubstr("like the target"));
}

TEST(PatchTracker, RefusesTheSameFaceAtAnotherRange) {
  Step step;
  step.watch.X_WE.x = 0.0;
  const FaceSighting seen = step.Follow();
  EXPECT_FALSE(seen.found);
}

TEST(PatchTracker, SaysThatABlankPictureHasNothing) {
  Step step;
  FaceView view = step.watch.Look();
  std::fill(view.images.left.pixels.begin(), view.images.left.pixels.end(), 90);
  EXPECT_FALSE(step.tracker.Follow(step.watch.stereo, view, step.expected).found);
}

}  // namespace
}  // namespace dockyard::rocky7
