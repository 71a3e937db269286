// The truth that "dockyard view" writes, against the rendered pictures themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "models/load_scenario.h"
#include "render/stereo_renderer.h"
#include "sim/run/build_run.h"
#include "sim/run/fiducial_truth.h"
#include "sim/run/view.h"

namespace dockyard {
namespace {

const std::string kScenario = std::string(DOCKYARD_SOURCE_DIR) + "/scenarios/axel_typical.yaml";

/// Centroid of what is darker than the plate in a window, the bar filled in: the plate's level
/// comes from the window's border. Knows nothing of the camera.
Eigen::Vector2d DarkCentroid(const GrayImage& image, const Eigen::Vector2d& near, int half) {
  const int x0 = static_cast<int>(std::lround(near.x())) - half;
  const int y0 = static_cast<int>(std::lround(near.y())) - half;
  const int side = 2 * half + 1;
  double border = 0.0;
  for (int i = 0; i < side; ++i) {
    border += image.at(x0 + i, y0) + image.at(x0 + i, y0 + side - 1) + image.at(x0, y0 + i) +
              image.at(x0 + side - 1, y0 + i);
  }
  border /= 4.0 * side;
  // The disc and its bar are symmetric about one centre: the bar's light shifts nothing.
  double weight = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (int y = y0; y < y0 + side; ++y) {
    for (int x = x0; x < x0 + side; ++x) {
      const double dark = border - image.at(x, y);
      weight += dark;
      moment += dark * Eigen::Vector2d(x, y);
    }
  }
  return moment / weight;
}

class StartView : public testing::TestWithParam<const char*> {};

TEST_P(StartView, DiscCentroidsLieWhereThePictureHasThem) {
  const Scenario scenario =
      LoadScenario(kScenario, {std::string("start.r_m=") + GetParam(), "start.alpha_deg=0"});
  BuiltRun built = BuildRun(scenario);
  const World world(built.world);
  const Truth truth = world.truth();
  const SceneBuilder builder(built.world.rover, built.world.station, built.world.soil,
                             built.lighting, scenario.X_WG, scenario.seed);
  const Scene scene = builder.Make(truth, world.ground());
  SensorOptions sensor = CameraSensor(built.world.rover.stereo, scenario.seed, 0);
  const StereoImages images = StereoRenderer().Render(scene, built.built_rig, truth.X_WR, sensor);
  double squares = 0.0;
  int count = 0;
  for (const bool right : {false, true}) {
    const FisheyeCamera& camera = right ? built.built_rig.right : built.built_rig.left;
    const Pose3& X_RC = right ? built.built_rig.X_RQ : built.built_rig.X_RL;
    for (const FiducialPixels& fiducial : TrueFiducials(scene, camera, truth.X_WR * X_RC)) {
      if (!fiducial.whole || fiducial.hidden > 0.0) continue;
      const double range = (truth.X_WR * X_RC).p.x() - scene.board.X_WB.p.x();
      const int half = static_cast<int>(std::lround(0.075 * camera.fx / range)) + 2;
      const Eigen::Vector2d& centroid = *fiducial.centroid;
      if (!camera.Sees(centroid, half + 1.0)) continue;
      squares += (DarkCentroid(right ? images.right : images.left, centroid, half) - centroid)
                     .squaredNorm();
      ++count;
    }
  }
  ASSERT_GE(count, 4);
  EXPECT_LT(std::sqrt(squares / count), 0.1) << count << " discs";
}

INSTANTIATE_TEST_SUITE_P(Ranges, StartView, testing::Values("1.8", "2", "3", "4"));

TEST(FiducialTruth, ArmInFrontHidesWhatTheRendererHides) {
  // A plate a hand's breadth before one fiducial, and nothing before the others.
  Scene scene;
  scene.board.board.disc_diameter_m = 0.1;
  scene.board.board.fiducials = {{.p_BF = {-0.3, 0.0}}, {.p_BF = {0.3, 0.0}}};
  scene.board.X_WB.p = {0.0, 0.0, 2.0};
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
}  // namespace dockyard
