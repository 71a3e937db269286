// The built pyramid's marks give the lengths that the paper's equations are about.
#include "sim/raposa/mark_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "models/raposa/make_nominal.h"
#include "raposa/sim/drawn_pyramid.h"
#include "raposa/sim/pictures.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

/// Level, at the guide's height, the guide in its middle.
Pose3 CameraAt(double r_m, double alpha_rad) {
  Eigen::Matrix3d R_level;  // x right, y down, z along the view
  R_level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {RotZ(alpha_rad + kPi) * R_level,
          {r_m * std::cos(alpha_rad), r_m * std::sin(alpha_rad), 0.0}};
}

/// What (7) gives: its angle to 90 deg turns back at 73; beyond, as if the same end were visible.
double Published_deg(double alpha_deg) { return alpha_deg <= 73.0 ? alpha_deg : 146.0 - alpha_deg; }

// "Maximum angle for which the robot can see both colors without occlusions" (F, C.2): 110 deg. A
// camera forty times as fine and without blur shows the projection as it is.
TEST(MarkMeshes, HaveTheAnglesOfTheEquationAllTheWayTo110Deg) {
  const PyramidModel pyramid = LoadPyramid(SourceFile("models/raposa/pyramid/pyramid.yaml"));
  Nominal nominal = MakeNominal(LoadRobot(SourceFile("models/raposa/raposa.yaml")), pyramid);
  const double fx = 40.0 * nominal.camera.focal_px().x();
  nominal.camera = {4600, 1600, BrownPinhole{.fx = fx, .fy = fx, .cx = 2299.5, .cy = 799.5}};
  FerreiraVision vision = nominal.ferreira_vision;
  vision.orange = {.hue_from = 8, .hue_to = 18, .saturation_from = 150, .value_from = 60};
  vision.blue = {.hue_from = 105, .hue_to = 120, .saturation_from = 150, .value_from = 60};
  for (const double alpha_deg : {0.0, 30.0, 60.0, 80.0, 90.0, 110.0}) {
    const RgbImage image = DrawnPyramid(pyramid, nominal.camera, CameraAt(1.5, Radians(alpha_deg)));
    const auto found = FindMarks(ColourSearch(image), nominal, vision, std::nullopt);
    ASSERT_TRUE(found.pair) << alpha_deg;
    EXPECT_NEAR(Degrees(found.pair->angle.alpha_rad), Published_deg(alpha_deg), 1.0) << alpha_deg;
    if (alpha_deg > 0.0) {
      EXPECT_GT(found.pair->alpha_rad, 0.0) << alpha_deg;
    }
  }
}

// The area ratio's lower limit is the pyramid's own, from the side: what passes needs no blur.
TEST(MarkMeshes, ShowTheCameraFortyBluePixelsFrom110DegAt1500Mm) {
  const Picture view = PictureOf(ScenarioAt(1.5, Radians(110.0)), std::make_shared<KeptRenderer>());
  const HsvBand blue{.hue_from = 105, .hue_to = 116, .saturation_from = 69, .value_from = 30};
  double most_px2 = 0.0;
  for (const ColourBlob& blob : ColourSearch(view.image).Blobs(blue, 1.0)) {
    most_px2 = std::max(most_px2, blob.area_px2);
  }
  EXPECT_GE(most_px2, 40.0);
}

/// Mean and root mean square of (7)'s error over views of a place in the tuned bands' light.
struct AngleError {
  double bias_deg = 0.0, rms_deg = 0.0;
  int count = 0;
};
AngleError ErrorAt(double r_m, double alpha_deg, int views,
                   const std::shared_ptr<KeptRenderer>& renderer) {
  AngleError error;
  for (int i = 0; i < views; ++i) {
    RandomStream random(StreamKey(static_cast<std::uint64_t>(i) + 1, "views"));
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    Scenario scenario = ScenarioAt(r_m * random.Uniform(0.97, 1.03), side * Radians(alpha_deg), {},
                                   {}, static_cast<std::uint64_t>(i) + 1);
    scenario.light = Light::kRoom;
    const Picture view = PictureOf(scenario, renderer);
    FerreiraVision vision = view.nominal.ferreira_vision;
    vision.orange = {8, 18, 64, 255, 60, 255};
    vision.blue = {105, 116, 69, 255, 55, 255};
    const auto found = FindMarks(ColourSearch(view.image), view.nominal, vision, std::nullopt);
    if (!found.pair) continue;
    ++error.count;
    const double off_deg = Degrees(found.pair->angle.alpha_rad) - alpha_deg;
    error.bias_deg += off_deg;
    error.rms_deg += off_deg * off_deg;
  }
  error.bias_deg /= std::max(error.count, 1);
  error.rms_deg = std::sqrt(error.rms_deg / std::max(error.count, 1));
  return error;
}

// "For a greater distance, the angle estimation error is smaller" (F, F): pixels do not limit it.
TEST(MarkMeshes, GiveAnAngleOfWhichTheErrorDoesNotGrowWithTheDistance) {
  const auto renderer = std::make_shared<KeptRenderer>();
  const AngleError near = ErrorAt(1.33, 30.0, 16, renderer), far = ErrorAt(2.0, 30.0, 16, renderer);
  EXPECT_GE(near.count, 15);
  EXPECT_GE(far.count, 15);
  EXPECT_LT(std::abs(near.bias_deg), 3.0);
  EXPECT_LE(std::abs(far.bias_deg), std::abs(near.bias_deg) + 0.5);
  EXPECT_LT(near.rms_deg, 5.0);
  EXPECT_LT(far.rms_deg, 5.0);
}

// F, Fig. 11: "a very noisy example for which the robot docked".
TEST(MarkMeshes, AreFoundInANoisyImageOutdoors) {
  Scenario scenario =
      ScenarioAt(1.5, Radians(25.0), "light_k: 6500",
                 "robot: {camera: {full_well_e: 4000, read_noise_e: 40}}", 1, "grass");
  SceneryItem outdoors;
  outdoors.kind = SceneryItem::Kind::kOutdoors;
  outdoors.radius_m = 6.0;
  outdoors.count = 40;
  outdoors.clear_m = 0.8;
  scenario.scenery = {outdoors};
  const Picture view = PictureOf(scenario, std::make_shared<KeptRenderer>());
  FerreiraVision vision = view.nominal.ferreira_vision;
  vision.orange = {9, 23, 86, 255, 30, 255};
  vision.blue = {104, 115, 81, 255, 48, 255};
  const auto found = FindMarks(ColourSearch(view.image), view.nominal, vision, std::nullopt);
  ASSERT_TRUE(found.pair);
  EXPECT_NEAR(Degrees(found.pair->alpha_rad), 25.0, 6.0);
  EXPECT_NEAR(found.pair->angle.r_m, 1.5, 0.2);
}

}  // namespace
}  // namespace dockyard::raposa
