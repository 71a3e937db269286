// Objects, occlusion, shadows, ground; and that only relative places matter.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "render/measure.h"
#include "render/scene_painter.h"

namespace dockyard {
namespace {

std::shared_ptr<const RenderMesh> Share(RenderMesh mesh) {
  return std::make_shared<const RenderMesh>(std::move(mesh));
}

const Camera kCamera = EquidistantCamera(640, 480, kPi / 2);

// Flat ground without texture worth speaking of after averaging.
struct FlatYard {
  FlatYard() {
    scene.ground = {.X_WG = {},
                    .x0_m = -3,
                    .y0_m = -3,
                    .cell_m = 0.1,
                    .nx = 61,
                    .ny = 61,
                    .heights_m = heights.data()};
  }
  std::vector<double> heights = std::vector<double>(61 * 61, 0.0);
  Scene scene;
};

double MeanRound(const RadianceImage& image, const Eigen::Vector2d& pixel, int half) {
  double sum = 0.0;
  for (int dy = -half; dy <= half; ++dy) {
    for (int dx = -half; dx <= half; ++dx) {
      sum += RadianceAt(image, pixel + Eigen::Vector2d(dx, dy));
    }
  }
  return sum / ((2 * half + 1) * (2 * half + 1));
}

TEST(Object, IsDrawnWhereTheCameraModelSays) {
  Scene scene;
  scene.light = {.to_sun_W = {0, 0, 1}, .sun_irradiance = 0.0, .sky_irradiance = 1.0};
  const Pose3 X_WC = LookAt({0, 0, 0}, {3, 0, 0.1});
  const RenderMesh plate = BoxToRender({0.002, 0.3, 0.3});
  scene.objects.push_back({Share(plate), Pose3::Translation(2.0, 0.7, 0.4), {0, 0, 0}});
  const RadianceImage image = StereoRenderer().RenderRadiance(scene, RigAt(kCamera, X_WC), {})[0];
  const auto at = [&](double y, double z) {
    const Eigen::Vector3d rim(1.999, y, z);
    return RadianceAt(image, *kCamera.Project(Inverse(X_WC) * rim));
  };
  // Black inside, sky outside: 7 mm are one pixel there.
  for (const double along : {-0.1, 0.0, 0.1}) {
    EXPECT_LT(at(0.55 + 0.007, 0.4 + along), 0.05);
    EXPECT_GT(at(0.55 - 0.007, 0.4 + along), 0.2);
    EXPECT_LT(at(0.85 - 0.007, 0.4 + along), 0.05);
    EXPECT_GT(at(0.85 + 0.007, 0.4 + along), 0.2);
    EXPECT_LT(at(0.7 + along, 0.25 + 0.007), 0.05);
    EXPECT_GT(at(0.7 + along, 0.25 - 0.007), 0.2);
    EXPECT_LT(at(0.7 + along, 0.55 - 0.007), 0.05);
    EXPECT_GT(at(0.7 + along, 0.55 + 0.007), 0.2);
  }
}

TEST(Shadow, OnASlopeIsAsLongAsTheAnglesSay) {
  // A post of height H, upright on a slope of angle a that falls away from the sun of elevation e:
  // the law of sines gives a shadow of H cos(e) / sin(e - a) along the slope; uphill, e + a.
  const double height = 0.5, elevation = Radians(40.0);
  for (const double slope_deg : {-15.0, 0.0, 15.0}) {
    const double slope = Radians(slope_deg);
    FlatYard yard;
    Scene& scene = yard.scene;
    scene.ground.X_WG.R = RotY(slope);  // x is the way down, the shadow's way
    scene.light = {.to_sun_W = SunAt(kPi, elevation), .sky_irradiance = 0.0};
    scene.objects.push_back({Share(BoxToRender({0.06, 0.2, height})),
                             Pose3::Translation(-0.03, 0.0, 0.5 * height),
                             {0.5, 0.5, 0.5}});
    const double wanted = height * std::cos(elevation) / std::sin(elevation - slope);
    const Eigen::Vector3d off = scene.ground.X_WG.R.col(2), along = scene.ground.X_WG.R.col(0);
    const Pose3 X_WC =
        LookAt(wanted * along + 2.0 * off + Eigen::Vector3d(0.02, 0.0, 0.0), wanted * along);
    const RadianceImage image = StereoRenderer().RenderRadiance(scene, RigAt(kCamera, X_WC), {})[0];
    const auto at = [&](double x) {
      return MeanRound(image, *kCamera.Project(Inverse(X_WC) * Eigen::Vector3d(x * along)), 3);
    };
    const double lit = at(wanted + 0.1);
    EXPECT_GT(lit, 0.05) << slope_deg;
    EXPECT_LT(at(wanted - 0.03), 0.2 * lit) << slope_deg;
    EXPECT_GT(at(wanted + 0.03), 0.7 * lit) << slope_deg;
  }
}

TEST(Object, InFrontHidesTheBoard) {
  Scene scene = BoardOnly();
  const Fiducial& f = scene.boards[0].board.fiducials[0];
  const Eigen::Vector3d disc_W =
      scene.boards[0].X_WB * Eigen::Vector3d(f.p_BF.x() + 0.03, f.p_BF.y() + 0.02, 0);
  const Eigen::Vector3d from(1.5, 0, 0.7);
  const Eigen::Vector3d between = from + 0.5 * (disc_W - from);
  const Pose3 X_WC = LookAt(from, {0, 0, 0.7});
  const StereoRig rig = RigAt(kCamera, X_WC);
  const Eigen::Vector2d pixel = *kCamera.Project(Inverse(X_WC) * disc_W);
  StereoRenderer renderer;
  const double bare = RadianceAt(renderer.RenderRadiance(scene, rig, {})[0], pixel);
  scene.objects.push_back({Share(BoxToRender({0.02, 0.1, 0.1})),
                           Pose3::Translation(between.x(), between.y(), between.z()),
                           {0.6, 0.6, 0.6}});
  const double hidden = RadianceAt(renderer.RenderRadiance(scene, rig, {})[0], pixel);
  EXPECT_NEAR(bare, UnshadedRadiance(scene.light, {1, 0, 0}, 0.05), 1e-4);
  EXPECT_NEAR(hidden, UnshadedRadiance(scene.light, {1, 0, 0}, 0.6), 1e-4);
}

TEST(Object, BehindTheBoardIsHidden) {
  Scene scene = BoardOnly();
  const StereoRig rig = RigAt(kCamera, LookAt({1.5, 0, 0.7}, {0, 0, 0.7}));
  StereoRenderer renderer;
  const auto bare = renderer.RenderRadiance(scene, rig, {});
  scene.objects.push_back(
      {Share(BoxToRender({0.1, 0.3, 0.2})), Pose3::Translation(-0.1, 0, 0.7), {0.6, 0.6, 0.6}});
  EXPECT_LT(LargestRelativeDifference(bare[0], renderer.RenderRadiance(scene, rig, {})[0]), 1e-4);
}

TEST(Shadow, OfAPoleLiesOnTheSideAwayFromTheSun) {
  FlatYard yard;
  yard.scene.light.to_sun_W = SunAt(Radians(90), Radians(40));  // from the world's +y
  yard.scene.objects.push_back(
      {Share(CylinderToRender(0.06, 1.0)), Pose3::Translation(2, 0, 0.5), {0.5, 0.5, 0.5}});
  const Pose3 X_WC = LookAt({0, 0, 1.2}, {2, 0, 0});
  const RadianceImage image =
      StereoRenderer().RenderRadiance(yard.scene, RigAt(kCamera, X_WC), {})[0];
  const auto ground = [&](double y) {
    return MeanRound(image, *kCamera.Project(Inverse(X_WC) * Eigen::Vector3d(2, y, 0)), 3);
  };
  // Shadow from y = 0 to -1 / tan 40 deg = -1.19; sun side and beyond its end are lit.
  const double in_shadow = 0.5 * (ground(-0.5) + ground(-0.9));
  const double lit = 0.25 * (ground(0.5) + ground(0.9) + ground(-1.35) + ground(-1.5));
  const double all = std::sin(Radians(40)) * 1.0 + 0.25;
  EXPECT_NEAR(in_shadow / lit, 0.25 / all, 0.1);
}

TEST(Shadow, OfAPoleIsAsWideAsThePole) {
  FlatYard yard;
  yard.scene.light.to_sun_W = SunAt(Radians(90), Radians(40));
  yard.scene.objects.push_back(
      {Share(CylinderToRender(0.06, 1.0, 64)), Pose3::Translation(2, 0, 0.5), {0.5, 0.5, 0.5}});
  const Pose3 X_WC = LookAt({1.2, -0.6, 1.2}, {2, -0.6, 0});
  const RadianceImage image =
      StereoRenderer().RenderRadiance(yard.scene, RigAt(kCamera, X_WC), {})[0];
  const auto at = [&](double x) {
    double sum = 0.0;
    for (double y = -0.8; y <= -0.4; y += 0.01) {
      sum += RadianceAt(image, *kCamera.Project(Inverse(X_WC) * Eigen::Vector3d(x, y, 0)));
    }
    return sum / 41;
  };
  const double lit = 0.5 * (at(1.8) + at(2.2)), dark = at(2.0), half = 0.5 * (lit + dark);
  double width = 0.0;
  for (double x = 1.85; x < 2.15; x += 0.001) width += at(x) < half ? 0.001 : 0.0;
  EXPECT_NEAR(width, 0.12, 0.012);
}

// 25 % to 75 % of the light behind a straight edge: 0.808 of the sun's radius as seen from there,
// from F(s) = 1/2 + (s sqrt(1 - s^2) + asin s) / pi, F(0.404) = 0.75.
double PenumbraWidth(double edge_distance_m, double sun_diameter_rad) {
  Scene scene = BoardOnly();
  scene.boards[0].board.fiducials.clear();
  scene.light = {.to_sun_W = {1, 0, 0}, .sky_irradiance = 0.0, .ground_bounce_albedo = 0.0};
  scene.light.sun_angular_diameter_rad = sun_diameter_rad;
  // Covers the side y < 0; the camera stands on the other side of its edge.
  scene.objects.push_back({Share(BoxToRender({0.02, 2.0, 2.0})),
                           Pose3::Translation(edge_distance_m + 0.01, -1.0, 0.7),
                           {0.5, 0.5, 0.5}});
  const Camera camera = EquidistantCamera(1024, 768, kPi / 2);
  const Pose3 X_WC = LookAt({0.7, 0.5, 0.7}, {0, 0, 0.7});
  const RadianceImage image = StereoRenderer().RenderRadiance(scene, RigAt(camera, X_WC), {})[0];
  const auto at = [&](double y) {
    double sum = 0.0;
    for (double z = 0.6; z <= 0.801; z += 0.002) {
      sum += RadianceAt(image, *camera.Project(Inverse(X_WC) * Eigen::Vector3d(0, y, z)));
    }
    return sum / 101;
  };
  const double lit = at(0.15);
  EXPECT_LT(at(-0.15), 1e-4);
  double width = 0.0;
  for (double y = -0.1; y < 0.1; y += 2e-4) {
    const double share = at(y) / lit;
    if (share > 0.25 && share < 0.75) width += 2e-4;
  }
  return width;
}

TEST(Penumbra, IsAsWideAsTheSunsDiscMakesIt) {
  const double expected = 0.808 * 0.5 * 0.0093 * 3.0;  // 11.3 mm
  EXPECT_NEAR(PenumbraWidth(3.0, 0.0093), expected, 0.15 * expected);
}

TEST(Penumbra, GrowsWithDistance) {
  const double expected = 0.808 * 0.5 * 0.0093 * 5.0;
  EXPECT_NEAR(PenumbraWidth(5.0, 0.0093), expected, 0.15 * expected);
}

TEST(Light, OnLevelGroundHasTheMeanThatLambertGives) {
  FlatYard yard;
  yard.scene.light.to_sun_W = SunAt(0.3, 0.9);
  const Pose3 X_WC = LookAt({-0.5, 0, 1.0}, {0.5, 0, 0});
  const RadianceImage image =
      StereoRenderer().RenderRadiance(yard.scene, RigAt(kCamera, X_WC), {})[0];
  const double grey = yard.scene.ground.albedo.dot(Eigen::Vector3d(0.299, 0.587, 0.114));
  const double expected = UnshadedRadiance(yard.scene.light, {0, 0, 1}, grey);
  EXPECT_NEAR(MeanRound(image, {320, 240}, 150), expected, 0.12 * expected);
}

TEST(Ground, ARidgeTowardsTheSunShadesWhatLiesBehindIt) {
  FlatYard yard;
  for (int iy = 0; iy < 61; ++iy) yard.heights[iy * 61 + 40] = 0.10;  // at x = 1
  yard.scene.light.to_sun_W = SunAt(0.0, Radians(20));                // from +x
  const Pose3 X_WC = LookAt({0.4, 0, 1.5}, {0.8, 0, 0});
  const RadianceImage image =
      StereoRenderer().RenderRadiance(yard.scene, RigAt(kCamera, X_WC), {})[0];
  const auto mean = [&](double x) {
    double sum = 0.0;
    for (double y = -0.5; y <= 0.5; y += 0.01) {
      sum += RadianceAt(image, *kCamera.Project(Inverse(X_WC) * Eigen::Vector3d(x, y, 0)));
    }
    return sum / 101;
  };
  // Its shadow is 0.1 / tan 20 deg = 0.27 m long.
  EXPECT_LT(mean(0.82), 0.65 * mean(0.45));
}

TEST(World, MovedAndTurnedAsAWholeLooksTheSame) {
  const auto yard = SampleYard(3.0, SunAt(0.7, 0.6));
  const auto moved = Moved(*yard, 1000.0, -500.0, 0.7);
  const StereoRig rig = SampleRig(640, 480);
  StereoRenderer renderer;
  const auto here = renderer.RenderRadiance(yard->scene, rig, yard->X_WR);
  const auto there = renderer.RenderRadiance(moved->scene, rig, moved->X_WR);
  EXPECT_LT(LargestRelativeDifference(here[0], there[0]), 1e-3);
  EXPECT_LT(LargestRelativeDifference(here[1], there[1]), 1e-3);
}

TEST(Tether, ThinnerThanAPixelStaysAFaintLine) {
  Scene scene;
  scene.light = {.to_sun_W = {0, 0, 1}, .sun_irradiance = 0.0, .sky_irradiance = 1.0};
  scene.tether.points_W = {{4, -1, 1.0}, {4, 1, 1.0}};
  scene.tether.diameter_m = 0.003;  // 0.31 px at 4 m
  scene.tether.albedo = {0, 0, 0};
  const Pose3 X_WC = LookAt({0, 0, 0.5}, {4, 0, 1.0});
  const RadianceImage image = StereoRenderer().RenderRadiance(scene, RigAt(kCamera, X_WC), {})[0];
  // Down each column the missing light adds up to the tether's true thickness.
  double mean = 0.0, worst = 1e9;
  for (int x = 280; x <= 360; ++x) {
    double missing = 0.0;
    for (int y = 235; y <= 244; ++y) {
      const double sky = 0.5 * (image.at(x, 232) + image.at(x, 248));
      missing += 1.0 - image.at(x, y) / sky;
    }
    mean += missing / 81;
    worst = std::min(worst, missing);
  }
  const double thickness_px = 0.003 / std::hypot(4.0, 0.5) * kCamera.focal_px().x();
  EXPECT_NEAR(mean, thickness_px, 0.2 * thickness_px);
  EXPECT_GT(worst, 0.5 * thickness_px);
}

TEST(Scene, BadPlacesAreRefused) {
  StereoRenderer renderer;
  const StereoRig rig = SampleRig(64, 48);
  Scene scene = BoardOnly();
  scene.ground.nx = scene.ground.ny = 10;
  EXPECT_THROW(renderer.RenderRadiance(scene, rig, {}), std::invalid_argument);
  scene = BoardOnly();
  scene.boards[0].X_WB.p.x() = std::nan("");
  EXPECT_THROW(renderer.RenderRadiance(scene, rig, {}), std::invalid_argument);
}

TEST(Scene, IsCheckedWhereOurOwnCodeMadeIt) {
  Scene scene = BoardOnly();
  scene.light.to_sun_W = {0, 0, 2};
  EXPECT_DEATH(RequireSoundScene(scene), "check failed");
  RenderMesh broken = BoxToRender({1, 1, 1});
  broken.triangles.push_back({0, 1, 99});
  EXPECT_DEATH(WithNormals(broken), "check failed");
}

TEST(Lens, WiderThanOneFlatViewServesIsRefused) {
  StereoRig rig = SampleRig(640, 480);
  rig.left = EquidistantCamera(640, 480, Radians(110));
  EXPECT_THROW(StereoRenderer().RenderRadiance(BoardOnly(), rig, {}), std::invalid_argument);
}

}  // namespace
}  // namespace dockyard
