// Stray light of a lens against its closed forms (docs/reference/images.md).
#include "render/stray_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/colour_samples.h"
#include "render/colour_view.h"
#include "render/exposure_rule.h"
#include "render/measure.h"
#include "render/shading.h"

namespace dockyard {
namespace {

constexpr int kWidth = 240, kHeight = 180;
constexpr double kEnd_rad = Radians(32.0);  // of the scattered light

/// A pinhole's pixels: f px wide at the axis, the centre in the middle of the image.
PixelGrid PinholeGrid(double f_px) {
  PixelGrid grid{.width = kWidth, .height = kHeight, .x = {}, .y = {}};
  for (int y = 0; y <= kHeight; ++y) {
    for (int x = 0; x <= kWidth; ++x) {
      grid.x.push_back(static_cast<float>((x - 0.5 * kWidth) / f_px));
      grid.y.push_back(static_cast<float>((y - 0.5 * kHeight) / f_px));
    }
  }
  return grid;
}

Eigen::Vector3d RayOf(double f_px, int x, int y) {
  return Eigen::Vector3d((x + 0.5 - 0.5 * kWidth) / f_px, (y + 0.5 - 0.5 * kHeight) / f_px, 1.0)
      .normalized();
}

RadianceImage Flat(float radiance) {
  return {.width = kWidth,
          .height = kHeight,
          .values = std::vector<float>(std::size_t{kWidth} * kHeight, radiance),
          .inverse_depth = {}};
}

/// The widths by the text of images.md: they double from core sqrt(2) on, up to half the end.
std::vector<double> Widths(double core_rad) {
  std::vector<double> widths;
  for (double w = core_rad; w < 0.75 * kEnd_rad; w *= 2.0) widths.push_back(std::sqrt(2.0) * w);
  return widths;
}

double Law(double core_rad, double angle_rad) {
  const double chord = 2.0 * std::sin(0.5 * angle_rad);
  double sum = 0.0;
  const std::vector<double> widths = Widths(core_rad);
  for (const double w : widths) {
    sum += std::exp(-0.5 * chord * chord / (w * w)) / (2.0 * kPi * w * w);
  }
  return sum / static_cast<double>(widths.size());
}

SunInLens SunTowards(double angle_rad, double side_rad, double share = 1.0) {
  return {.to_sun_C = {std::sin(angle_rad) * std::cos(side_rad),
                       std::sin(angle_rad) * std::sin(side_rad), std::cos(angle_rad)},
          .share = share,
          .radius_rad = 0.00465};
}

TEST(ScatterLaw, SpreadsAllOfTheLightOverTheSphere) {
  for (const double core_deg : {0.2, 0.5, 2.0}) {
    const ScatterLaw law(Radians(core_deg));
    double sum = 0.0;
    constexpr int kSteps = 40000;
    for (int i = 0; i < kSteps; ++i) {
      const double angle = kPi * (i + 0.5) / kSteps;
      const double chord = 2.0 * std::sin(0.5 * angle);
      sum += law(static_cast<float>(chord * chord)) * 2.0 * kPi * std::sin(angle) * kPi / kSteps;
    }
    EXPECT_NEAR(sum, 1.0, 2e-3) << core_deg;
  }
}

// CIE 146 (2002): disability glare falls as 1 / angle^2.
TEST(ScatterLaw, FallsAsTheInverseSquareBetweenCoreAndEnd) {
  const double core = Radians(0.5);
  const ScatterLaw law(core);
  for (const double angle_deg : {2.0, 3.0, 5.0, 8.0, 12.0}) {
    const double chord = 2.0 * std::sin(0.5 * Radians(angle_deg));
    const double inverse = 1.0 / (2.0 * kPi * std::log(kEnd_rad / core) * chord * chord);
    EXPECT_NEAR(law(static_cast<float>(chord * chord)) / inverse, 1.0, 0.1) << angle_deg;
  }
}

TEST(StrayLight, LeavesAnEvenFieldAsItIs) {
  RadianceImage image = Flat(0.4f);
  AddStrayLight({.veil = 0.1}, 100.0, {}, 0.0, image);
  for (const float value : image.values) EXPECT_NEAR(value, 0.4f, 1e-5f);
}

// The method of ISO 9358: a black disc on a bright field. The light in its middle over that of the
// field is the veil times the share of the law beyond the disc.
TEST(StrayLight, InABlackDiscIsTheShareOfTheLawBeyondIt) {
  constexpr double kFocal_px = 100.0, kCore_rad = Radians(1.0), kVeil = 0.03;
  for (const double radius_px : {6.0, 15.0, 40.0}) {
    RadianceImage image = Flat(1.0f);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double off = std::hypot(x - kWidth / 2, y - kHeight / 2);
        if (off <= radius_px) image.values[static_cast<std::size_t>(y) * kWidth + x] = 0.0f;
      }
    }
    AddStrayLight({.veil = kVeil, .core_rad = kCore_rad}, kFocal_px, {}, 0.0, image);
    double beyond = 0.0;
    const std::vector<double> widths = Widths(kCore_rad);
    for (const double w : widths) {
      beyond += std::exp(-0.5 * std::pow(radius_px / (kFocal_px * w), 2));
    }
    beyond /= static_cast<double>(widths.size());
    EXPECT_NEAR(image.at(kWidth / 2, kHeight / 2) / kVeil, beyond, 0.02) << radius_px;
  }
}

TEST(StrayLight, OfABrightPixelFollowsTheLawAroundIt) {
  constexpr double kFocal_px = 150.0, kCore_rad = Radians(1.0), kVeil = 0.05, kLight = 1e4;
  RadianceImage image = Flat(0.0f);
  const int mx = kWidth / 2, my = kHeight / 2;
  image.values[static_cast<std::size_t>(my) * kWidth + mx] = kLight;
  AddStrayLight({.veil = kVeil, .core_rad = kCore_rad}, kFocal_px, {}, 0.0, image);
  for (const int off : {3, 8, 15, 30, 60}) {
    const double law = Law(kCore_rad, off / kFocal_px) / (kFocal_px * kFocal_px);
    EXPECT_NEAR(image.at(mx + off, my) / (kVeil * kLight), law, 0.06 * law) << off;
    EXPECT_NEAR(image.at(mx, my - off) / (kVeil * kLight), law, 0.06 * law) << off;
  }
  EXPECT_NEAR(image.at(mx, my) / kLight, 1.0 - kVeil, 1e-3) << "the rest stays where it is";
}

TEST(SunStray, IsTheLawTimesTheLightOnTheLens) {
  constexpr double kFocal_px = 150.0;
  const PixelGrid grid = PinholeGrid(kFocal_px);
  const StrayLight stray{.veil = 0.02, .core_rad = Radians(0.5)};
  // In the image, beyond its edge, and far aside.
  for (const double angle_deg : {0.0, 20.0, 45.0, 80.0}) {
    const SunInLens sun = SunTowards(Radians(angle_deg), 0.4, 0.7);
    const SunStray of_sun = StrayOfSun(stray, grid, sun);
    RadianceImage image = Flat(0.0f);
    AddStrayLight({.veil = 0.0, .ghosts = 1e-4}, kFocal_px, of_sun, 1.3, image);
    for (const auto& [x, y] : {std::pair(10, 20), {120, 90}, {200, 170}}) {
      const double angle = std::acos(std::clamp(RayOf(kFocal_px, x, y).dot(sun.to_sun_C), -1., 1.));
      const double wanted =
          0.02 * 0.7 * 1.3 * std::cos(Radians(angle_deg)) * Law(stray.core_rad, angle);
      EXPECT_NEAR(image.at(x, y), wanted, 1e-3 * wanted) << angle_deg << " at " << x;
    }
  }
}

TEST(SunStray, OfASunBehindTheLensOrHiddenIsNone) {
  const PixelGrid grid = PinholeGrid(150.0);
  const StrayLight stray{.veil = 0.02, .ghosts = 1e-3};
  EXPECT_TRUE(StrayOfSun(stray, grid, SunTowards(Radians(91.0), 0.0)).per_irradiance.empty());
  EXPECT_TRUE(StrayOfSun(stray, grid, SunTowards(0.2, 0.0, 0.0)).per_irradiance.empty());
}

TEST(SunStray, ItsDiscInTheImageIsNotSpreadTwice) {
  constexpr double kFocal_px = 150.0;
  const PixelGrid grid = PinholeGrid(kFocal_px);
  const StrayLight stray{.veil = 0.02, .core_rad = Radians(0.5)};
  const SunStray of_sun = StrayOfSun(stray, grid, SunTowards(0.1, 0.0));
  ASSERT_FALSE(of_sun.disc.empty());
  RadianceImage drawn = Flat(0.3f), plain = Flat(0.3f);
  for (const std::size_t i : of_sun.disc) drawn.values[i] = 15000.0f;
  AddStrayLight(stray, kFocal_px, of_sun, 1.0, drawn);
  AddStrayLight(stray, kFocal_px, of_sun, 1.0, plain);
  for (const auto& [x, y] : {std::pair(10, 20), {120, 90}, {200, 170}}) {
    EXPECT_NEAR(drawn.at(x, y), plain.at(x, y), 1e-5);
  }
}

/// Sums of a view's light times each pixel's solid angle.
struct Moments {
  double light = 0.0, along = 0.0, across = 0.0;
};
Moments MomentsOf(const SunStray& of_sun, double f_px, double side_rad) {
  Moments sum;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Eigen::Vector3d ray = RayOf(f_px, x, y);
      const double light = of_sun.per_irradiance[static_cast<std::size_t>(y) * kWidth + x] *
                           std::pow(ray.z(), 3) / (f_px * f_px);
      sum.light += light;
      sum.along += light * (ray.x() * std::cos(side_rad) + ray.y() * std::sin(side_rad));
      sum.across += light * (ray.y() * std::cos(side_rad) - ray.x() * std::sin(side_rad));
    }
  }
  return sum;
}

TEST(Ghosts, HaveTheirShareOfTheLightAndLieOnTheLineThroughTheCentre) {
  constexpr double kFocal_px = 150.0, kGhosts = 5e-4;
  const PixelGrid grid = PinholeGrid(kFocal_px);
  for (const double side_deg : {0.0, 50.0, 200.0}) {
    const double side = Radians(side_deg), angle = Radians(18.0);
    const SunStray of_sun =
        StrayOfSun({.veil = 0.0, .ghosts = kGhosts}, grid, SunTowards(angle, side));
    const Moments sum = MomentsOf(of_sun, kFocal_px, side);
    EXPECT_NEAR(sum.light, kGhosts * std::cos(angle), 0.01 * kGhosts) << side_deg;
    EXPECT_NEAR(sum.across / sum.light, 0.0, 1e-3);
    EXPECT_LT(sum.along / sum.light, -0.02) << "most lie across from the sun";
  }
}

TEST(Ghosts, FadeAsTheSunLeavesTheImage) {
  constexpr double kFocal_px = 150.0;
  const PixelGrid grid = PinholeGrid(kFocal_px);
  const double corner = std::atan(std::hypot(0.5 * kWidth, 0.5 * kHeight) / kFocal_px);
  const auto most = [&](double angle) {
    const SunStray of_sun = StrayOfSun({.veil = 0.0, .ghosts = 5e-4}, grid, SunTowards(angle, 0.6));
    return *std::max_element(of_sun.per_irradiance.begin(), of_sun.per_irradiance.end());
  };
  EXPECT_NEAR(most(corner + Radians(2.5)) / most(corner), 0.5, 0.05);
  EXPECT_EQ(most(corner + Radians(5.1)), 0.0f);
}

// Images as they are drawn.

/// A sky alone, and a sun that a camera at the origin with this view has in its image.
Scene UnderTheSun(double elevation_rad) {
  Scene scene;
  scene.light.to_sun_W = SunAt(0.0, elevation_rad);
  return scene;
}
const Camera kCamera = EquidistantCamera(320, 240, kPi / 2);
const Pose3 kAlongX = ForwardCamera(0.0, 0.0, 1.0);

/// A plate at 5 m that faces the sun, whose lower edge is so far over the sun's middle, as
/// an angle.
SceneObject PlateOver(const Scene& scene, double up_rad) {
  const Eigen::Vector3d to_sun = scene.light.to_sun_W;
  Pose3 X_WO;
  X_WO.R.col(0) = to_sun;
  X_WO.R.col(1) = Eigen::Vector3d::UnitY();
  X_WO.R.col(2) = to_sun.cross(Eigen::Vector3d::UnitY());
  X_WO.p = kAlongX.p + 5.0 * to_sun + (0.5 + 5.0 * up_rad) * X_WO.R.col(2);
  return {std::make_shared<const RenderMesh>(BoxToRender({0.01, 1.0, 1.0})), X_WO};
}

/// The light that stray light of the sun alone adds to a corner of the image.
double Added(StereoRenderer& renderer, Scene scene) {
  scene.light.stray = {};
  const RadianceImage without = renderer.RenderGrey(scene, kCamera, kAlongX);
  scene.light.stray = {.veil = 0.0, .ghosts = 1e-3};
  const RadianceImage with = renderer.RenderGrey(scene, kCamera, kAlongX);
  double sum = 0.0;
  for (std::size_t i = 0; i < with.values.size(); ++i) sum += with.values[i] - without.values[i];
  return sum;
}

TEST(StrayLight, FollowsTheShareOfTheDiscThatABodyLeaves) {
  StereoRenderer renderer;
  Scene scene = UnderTheSun(Radians(12.0));
  const double whole = Added(renderer, scene);
  ASSERT_GT(whole, 0.0);
  scene.objects = {PlateOver(scene, 0.0)};
  EXPECT_NEAR(Added(renderer, scene) / whole, 0.5, 0.03);
  // The plate's edge at half the radius below the middle leaves the disc's smaller segment.
  const double radius = 0.5 * scene.light.sun_angular_diameter_rad;
  scene.objects = {PlateOver(scene, -0.5 * radius)};
  EXPECT_NEAR(Added(renderer, scene) / whole, (kPi / 3.0 - std::sqrt(3.0) / 4.0) / kPi, 0.03);
  scene.objects = {PlateOver(scene, -2.0 * radius)};
  EXPECT_EQ(Added(renderer, scene), 0.0);
}

TEST(StrayLight, OfASunOverTheImageVeilsItUnlessABodyShadesTheLens) {
  StereoRenderer renderer;
  Scene scene = UnderTheSun(Radians(50.0));  // the image ends 34 deg up
  const RadianceImage clear = renderer.RenderGrey(scene, kCamera, kAlongX);
  scene.light.stray = {.veil = 0.02};
  const RadianceImage veiled = renderer.RenderGrey(scene, kCamera, kAlongX);
  scene.objects = {PlateOver(scene, -0.02)};
  const RadianceImage shaded = renderer.RenderGrey(scene, kCamera, kAlongX);
  const Eigen::Vector3d to_sun_C = kAlongX.R.transpose() * scene.light.to_sun_W;
  for (const auto& [x, y] : {std::pair(160, 5), {20, 60}, {160, 110}}) {
    const double angle =
        std::acos(kCamera.Direction(Eigen::Vector2d(x, y)).normalized().dot(to_sun_C));
    const double sun = 0.02 * std::cos(Radians(50.0)) * Law(Radians(0.5), angle);
    EXPECT_NEAR(veiled.at(x, y) - shaded.at(x, y), sun, 2e-3 * sun);
    EXPECT_NEAR(shaded.at(x, y), clear.at(x, y), 0.02 * clear.at(x, y)) << "the sky's own";
  }
}

TEST(StrayLight, OfColourImagesHasTheGreyImageAsLuminance) {
  auto yard = SampleYard(2.0, SunAt(kPi, 0.3));
  yard->scene.light.sun_rgb = {1.3, 0.95, 0.5};
  yard->scene.light.sun_rgb /= Luminance(yard->scene.light.sun_rgb);
  yard->scene.light.stray = {.veil = 0.03, .ghosts = 1e-3};
  const StereoRig rig = SampleRig(320, 240);
  StereoRenderer renderer;
  const auto grey = renderer.RenderRadiance(yard->scene, rig, yard->X_WR);
  const auto colour = renderer.RenderColour(yard->scene, rig, yard->X_WR);
  const Eigen::Vector3d share = ChannelWeights(Channel::kGrey);
  for (std::size_t i = 0; i < grey[0].values.size(); ++i) {
    const double luminance = share[0] * colour[0][0].values[i] + share[1] * colour[0][1].values[i] +
                             share[2] * colour[0][2].values[i];
    ASSERT_NEAR(luminance / grey[0].values[i], 1.0, 1e-4) << i;
  }
}

TEST(StrayLight, OfAPairIsEachLensesOwn) {
  StereoRig rig = SampleRig(320, 240);
  rig.X_RQ.R = rig.X_RQ.R * RotY(Radians(5.0));
  Scene scene = UnderTheSun(Radians(12.0));
  StereoRenderer renderer;
  const auto clear = renderer.RenderRadiance(scene, rig, {});
  scene.light.stray = {.veil = 0.0, .ghosts = 1e-3};
  const auto stray = renderer.RenderRadiance(scene, rig, {});
  const Eigen::Vector3d to_sun = scene.light.to_sun_W;
  for (int view = 0; view < 2; ++view) {
    // The light's centre lies on the line through sun and image centre.
    const Camera& camera = view == 0 ? rig.left : rig.right;
    const Pose3& X_RC = view == 0 ? rig.X_RL : rig.X_RQ;
    const Eigen::Vector2d sun = *camera.Project(X_RC.R.transpose() * to_sun) - camera.centre_px();
    Eigen::Vector2d sum(0, 0);
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const double added = stray[view].at(x, y) - clear[view].at(x, y);
        if (clear[view].at(x, y) < 10.0f)
          sum += added * (Eigen::Vector2d(x, y) - camera.centre_px());
      }
    }
    EXPECT_GT(sum.norm(), 1.0);
    EXPECT_NEAR(sum.normalized().dot(sun.normalized()), -1.0, 1e-3);
  }
}

TEST(StrayLight, ThroughAHoleIsThatOfASunThatTheHoleLetsIn) {
  const auto marks = MarksAt(0.7, PlanckLight(5000.0));
  const ColourTable table = MakeColourTable(marks->spectra, CheapCamera());
  StereoRenderer renderer;
  const auto added = [&](double elevation_rad) {  // to green, over the image
    marks->scene.light.to_sun_W = SunAt(0.0, elevation_rad);
    double sums[2];
    for (const bool on : {false, true}) {
      marks->scene.light.stray = {.veil = 0.0, .ghosts = on ? 1e-3 : 0.0};
      const ColourRadiance light =
          renderer.RenderThrough(marks->scene, table, MarksView(), {marks->X_WC});
      sums[on] = std::accumulate(light.part[1].values.begin(), light.part[1].values.end(), 0.0);
    }
    return sums[1] - sums[0];
  };
  EXPECT_GT(added(Radians(8.0)), 1.0);
  EXPECT_EQ(added(Radians(16.0)), 0.0) << "the hole ends 12.5 deg off the axis";
}

// What the exposure is set by gets brighter, so the rest gets fewer electrons.
TEST(StrayLight, LowersTheAutomaticExposure) {
  StereoRenderer renderer;
  Scene scene = UnderTheSun(Radians(12.0));
  const RadianceImage clear = renderer.RenderGrey(scene, kCamera, kAlongX);
  scene.light.stray = {.veil = 0.05};
  const RadianceImage veiled = renderer.RenderGrey(scene, kCamera, kAlongX);
  EXPECT_LT(ElectronsOfRadiance({&veiled, 1}, {}), 0.8 * ElectronsOfRadiance({&clear, 1}, {}));
}

}  // namespace
}  // namespace dockyard
