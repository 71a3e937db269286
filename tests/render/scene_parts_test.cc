// Scenes with other parts than a yard's: no board, several cables, a point of interest, a plain
// floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/measure.h"
#include "render/scene_painter.h"

namespace dockyard {
namespace {

const Camera kPartsCamera = EquidistantCamera(320, 240, 0.8);

std::array<RadianceImage, 3> Draw(const Scene& scene, const Eigen::Vector3d& from_W,
                                  const Eigen::Vector3d& target_W) {
  return StereoRenderer().RenderColourFrom(scene, kPartsCamera, LookAt(from_W, target_W), target_W);
}

TetherView Cable(double z_m, const Eigen::Vector3d& albedo) {
  return {.points_W = {{2.0, -0.5, z_m}, {2.0, 0.5, z_m}}, .diameter_m = 0.009, .albedo = albedo};
}

/// Two cables 2 m ahead, one 0.2 m over the other, in the light of an even sky.
Scene TwoCables(const TetherView& first, const TetherView& second) {
  Scene scene;
  scene.light.sun_irradiance = 0.0;
  scene.tether = first;
  scene.cables = {second};
  return scene;
}

// Light that a cable takes from the sky behind it or adds to it, in a column of the image.
double ChangeNear(const RadianceImage& image, const RadianceImage& bare, double z_m) {
  const Eigen::Vector2d pixel = *kPartsCamera.Project(LookAt({0, 0, 0}, {2, 0, 0}).R.transpose() *
                                                      Eigen::Vector3d(2.0, 0.0, z_m));
  double sum = 0.0;
  for (int dy = -4; dy <= 4; ++dy) {
    const int y = static_cast<int>(std::lround(pixel.y())) + dy;
    sum += image.at(160, y) / bare.at(160, y) - 1.0;
  }
  return sum;
}

// Where the albedo is zero the sky is missing over the cable's width, 9 mm in 2 m; where it is not,
// less of it. Mean of eight places within a ray's distance, 5.6 mm.
TEST(Cables, EachHasItsOwnColourAndWidth) {
  const auto bare = Draw(TwoCables({}, {}), {0, 0, 0}, {2, 0, 0});
  const double width_px = kPartsCamera.focal_px().y() * 0.009 / 2.0;
  constexpr int kPlaces = 8;
  Eigen::Vector3d above = Eigen::Vector3d::Zero(), below = Eigen::Vector3d::Zero();
  for (int i = 0; i < kPlaces; ++i) {
    const double z_m = 0.1 + 0.0056 * i / kPlaces;
    const TetherView red = Cable(z_m, {0.9, 0.0, 0.0}), green = Cable(-z_m, {0.0, 0.9, 0.0});
    const auto image = Draw(TwoCables(red, green), {0, 0, 0}, {2, 0, 0});
    for (int channel = 0; channel < 3; ++channel) {
      above[channel] += ChangeNear(image[channel], bare[channel], z_m) / kPlaces;
      below[channel] += ChangeNear(image[channel], bare[channel], -z_m) / kPlaces;
    }
  }
  EXPECT_NEAR(above.y(), -width_px, 0.06 * width_px);
  EXPECT_NEAR(above.z(), -width_px, 0.06 * width_px);
  EXPECT_NEAR(below.x(), -width_px, 0.06 * width_px);
  EXPECT_NEAR(below.z(), -width_px, 0.06 * width_px);
  EXPECT_GT(above.x(), -0.7 * width_px);
  EXPECT_GT(below.y(), -0.7 * width_px);
}

TEST(Cables, AreAllAlikeWhateverTheirOrder) {
  const TetherView red = Cable(0.1, {0.9, 0.0, 0.0}), green = Cable(-0.1, {0.0, 0.9, 0.0});
  const auto one = Draw(TwoCables(red, green), {0, 0, 0}, {2, 0, 0});
  const auto other = Draw(TwoCables(green, red), {0, 0, 0}, {2, 0, 0});
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(one[channel].values, other[channel].values);
  }
}

TEST(Cables, AllThrowShadows) {
  Scene scene = TwoCables({}, {});
  scene.light.sun_irradiance = 1.0;
  scene.light.sky_irradiance = 0.0;
  scene.light.to_sun_W = {-1, 0, 0};
  scene.objects = {{std::make_shared<const RenderMesh>(BoxToRender({0.01, 2.0, 2.0})),
                    Pose3::Translation(2.5, 0, 0), Eigen::Vector3d::Ones()}};
  const auto lit = Draw(scene, {0, 0, 0.6}, {2.5, 0, 0});
  scene.cables = {Cable(-0.1, {0, 0, 0}), Cable(0.1, {0, 0, 0})};
  const auto shaded = Draw(scene, {0, 0, 0.6}, {2.5, 0, 0});
  const Pose3 X_CW = Inverse(LookAt({0, 0, 0.6}, {2.5, 0, 0}));
  for (const double z : {-0.1, 0.1}) {
    const Eigen::Vector2d shadow = *kPartsCamera.Project(X_CW * Eigen::Vector3d(2.495, 0.0, z));
    EXPECT_LT(RadianceAt(shaded[0], shadow), 0.6 * RadianceAt(lit[0], shadow)) << z;
  }
}

// Sum of what a dark box covers of an even bright wall, in pixels.
double CoveredPixels(StereoRenderer& renderer, bool with_interest, double y_m) {
  Scene scene;
  scene.light.sun_irradiance = 0.0;
  const auto box = std::make_shared<const RenderMesh>(BoxToRender({0.001, 0.02, 0.02}));
  const auto wall = std::make_shared<const RenderMesh>(BoxToRender({0.001, 9.0, 9.0}));
  scene.objects = {{box, Pose3::Translation(2.0, y_m, 0.0), Eigen::Vector3d::Zero()},
                   {wall, Pose3::Translation(2.1, 0, 0), Eigen::Vector3d::Ones()}};
  if (with_interest) scene.interest = Interest{.p_W = {2.0, y_m, 0.0}, .radius_m = 0.05};
  const auto image =
      renderer.RenderColourFrom(scene, kPartsCamera, LookAt({0, 0, 0}, {2, 0, 0}), {2, 0, 0})[1];
  const double wall_value = image.at(20, 120);
  double covered = 0.0;
  for (int y = 90; y < 150; ++y) {
    for (int x = 130; x < 190; ++x) covered += 1.0 - image.at(x, y) / wall_value;
  }
  return covered;
}

// 400 px/rad: a side of 4 px. Its area scatters with its place among the rays.
TEST(Interest, SmallThingsKeepTheirAreaBetter) {
  const double exact = std::pow(kPartsCamera.focal_px().x() * 0.02 / 1.9995, 2);
  StereoRenderer renderer;
  double with = 0.0, without = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double y_m = 0.0011 * i;
    with = std::max(with, std::abs(CoveredPixels(renderer, true, y_m) - exact));
    without = std::max(without, std::abs(CoveredPixels(renderer, false, y_m) - exact));
  }
  EXPECT_LT(with, 0.13 * exact);
  EXPECT_LT(with, 0.75 * without);
}

TEST(Floor, WithoutGrainIsEven) {
  const std::vector<double> heights(9, 0.0);
  Scene scene;
  scene.ground = {.X_WG = {}, .x0_m = -5, .y0_m = -5, .cell_m = 5, .nx = 3, .ny = 3};
  scene.ground.heights_m = heights.data();
  scene.light.to_sun_W = {0, 0, 1};
  const auto spread = [&](double grain) {
    scene.ground.grain = grain;
    const auto image = Draw(scene, {0, 0, 0.5}, {2, 0, 0})[0];
    const auto [least, most] =
        std::minmax_element(image.values.begin() + 320 * 120, image.values.begin() + 320 * 200);
    return *most / *least;
  };
  EXPECT_NEAR(spread(0.0), 1.0, 1e-5);
  EXPECT_GT(spread(1.0), 1.2);
}

TEST(Scene, RefusesLampsAndInterestsThatAreNone) {
  Scene scene;
  RequireSoundScene(scene);
  scene.lamps = {{.axis_W = {0, 0, 2}}};
  EXPECT_DEATH(RequireSoundScene(scene), "check failed");
  scene.lamps = {{.half_angle_rad = 1.6}};
  EXPECT_DEATH(RequireSoundScene(scene), "check failed");
  scene.lamps.clear();
  scene.interest = Interest{};
  EXPECT_DEATH(RequireSoundScene(scene), "check failed");
}

}  // namespace
}  // namespace dockyard
