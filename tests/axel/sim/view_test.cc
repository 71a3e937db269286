// The truth that "dockyard view" writes, against the rendered images themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "axel/sim/scenarios.h"
#include "render/stereo_renderer.h"
#include "sim/axel/axel_view.h"
#include "sim/axel/build_run.h"
#include "sim/axel/fiducial_truth.h"
#include "sim/plant/built_cameras.h"
#include "sim/plant/sun_motion.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

const std::string kNavcam = "camera.file=" + SourceFile("models/cameras/navcam.yaml");

/// Centroid of a dark disc of about this radius near a place. Grey levels of the plate and of the
/// ink come from rings inside the image; a pixel counts by its share of ink, the middle with its
/// white bar counts as ink. It uses no camera model.
Eigen::Vector2d InkCentroid(const GrayImage& image, const Eigen::Vector2d& near, double radius_px) {
  const int half = static_cast<int>(std::ceil(1.4 * radius_px));
  const auto each = [&](const std::function<void(const Eigen::Vector2d&, double, double)>& visit) {
    for (int y = -half; y <= half; ++y) {
      for (int x = -half; x <= half; ++x) {
        const Eigen::Vector2d p(std::round(near.x()) + x, std::round(near.y()) + y);
        visit(p, (p - near).norm() / radius_px,
              image.at(static_cast<int>(p.x()), static_cast<int>(p.y())));
      }
    }
  };
  double plate = 0.0, ink = 0.0;
  int plate_count = 0, ink_count = 0;
  each([&](const Eigen::Vector2d&, double r, double level) {
    if (r > 1.2 && r < 1.38) plate += level, ++plate_count;
    if (r > 0.7 && r < 0.82) ink += level, ++ink_count;
  });
  plate /= plate_count;
  ink /= ink_count;
  double weight = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  each([&](const Eigen::Vector2d& p, double r, double level) {
    if (r > 1.2) return;
    const double share = r < 0.75 ? 1.0 : (plate - level) / (plate - ink);
    weight += share;
    moment += share * p;
  });
  return moment / weight;
}

class StartView : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(StartView, DiscCentroidsLieWhereTheImageHasThem) {
  std::vector<std::string> overrides = GetParam();
  overrides.push_back("start.alpha_deg=0");
  const Scenario scenario = TypicalScenario(overrides);
  BuiltRun built = Build(scenario);
  const World world(built.world);
  const Truth truth = world.truth();
  const SceneBuilder builder(built.world.rover, built.world.station, built.world.soil,
                             built.lighting, SiteOf(scenario), scenario.seed);
  const Scene scene = builder.Make(truth, world.ground());
  SensorOptions sensor = CameraSensor(built.world.rover.stereo, scenario.seed, 0);
  const StereoImages images = StereoRenderer().Render(scene, built.built_rig, truth.X_WR, sensor);
  double squares = 0.0;
  int count = 0;
  for (const bool right : {false, true}) {
    const Camera& camera = right ? built.built_rig.right : built.built_rig.left;
    const Pose3& X_RC = right ? built.built_rig.X_RQ : built.built_rig.X_RL;
    for (const FiducialPixels& fiducial : TrueFiducials(scene, camera, truth.X_WR * X_RC)) {
      if (!fiducial.whole || fiducial.hidden > 0.0) continue;
      const double range = (truth.X_WR * X_RC).p.x() - scene.boards[0].X_WB.p.x();
      const double radius_px = 0.05 * camera.focal_px().x() / range;
      const Eigen::Vector2d& centroid = *fiducial.centroid;
      if (!camera.Sees(centroid, 1.5 * radius_px + 2.0)) continue;
      squares += (InkCentroid(right ? images.right : images.left, centroid, radius_px) - centroid)
                     .squaredNorm();
      ++count;
    }
  }
  ASSERT_GE(count, 4);
  EXPECT_LT(std::sqrt(squares / count), 0.1) << count << " discs";
}

using Overrides = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(Ranges, StartView,
                         testing::Values(Overrides{"start.r_m=1.8"}, Overrides{"start.r_m=2"},
                                         Overrides{"start.r_m=3"}, Overrides{"start.r_m=4"}));
INSTANTIATE_TEST_SUITE_P(NavcamRanges, StartView,
                         testing::Values(Overrides{"start.r_m=1.8", kNavcam},
                                         Overrides{"start.r_m=3", kNavcam}));

TEST(SceneBuilder, HasTheSunOfTheTruthsTime) {
  const Scenario scenario = TypicalScenario({"sun.moving=true"});
  const BuiltRun built = Build(scenario);
  const World world(built.world);
  const SceneBuilder builder(built.world.rover, built.world.station, built.world.soil,
                             built.lighting, SiteOf(scenario), scenario.seed);
  Truth truth = world.truth();
  const SunAndSky start = builder.Make(truth, world.ground()).light;
  EXPECT_EQ(start.to_sun_W, built.lighting.sun_and_sky.to_sun_W);
  truth.time_s = 3600.0;
  const SunAndSky later = builder.Make(truth, world.ground()).light;
  EXPECT_EQ(later.to_sun_W, LightAt(built.lighting, 3600.0).to_sun_W);
  EXPECT_LT(later.to_sun_W.dot(start.to_sun_W), std::cos(Radians(10.0)));
}

TEST(FiducialTruth, ArmInFrontHidesWhatTheRendererHides) {
  // A plate a hand's breadth before one fiducial, and nothing before the others.
  Scene scene;
  scene.boards.resize(1);
  scene.boards[0].board.disc_diameter_m = 0.1;
  scene.boards[0].board.fiducials = {{.p_BF = {-0.3, 0.0}}, {.p_BF = {0.3, 0.0}}};
  scene.boards[0].X_WB.p = {0.0, 0.0, 2.0};
  auto plate = std::make_shared<RenderMesh>();
  plate->vertices = {
      {-0.4f, -0.2f, 1.9f}, {-0.3f, -0.2f, 1.9f}, {-0.3f, 0.2f, 1.9f}, {-0.4f, 0.2f, 1.9f}};
  plate->triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.objects.push_back({plate, Pose3{}, Eigen::Vector3d::Ones()});
  const auto truth = TrueFiducials(scene, EquidistantCamera(1024, 768, Radians(90.0)), Pose3{});
  // The plate's edge, seen from the origin, falls on x = -0.3 * 2 / 1.9 = -0.316 of the board:
  // 16 mm left of the disc's centre. Share of a disc beyond a chord at d / r = 0.316:
  const double share = (std::acos(0.3158) - 0.3158 * std::sqrt(1.0 - 0.3158 * 0.3158)) / kPi;
  EXPECT_NEAR(truth[0].hidden, share, 0.06);  // 91 samples
  EXPECT_EQ(truth[1].hidden, 0.0);
}

}  // namespace
}  // namespace dockyard::axel
