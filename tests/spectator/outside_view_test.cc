#include "sim/spectator/outside_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/plant/renderer.h"
#include "sim/spectator/viewpoint.h"
#include "spectator/some_run.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Middle of the pixels in which a channel is twice both others; none of them: (-1, -1).
Eigen::Vector2d MiddleOf(const RgbImage& image, int channel) {
  Eigen::Vector2d sum(0.0, 0.0);
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = &image.pixels[3 * (static_cast<std::size_t>(y) * image.width + x)];
      if (p[channel] < 2 * p[(channel + 1) % 3] || p[channel] < 2 * p[(channel + 2) % 3]) continue;
      sum += Eigen::Vector2d(x, y);
      ++count;
    }
  }
  return count == 0 ? Eigen::Vector2d(-1.0, -1.0) : Eigen::Vector2d(sum / count);
}

// The middle of a cube's outline is where its centre is, but for its perspective.
TEST(OutsideView, ShowsEachBodyWhereTheLogHasIt) {
  const LoggedRun run = SomeRun();
  const StageShapes shapes = SomeShapes();
  OutsideOptions options{.width = 320, .height = 180, .from_D = Eigen::Vector3d(2.0, 8.0, 3.0)};
  const auto renderer = MakeRenderer();
  OutsideView view(run, shapes, options, 0, 1, *renderer);
  const Camera camera = PinholeCamera(320, 180, 32.0 * kPi / 180.0);
  const Pose3 X_CW = Inverse(PoseAimedAt({2.0, 8.0, 3.0}, {1.5, 0.0, 0.1}));
  for (const std::size_t sample : {std::size_t{0}, std::size_t{1}}) {
    const RgbImage image = view.Image(sample);
    const Eigen::Vector2d robot = *camera.Project(X_CW * run.X_WO[0][sample].p);
    EXPECT_LT((MiddleOf(image, 0) - robot).norm(), 3.0) << sample;
    const Eigen::Vector2d target = *camera.Project(X_CW * Eigen::Vector3d(0.0, 0.0, 0.1));
    EXPECT_LT((MiddleOf(image, 2) - target).norm(), 3.0) << sample;
  }
}

TEST(OutsideView, HasGroundAllTheWayToTheSpectator) {
  const LoggedRun run = SomeRun();
  StageShapes shapes = SomeShapes();
  shapes.ground_rgb = {0.03, 0.6, 0.03};
  const auto renderer = MakeRenderer();
  for (const Eigen::Vector3d& from_D : {Eigen::Vector3d(2.0, 8.0, 3.0), {7.0, -4.0, 1.0}}) {
    OutsideView view(run, shapes, {.width = 320, .height = 180, .from_D = from_D}, 0, 1, *renderer);
    const RgbImage image = view.Image(0);
    int green = 0;
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = &image.pixels[3 * (179 * std::size_t{320} + x)];
      green += p[1] > 2 * p[0] && p[1] > 2 * p[2];
    }
    EXPECT_EQ(green, 320) << from_D.transpose();
  }
}

// An hour about the pole overhead: 15 deg (one sidereal turn in 23 h 56 min, so 15.04 deg).
TEST(OutsideScenes, HaveTheSunOfTheSamplesTime) {
  LoggedRun run = SomeRun();
  run.times_s[1] = 3600.0;
  StageShapes shapes = SomeShapes();
  for (const bool moves : {false, true}) {
    if (moves) shapes.to_pole_W = Eigen::Vector3d::UnitZ();
    OutsideScenes scenes(run, shapes);
    EXPECT_EQ(scenes.At(0).light.to_sun_W, shapes.light.to_sun_W);
    const Eigen::Vector2d start = shapes.light.to_sun_W.head<2>();
    const Eigen::Vector2d later = scenes.At(1).light.to_sun_W.head<2>();
    const double turned_rad = std::acos(start.normalized().dot(later.normalized()));
    EXPECT_NEAR(turned_rad, moves ? Radians(15.0) : 0.0, Radians(0.1));
  }
}

// The robot, 0.4 m high, has a mast of 2 m: its top is in the image without further options.
TEST(OutsideView, HoldsTheWholeRobot) {
  LoggedRun run = SomeRun();
  StageShapes shapes = SomeShapes();
  shapes.bodies[0].parts.push_back(
      {Box(0.1), Pose3::Translation(0.0, 0.0, 1.9), {0.03, 0.6, 0.03}});
  const auto renderer = MakeRenderer();
  OutsideView view(run, shapes, {.width = 320, .height = 180}, 0, 1, *renderer);
  for (const std::size_t sample : {std::size_t{0}, std::size_t{1}}) {
    EXPECT_GT(MiddleOf(view.Image(sample), 1).y(), 0.0) << sample;
  }
}

// The same place once without sky and once with a bright sky in most of the first image.
TEST(OutsideView, HasOneExposureWhateverSkyThereIs) {
  const LoggedRun run = SomeRun();
  StageShapes shapes = SomeShapes();
  shapes.light.sky_irradiance = 5.0;
  const auto renderer = MakeRenderer();
  const auto ground = [&](double up_m) {
    OutsideOptions options{.width = 320, .height = 180, .from_D = Eigen::Vector3d(1.0, 4.0, 1.0)};
    options.at = Aim{"", Eigen::Vector3d(0.0, 0.0, up_m)};
    OutsideView view(run, shapes, options, 0, 1, *renderer);
    const RgbImage image = view.Image(0);
    double sum = 0.0;
    for (int x = 100; x < 220; ++x) sum += image.pixels[3 * (175 * std::size_t{320} + x) + 1];
    return sum / 120.0;
  };
  EXPECT_NEAR(ground(1.6), ground(-1.0), 12.0);
}

TEST(OutsideScenes, FollowTheGroundsChanges) {
  LoggedRun run = SomeRun();
  run.ground.push_back({0.1, {.cells = {0, 7}, .heights = {-200, 50}}});
  const StageShapes shapes = SomeShapes();
  OutsideScenes scenes(run, shapes);
  const Scene before = scenes.At(0);
  EXPECT_EQ(before.ground.heights_m[7], 0.0);
  const std::uint64_t revision = before.ground.revision;
  const Scene after = scenes.At(1);
  EXPECT_NE(after.ground.revision, revision);
  EXPECT_NEAR(after.ground.heights_m[0], -0.02, 1e-12);
  EXPECT_NEAR(after.ground.heights_m[7], 0.005, 1e-12);
}

TEST(OutsideScenes, RefuseALogOfOtherBodiesOrWithoutSamples) {
  const LoggedRun run = SomeRun();
  StageShapes shapes = SomeShapes();
  shapes.bodies[1].name = "kiosk";
  EXPECT_THAT([&] { OutsideScenes(run, shapes); },
              ThrowsMessage<DataError>(HasSubstr("no body kiosk")));
  const LoggedRun empty;
  EXPECT_THAT([&] { OutsideScenes(empty, shapes); },
              ThrowsMessage<DataError>(HasSubstr("no sample")));
}

}  // namespace
}  // namespace dockyard
