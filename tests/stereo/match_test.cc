#include "controller/stereo/match.h"

#include <gtest/gtest.h>

#include <cmath>

#include "stereo/ray_scene.h"

namespace dockyard {
namespace {

struct Quality {
  double density = 0.0, off_by_a_pixel = 0.0, sigma_px = 0.0, bias_px = 0.0;
};

// Against the ground's disparity in closed form, where the left camera sees ground within a depth.
Quality OnGround(const Rectifier& rectifier, const Disparities& found, const PlaneDisparity& truth,
                 double far_m) {
  const RectifiedPair& pair = rectifier.pair();
  const double least_px = pair.focal_px * pair.baseline_m / far_m;
  double seen = 0, matched = 0, off = 0, sum = 0, squares = 0;
  for (int v = 10; v < found.height - 10; ++v) {
    for (int u = 100; u < found.width - 10; ++u) {
      const double want = truth.At(u, v);
      if (!rectifier.IsSeen(u, v, false) || want < least_px) continue;
      ++seen;
      const double error = static_cast<double>(found.at(u, v)) - want;
      if (!std::isfinite(error)) continue;
      ++matched;
      if (std::abs(error) > 1.0) {
        ++off;
        continue;
      }
      sum += error;
      squares += error * error;
    }
  }
  const double kept = matched - off, mean = sum / kept;
  return {matched / seen, off / matched, std::sqrt(squares / kept - mean * mean), mean};
}

class OnLevelGround : public ::testing::Test {
 protected:
  OnLevelGround() : rectifier_(rig_), truth_(DisparityOf(rectifier_.pair(), {})) {
    images_ = RayScene{}.Pair(rig_);
  }
  const StereoRig rig_ = BodyPair();
  Rectifier rectifier_;
  PlaneDisparity truth_;
  StereoImages images_;
};

// The depth of the plane under a pixel, by the camera's height and the pixel's ray.
TEST_F(OnLevelGround, DisparityIsThatOfTheRayThatMeetsIt) {
  const RectifiedPair& pair = rectifier_.pair();
  for (const double v : {100.0, 150.0, 200.0}) {
    const Eigen::Vector3d ray_C(0.1, (v - pair.centre_px.y()) / pair.focal_px, 1.0);
    const double depth_m = -0.3 / (pair.X_RC.R * ray_C).z();
    const double u = pair.centre_px.x() + 0.1 * pair.focal_px;
    EXPECT_NEAR(truth_.At(u, v), pair.focal_px * pair.baseline_m / depth_m, 1e-9);
  }
}

TEST_F(OnLevelGround, TheGroundTakenOutMakesBlocksSharperAndTheirGapsFewer) {
  const Quality plain = OnGround(
      rectifier_, Match(rectifier_, images_, {.block_px = 11, .count_px = 80}), truth_, 1.0);
  MatchSettings settings{.block_px = 11, .least_px = -16, .count_px = 48};
  // As far off as height and attitude of a rover are told: a centimetre and a degree.
  const Eigen::Vector3d tilted = RotY(Radians(1.0)) * Eigen::Vector3d::UnitZ();
  settings.ground = DisparityOf(rectifier_.pair(), {tilted, 0.01});
  const Quality flat = OnGround(rectifier_, Match(rectifier_, images_, settings), truth_, 1.0);
  EXPECT_GT(flat.density, 0.85);  // the rest lies at the pictures' borders
  EXPECT_GT(flat.density, plain.density + 0.05);
  EXPECT_LT(flat.sigma_px, 0.25);  // a quarter of a pixel: JPL's usual figure
  EXPECT_LT(flat.sigma_px, plain.sigma_px / 1.3);
  EXPECT_LT(flat.off_by_a_pixel, 0.01);
  EXPECT_LT(std::abs(flat.bias_px), 0.1);
}

TEST_F(OnLevelGround, PathsMatchItToo) {
  MatchSettings settings{
      .matcher = Matcher::kSemiGlobal, .block_px = 5, .least_px = -16, .count_px = 48};
  settings.ground = truth_;
  const Quality flat = OnGround(rectifier_, Match(rectifier_, images_, settings), truth_, 1.0);
  EXPECT_GT(flat.density, 0.85);
  EXPECT_LT(flat.sigma_px, 0.3);
}

// The matcher reads the pictures: exchanged, they fit nowhere.
TEST_F(OnLevelGround, ExchangedPicturesGiveNothing) {
  MatchSettings settings{.block_px = 11, .least_px = -16, .count_px = 48};
  settings.ground = truth_;
  const Quality wrong =
      OnGround(rectifier_, Match(rectifier_, {images_.right, images_.left}, settings), truth_, 1.0);
  EXPECT_LT(wrong.density, 0.2);
}

// Smoothing leaves the place of what is seen alone.
TEST_F(OnLevelGround, SmoothedPicturesMatchAtTheSamePlace) {
  MatchSettings settings{.matcher = Matcher::kSemiGlobal,
                         .block_px = 5,
                         .least_px = -16,
                         .count_px = 48,
                         .smooth_px = 1.0};
  settings.ground = truth_;
  const Quality flat = OnGround(rectifier_, Match(rectifier_, images_, settings), truth_, 1.0);
  EXPECT_GT(flat.density, 0.85);
  EXPECT_LT(flat.sigma_px, 0.3);
  EXPECT_LT(std::abs(flat.bias_px), 0.05);
}

TEST(Match, RefusesSettingsThatNoMatcherHas) {
  const StereoImages images{{8, 8, std::vector<std::uint8_t>(64)},
                            {8, 8, std::vector<std::uint8_t>(64)}};
  EXPECT_DEATH(Match(images, {.block_px = 4}), "check failed");
  EXPECT_DEATH(Match(images, {.count_px = 20}), "check failed");
  EXPECT_DEATH(Match(images, {.smooth_px = -1.0}), "check failed");
  EXPECT_DEATH(Match({images.left, {4, 8, std::vector<std::uint8_t>(32)}}, {}), "check failed");
}

}  // namespace
}  // namespace dockyard
