// What cameras of a robot from files see: boards that are not flat, and colours.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/custom/sighting.h"
#include "controller/vision/homography.h"
#include "controller/vision/tags/find_tags.h"
#include "custom/charger_rig.h"
#include "render/stereo_renderer.h"
#include "sim/custom/custom_plant.h"
#include "sim/custom/custom_view.h"
#include "sim/plant/renderer.h"
#include "sim/plant/sun_motion.h"

namespace dockyard::custom {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A scene of the charger as its camera sees it, without noise.
struct Sight {
  std::vector<FoundTag> tags;
  Camera camera;
  Pose3 X_CB;  // of a flat board
  BoardFit board;
};

Sight See(const std::string& boards_as_built) {
  const Scenario scenario =
      ChargerScenario({"start={r_m: 0.45, alpha_deg: 35, heading_deg: 30}", "scenery=[]",
                       "as_built={dock: {boards_as_built: " + boards_as_built + "}}"});
  const BuiltRun built = BuildRun(scenario, LoadModels(scenario));
  const World world(built.world);
  const Truth truth = world.truth();
  const CameraFit& fit = built.world.robot.cameras[0];
  const auto link = static_cast<std::size_t>(fit.link);
  const Pose3 X_WC = truth.X_WL[link] * fit.model.X_LC;
  Sight sight{
      .tags = {}, .camera = fit.model.nominal, .X_CB = {}, .board = built.world.dock.boards[0]};
  sight.X_CB =
      Inverse(X_WC) * truth.X_WK[static_cast<std::size_t>(sight.board.link)] * sight.board.X_LB;
  StereoRenderer renderer;
  const Scene scene = SceneBuilder(built, scenario.seed).Make(truth, world.ground(), fit.link);
  const RadianceImage light = renderer.RenderGrey(scene, sight.camera, X_WC);
  const double brightest = *std::max_element(light.values.begin(), light.values.end());
  GrayImage image{light.width, light.height, {}};
  for (const float value : light.values) {
    image.pixels.push_back(static_cast<std::uint8_t>(std::lround(220.0 * value / brightest)));
  }
  sight.tags = FindTags(image, sight.board.board.tags[0].family, &sight.camera);
  return sight;
}

/// A place on a plate that bends across its x axis: an arc as long as the print whose middle is
/// out by the bow, its edges in the plane.
Vector3d OnArc(const FiducialBoard& board, double bow_m, const Vector2d& p) {
  const double half_m = 0.5 * board.width_m;
  double low = 0.0, high = 2.0 / half_m;
  for (int i = 0; i < 60; ++i) {
    const double bend = 0.5 * (low + high);
    ((1.0 - std::cos(bend * half_m)) / bend < bow_m ? low : high) = bend;
  }
  return {std::sin(low * p.x()) / low, p.y(), (1.0 - std::cos(low * p.x())) / low - bow_m};
}

/// The corners of the flat tag that comes nearest to the bent one in the image: that is what is
/// fitted to it. The camera is a pinhole.
std::array<Vector2d, 4> NearestFlatTag(const Sight& sight, double bow_m) {
  const SquareTag& tag = sight.board.board.tags[0];
  constexpr int kSteps = 10;
  std::vector<PlanePair> pairs;
  for (int i = 0; i <= kSteps; ++i) {
    for (int k = 0; k <= kSteps; ++k) {
      const Vector2d p = tag.size_m * Vector2d(i - 0.5 * kSteps, k - 0.5 * kSteps) / kSteps;
      const Vector3d p_B = OnArc(sight.board.board, bow_m, p);
      pairs.push_back({p, *sight.camera.Project(sight.X_CB * p_B)});
    }
  }
  const Eigen::Matrix3d H = *FitHomography(pairs);
  std::array<Vector2d, 4> corners = CornersOf(tag);
  for (Vector2d& corner : corners) corner = *Map(H, corner);
  return corners;
}

TEST(CustomImages, CornersOfABentBoardMoveAsItsArcSays) {
  const double bow_m = 0.004;
  const Sight flat = See("{flatness_m: 0}"), bent = See("{flatness_m: 0.004}");
  ASSERT_EQ(flat.tags.size(), 1u);
  ASSERT_EQ(bent.tags.size(), 1u);
  EXPECT_DOUBLE_EQ(bent.board.flatness_m, bow_m);
  const auto corners = CornersOf(bent.board.board.tags[0]);
  const auto wanted = NearestFlatTag(bent, bow_m);
  Vector2d middle_off(0.0, 0.0), middle_moved(0.0, 0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3d p_B(corners[i].x(), corners[i].y(), 0.0);
    const Vector2d at = *flat.camera.Project(flat.X_CB * p_B);
    const Vector2d moved = bent.tags[0].corners[i] - flat.tags[0].corners[i];
    std::printf("corner %zu: moved by %.2f %.2f px, wanted %.2f %.2f\n", i, moved.x(), moved.y(),
                (wanted[i] - at).x(), (wanted[i] - at).y());
    EXPECT_LT((flat.tags[0].corners[i] - at).norm(), 0.1) << i;
    // What is fitted weighs the squares' edges, and this an even grid.
    EXPECT_LT((moved - (wanted[i] - at)).norm(), 0.3) << i;
    middle_off += 0.25 * (moved - (wanted[i] - at));
    middle_moved += 0.25 * moved;
  }
  EXPECT_LT(middle_off.norm(), 0.05);
  EXPECT_GT(middle_moved.norm(), 1.5);
}

TEST(CustomImages, HaveTheSunOfTheTruthsTime) {
  const Scenario scenario = ChargerScenario({"light=even", "sun.moving=true"});
  const BuiltRun built = BuildRun(scenario, LoadModels(scenario));
  const World world(built.world);
  const SceneBuilder builder(built, scenario.seed);
  Truth truth = world.truth();
  const SunAndSky start = builder.Make(truth, world.ground(), 0).light;
  EXPECT_EQ(start.to_sun_W, built.lighting.sun_and_sky.to_sun_W);
  truth.time_s = 3600.0;
  const SunAndSky later = builder.Make(truth, world.ground(), 0).light;
  EXPECT_EQ(later.to_sun_W, LightAt(built.lighting, 3600.0).to_sun_W);
  EXPECT_LT(later.to_sun_W.dot(start.to_sun_W), std::cos(Radians(10.0)));
}

/// One image of the scenario's start.
CameraImage ImageOf(const std::vector<std::string>& overrides, Nominal& nominal, Pose3& X_CB) {
  std::vector<std::string> all{"start={r_m: 0.6, alpha_deg: 10, heading_deg: 10}"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  const Scenario scenario = ChargerScenario(all);
  CustomPlant plant(scenario, BuildRun(scenario, LoadModels(scenario)),
                    std::make_shared<KeptRenderer>());
  plant.Sense();
  nominal = plant.built().nominal;
  X_CB = Inverse(plant.truth().X_DR * nominal.cameras[0].X_RC) * nominal.boards[0].X_DB;
  return plant.TakeImages({0}, 0.0).at(0);
}

const std::vector<std::string> kColour{
    "changes={robot: {cameras: [{name: front, link: camera_link, field_of_view_deg: 75, width_px: "
    "640, height_px: 480, colour: true}]}}"};

/// Mean of a channel in a square of the image about the pixel of a place.
std::array<double, 3> ColourAt(const RgbImage& image, const Vector2d& pixel, int half_px) {
  std::array<double, 3> sum{};
  const int u0 = static_cast<int>(std::lround(pixel.x())),
            v0 = static_cast<int>(std::lround(pixel.y()));
  for (int v = v0 - half_px; v <= v0 + half_px; ++v) {
    for (int u = u0 - half_px; u <= u0 + half_px; ++u) {
      for (int k = 0; k < 3; ++k) {
        sum[static_cast<std::size_t>(k)] +=
            image.pixels[3 * static_cast<std::size_t>(v * image.width + u) +
                         static_cast<std::size_t>(k)];
      }
    }
  }
  for (double& each : sum) each /= (2 * half_px + 1) * (2 * half_px + 1);
  return sum;
}

TEST(CustomImages, ColourCameraTellsColoursApart) {
  std::vector<std::string> overrides = kColour;
  // Two panels behind the mast, one on either side.
  overrides.push_back(
      "scenery=[{kind: box, length_m: 0.02, width_m: 0.2, height_m: 0.5, x_m: -0.12, y_m: 0.2, "
      "colour: brick}, {kind: box, length_m: 0.02, width_m: 0.2, height_m: 0.5, x_m: -0.12, y_m: "
      "-0.2, colour: denim}]");
  Nominal nominal;
  Pose3 X_CB;
  const CameraImage taken = ImageOf(overrides, nominal, X_CB);
  const RgbImage& image = std::get<RgbImage>(taken.pixels);
  EXPECT_EQ(image.width, 640);
  const Pose3 X_CD = X_CB * Inverse(nominal.boards[0].X_DB);
  const auto at = [&](const Vector3d& p_D, int half_px) {
    const auto colour = ColourAt(image, *nominal.cameras[0].camera.Project(X_CD * p_D), half_px);
    std::printf("%.1f %.1f %.1f\n", colour[0], colour[1], colour[2]);
    return colour;
  };
  const auto brick = at({-0.11, 0.2, 0.25}, 5), denim = at({-0.11, -0.2, 0.25}, 5);
  const auto paper = at({-0.055, 0.0, 0.27}, 1);  // the tag's white margin
  EXPECT_GT(brick[0], 1.3 * brick[1]);
  EXPECT_GT(brick[1], brick[2]);
  EXPECT_GT(denim[2], 1.2 * denim[0]);
  EXPECT_NEAR(paper[0] / paper[1], 1.0, 0.1);
  EXPECT_NEAR(paper[2] / paper[1], 1.0, 0.1);
}

/// How far the nearer of a tag's two poses lies from where the board is.
double PoseError(const CameraImage& image, const Nominal& nominal, const Pose3& X_CB) {
  const auto sightings = (*PerceiveTags(nominal))(image, Vector3d::UnitZ());
  double nearest_m = 1e9;
  for (const PoseBranch& branch : sightings.at(0).branches) {
    nearest_m = std::min(nearest_m, (branch.X_CB.p - X_CB.p).norm());
  }
  return nearest_m;
}

TEST(CustomImages, TagIsLocatedInColourAsInGrey) {
  Nominal nominal;
  Pose3 X_CB;
  const CameraImage grey = ImageOf({}, nominal, X_CB);
  ASSERT_TRUE(std::holds_alternative<GrayImage>(grey.pixels));
  const double off_grey_m = PoseError(grey, nominal, X_CB);
  const CameraImage colour = ImageOf(kColour, nominal, X_CB);
  ASSERT_TRUE(std::holds_alternative<RgbImage>(colour.pixels));
  ASSERT_TRUE(nominal.cameras[0].colour);
  const double off_colour_m = PoseError(colour, nominal, X_CB);
  std::printf("off by %.2f mm in grey, %.2f mm in colour\n", 1e3 * off_grey_m, 1e3 * off_colour_m);
  // Of 0.4 m: mostly the camera's mounting and focal length as built.
  EXPECT_LT(off_grey_m, 0.01);
  EXPECT_LT(off_colour_m, 0.01);
}

}  // namespace
}  // namespace dockyard::custom
