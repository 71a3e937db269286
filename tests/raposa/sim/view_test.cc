// What the back camera shows is where the truth says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/read/yaml_tree.h"
#include "raposa/sim/raposa_rig.h"
#include "sim/plant/sun_motion.h"
#include "sim/raposa/raposa_plant.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

/// A run on the hard floor, the camera looking at the guide.
struct Start {
  Scenario scenario;
  BuiltRun built;
};
Start At(double r_m, double alpha_rad) {
  const std::string models = SourceFile("models/raposa/");
  Start start;
  start.scenario.robot_file = models + "raposa.yaml";
  start.scenario.soil_file = models + "grounds/hard_floor.yaml";
  start.scenario.of_system = ParseYaml("{pyramid: " + models + "pyramid/pyramid.yaml}", "test");
  start.scenario.start = {r_m, alpha_rad, alpha_rad};
  start.scenario.yard.undulation_rms_m = 0.0;
  start.built = BuildRun(start.scenario, LoadModels(start.scenario));
  return start;
}

struct Region {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9, sum_u = 0.0, sum_v = 0.0;
  int pixels = 0;
};
/// Of the pixels that are more orange (red far above blue), or more blue, than anything grey.
Region Find(const RgbImage& image, bool orange) {
  Region region;
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const std::uint8_t* p =
          &image.pixels[3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(u))];
      const double red = p[0], blue = p[2];
      const bool in = orange ? red > 1.8 * blue && red > 40.0 : blue > 2.0 * red && blue > 40.0;
      if (!in) continue;
      region.left = std::min(region.left, u - 0.5);
      region.right = std::max(region.right, u + 0.5);
      region.top = std::min(region.top, v - 0.5);
      region.bottom = std::max(region.bottom, v + 0.5);
      region.sum_u += u;
      region.sum_v += v;
      ++region.pixels;
    }
  }
  return region;
}

RgbImage PictureOf(const Start& start, double* c_px, Eigen::Vector2d* guide_px) {
  RaposaPlant plant(start.scenario, start.built, std::make_shared<KeptRenderer>());
  const BackCameraModel& camera = start.built.world.robot.camera;
  const Pose3 X_CP = Inverse(plant.truth().X_WR * camera.X_RC) * plant.truth().X_WP;
  *guide_px = *camera.camera.Project(X_CP * Eigen::Vector3d::Zero());
  const double half_m = 0.5 * start.built.world.pyramid.marks.edge_m;
  *c_px = 0.0;
  for (const double y : {-half_m, half_m}) {
    const Eigen::Vector3d p_P(-start.built.world.pyramid.marks.behind_m, y, 0.0);
    *c_px = std::max(*c_px, std::abs(camera.camera.Project(X_CP * p_P)->x() - guide_px->x()));
  }
  return std::get<RgbImage>(plant.TakeImages({kBackCamera}, 0.0).at(0).pixels);
}

TEST(RaposaView, HasTheSunOfTheTruthsTime) {
  const Start start = At(1.0, 0.0);
  SunModel sun;
  sun.moving = true;
  const Lighting lighting = MakeLighting(Light::kEven, Pose3{}, {0.0, 0.0, 0.5}, 1, sun);
  const World world(start.built.world);
  const SceneBuilder builder(start.built, lighting, 1);
  Truth truth = world.truth();
  EXPECT_EQ(builder.Make(truth, world.ground(), false).light.to_sun_W,
            lighting.sun_and_sky.to_sun_W);
  truth.time_s = 3600.0;
  const SunAndSky later = builder.Make(truth, world.ground(), false).light;
  EXPECT_EQ(later.to_sun_W, LightAt(lighting, 3600.0).to_sun_W);
  EXPECT_LT(later.to_sun_W.dot(lighting.sun_and_sky.to_sun_W), std::cos(Radians(10.0)));
}

TEST(RaposaView, GuideIsSeenWhereItProjects) {
  for (const double alpha_deg : {0.0, 30.0, -60.0}) {
    double c_px = 0.0;
    Eigen::Vector2d guide_px;
    const Region orange = Find(PictureOf(At(0.7, Radians(alpha_deg)), &c_px, &guide_px), true);
    ASSERT_GT(orange.pixels, 50) << alpha_deg;
    EXPECT_NEAR(orange.sum_u / orange.pixels, guide_px.x(), 1.0) << alpha_deg;
    EXPECT_NEAR(orange.sum_v / orange.pixels, guide_px.y(), 1.5) << alpha_deg;
  }
}

TEST(RaposaView, BlueReachesToTheSquaresFarEnd) {
  for (const double alpha_deg : {30.0, 60.0}) {
    double c_px = 0.0;
    Eigen::Vector2d guide_px;
    const Region blue = Find(PictureOf(At(0.8, Radians(alpha_deg)), &c_px, &guide_px), false);
    ASSERT_GT(blue.pixels, 20);
    const double reach =
        std::max(std::abs(blue.left - guide_px.x()), std::abs(blue.right - guide_px.x()));
    EXPECT_NEAR(reach, c_px, 2.0) << alpha_deg;  // half a pixel of blur at the end
  }
}

TEST(RaposaView, OnlyTheDiscThatTheHoleLeavesIsLit) {
  double c_px = 0.0;
  Eigen::Vector2d guide_px;
  const Start start = At(1.0, 0.0);
  const RgbImage image = PictureOf(start, &c_px, &guide_px);
  const BackCameraModel& camera = start.built.world.robot.camera;
  const double radius_px = camera.camera.focal_px().x() * std::tan(camera.half_view_rad);
  double outside = 0.0, inside = 0.0;
  int n_outside = 0, n_inside = 0;
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const double r = std::hypot(u - 0.5 * (image.width - 1), v - 0.5 * (image.height - 1));
      const double green =
          image.pixels[3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(u)) +
                       1];
      if (r > radius_px + 16.0) outside += green, ++n_outside;
      if (r < radius_px - 16.0) inside += green, ++n_inside;
    }
  }
  EXPECT_LT(outside / n_outside, 0.2 * inside / n_inside);
}

// The robot turns in place. An image without delay is of its pose now, one with the largest delay
// of its pose a period ago.
TEST(RaposaView, ImageIsOfThePoseBeforeItsDelay) {
  const double period_s = kTickSeconds * kControlPeriod;
  for (const double delay_s : {0.0, 0.05, period_s}) {
    Start start = At(0.7, 0.0);
    start.built.world.robot.camera.delay_s = delay_s;
    RaposaPlant plant(start.scenario, start.built, std::make_shared<KeptRenderer>());
    Commands turn = BrakedCommands();
    const MotorCommands belts = Belts(start.built.world, -0.03, 0.03);
    std::copy(belts.begin(), belts.end(), turn.motors.begin());
    for (int i = 0; i < 4; ++i) plant.Advance(turn);
    const BackCameraModel& camera = start.built.world.robot.camera;
    const auto guide_px = [&] {
      plant.Sense();  // brings the truth up to date
      const Pose3 X_CP = Inverse(plant.truth().X_WR * camera.X_RC) * plant.truth().X_WP;
      return camera.camera.Project(X_CP * Eigen::Vector3d::Zero())->x();
    };
    const double before_px = guide_px();
    plant.Advance(turn);
    const double now_px = guide_px();
    ASSERT_GT(std::abs(now_px - before_px), 4.0);
    const Region orange =
        Find(std::get<RgbImage>(plant.TakeImages({kBackCamera}, 0.0).at(0).pixels), true);
    ASSERT_GT(orange.pixels, 50);
    EXPECT_NEAR(orange.sum_u / orange.pixels, now_px + (before_px - now_px) * delay_s / period_s,
                2.0)
        << delay_s;
  }
}

}  // namespace
}  // namespace dockyard::raposa
