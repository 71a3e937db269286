// One compositor for all cameras: boards in colour, lamps in grey, several boards in one image.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/colour_samples.h"
#include "render/measure.h"

namespace dockyard {
namespace {

Camera PlainCamera() { return EquidistantCamera(320, 240, kPi / 2); }
Pose3 BeforeTheBoard() { return LevelRover(1.0, 0.1, kPi, 0.75) * ForwardCamera(0.0, 0.0, 0.0); }

/// White light on even greys; light bounces off what grey images take for the ground.
ColourTable WhiteTable(const Scene& scene) {
  const Spectrum light = PlanckLight(5000.0);
  return MakeColourTable({.sun = light,
                          .sky = light,
                          .lamps = {light},
                          .materials = {EvenGrey(scene.light.ground_bounce_albedo)}},
                         CheapCamera());
}

ColourRadiance InColour(const Scene& scene) {
  return StereoRenderer().RenderThrough(scene, WhiteTable(scene), {.camera = PlainCamera()},
                                        {BeforeTheBoard()});
}
RadianceImage InGrey(const Scene& scene) {
  return StereoRenderer().RenderRadiance(scene, RigAt(PlainCamera(), BeforeTheBoard()), {})[0];
}

/// The range of the values about a pixel.
double ContrastAbout(const RadianceImage& image, int x, int y) {
  double least = image.at(x, y), most = least;
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      least = std::min<double>(least, image.at(u, v));
      most = std::max<double>(most, image.at(u, v));
    }
  }
  return most - least;
}

// Light is measured in the camera's green, so a grey camera's radiance of grey things in white
// light is the colour camera's green. The rays of the two cameras differ, so edges are left out.
TEST(Compositor, ColourCameraSeesABoardAsAGreyOneDoes) {
  Scene scene = BoardOnly();
  scene.lamps = {{.p_W = {1.0, 0.2, 0.9}, .axis_W = {-1, 0, 0}, .irradiance_1m = 0.4}};
  const RadianceImage grey = InGrey(scene);
  const ColourRadiance colour = InColour(scene);
  double darkest = 1e9, brightest = 0.0;
  int count = 0;
  for (int y = 60; y < 180; ++y) {
    for (int x = 80; x < 240; ++x) {
      const double expected = grey.at(x, y), green = colour.part[1].at(x, y);
      if (ContrastAbout(grey, x, y) > 0.03 * expected) continue;
      EXPECT_NEAR(green, expected, 1e-3 * expected) << x << " " << y;
      darkest = std::min(darkest, green);
      brightest = std::max(brightest, green);
      ++count;
    }
  }
  EXPECT_GT(brightest / darkest, 8.0);  // paints of 0.85 and 0.05
  EXPECT_GT(count, 3000);
}

// The plate's outline, which rays decide: the same area in both images. A pixel of the colour
// camera has few rays; the error of an area is under 1 %.
TEST(Compositor, BoardHasTheSameOutlineInColour) {
  Scene scene = BoardOnly();
  scene.boards[0].board.fiducials.clear();
  scene.light.sky_irradiance = 0.0;
  scene.light.ground_bounce_albedo = 0.0;
  const RadianceImage grey = InGrey(scene);
  const ColourRadiance colour = InColour(scene);
  const double white = grey.at(160, 120);
  double of_grey = 0.0, of_colour = 0.0;
  for (std::size_t i = 0; i < grey.values.size(); ++i) {
    of_grey += grey.values[i] / white;
    of_colour += colour.part[1].values[i] / white;
  }
  EXPECT_GT(of_grey, 2000.0);
  EXPECT_NEAR(of_colour, of_grey, 0.01 * of_grey);
}

// Radiance albedo / pi * E_1m * cos(to the lamp) / distance^2, with the beam's power law.
double LampLit(const Lamp& lamp, const Eigen::Vector3d& p_W, const Eigen::Vector3d& n_W,
               double albedo) {
  const Eigen::Vector3d to_lamp = lamp.p_W - p_W;
  const double off = -lamp.axis_W.dot(to_lamp.normalized());
  const double power = std::log(0.5) / std::log(std::cos(lamp.half_angle_rad));
  return albedo / kPi * lamp.irradiance_1m * std::pow(off, power) * n_W.dot(to_lamp.normalized()) /
         to_lamp.squaredNorm();
}

TEST(Compositor, GreyCameraSeesALampOnBoardObjectAndGround) {
  const std::vector<double> level(9, 0.0);
  Scene scene = BoardOnly();
  scene.boards[0].board.fiducials.clear();
  scene.light.sun_irradiance = scene.light.sky_irradiance = 0.0;
  scene.objects.push_back({std::make_shared<const RenderMesh>(BoxToRender({0.2, 3.0, 0.2})),
                           Pose3::Translation(0.0, 0.0, 0.1), Eigen::Vector3d(0.3, 0.3, 0.3)});
  scene.ground = {.X_WG = {},
                  .x0_m = -5.0,
                  .y0_m = -5.0,
                  .cell_m = 5.0,
                  .nx = 3,
                  .ny = 3,
                  .heights_m = level.data(),
                  .albedo = Eigen::Vector3d::Constant(0.2),
                  .grain = 0.0};
  scene.lamps = {{.p_W = {1.0, 0.1, 0.8},
                  .axis_W = Eigen::Vector3d(-1, 0, -0.3).normalized(),
                  .half_angle_rad = 0.6,
                  .irradiance_1m = 2.0}};
  const Pose3 X_WC = BeforeTheBoard();
  const RadianceImage grey = InGrey(scene);
  const auto expect = [&](const Eigen::Vector3d& p_W, const Eigen::Vector3d& n_W, double albedo) {
    const auto pixel = PlainCamera().Project(Inverse(X_WC) * p_W);
    ASSERT_TRUE(pixel);
    const int x = static_cast<int>(std::lround(pixel->x()));
    const int y = static_cast<int>(std::lround(pixel->y()));
    const double exact = LampLit(scene.lamps[0], p_W, n_W, albedo);
    EXPECT_NEAR(grey.at(x, y), exact, 0.03 * exact) << p_W.transpose();  // half a pixel aside
  };
  expect({0.0, 0.1, 0.6}, {1, 0, 0}, scene.boards[0].white_albedo);
  expect({0.1, -0.1, 0.19}, {1, 0, 0}, 0.3);
  expect({-1.0, 1.0, 0.0}, {0, 0, 1}, 0.2);
}

// Two boards that hide nothing of each other: each half of the image is that of its board alone.
TEST(Compositor, TwoBoardsInOneImageAreEachAsAlone) {
  Scene scene = BoardOnly();
  scene.light.ground_bounce_albedo = 0.0;
  scene.boards[0].X_WB = UprightBoard(0.0, 0.7, 0.75);
  BoardView second = scene.boards[0];
  second.X_WB = UprightBoard(0.0, -0.5, 0.75);
  Scene alone = scene, other = scene;
  other.boards = {second};
  scene.boards.push_back(second);
  const RadianceImage both = InGrey(scene), left = InGrey(other), right = InGrey(alone);
  double error = 0.0, contrast = 0.0;
  for (int y = 0; y < both.height; ++y) {
    for (int x = 0; x < both.width; ++x) {
      const bool on_left = x < both.width / 2;
      const double expected = (on_left ? left : right).at(x, y);
      error += std::abs(both.at(x, y) - expected);
      contrast += std::abs(both.at(x, y) - (on_left ? right : left).at(x, y));
    }
  }
  EXPECT_GT(contrast, 1000.0);
  EXPECT_LT(error, 0.01 * contrast);
}

}  // namespace
}  // namespace dockyard
