// Scenes of hundreds of objects, their stains, and the ground's pebbles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/measure.h"
#include "render/scene_painter.h"
#include "render/soil_texture.h"

namespace dockyard {
namespace {

const Camera kLens = EquidistantCamera(640, 480, kPi / 2);

std::shared_ptr<const RenderMesh> Shared(RenderMesh mesh) {
  return std::make_shared<const RenderMesh>(std::move(mesh));
}

Scene EvenLight() {
  Scene scene;
  scene.light = {.to_sun_W = {0, 0, 1}, .sun_irradiance = 0.0, .sky_irradiance = 1.0};
  return scene;
}

RadianceImage LeftOf(const Scene& scene, const Pose3& X_WC) {
  return StereoRenderer().RenderRadiance(scene, RigAt(kLens, X_WC), {})[0];
}

// A wall of 50 x 40 tiles, each with an albedo of its own: none takes another's.
TEST(ManyObjects, EachOf2000HasItsOwnAlbedo) {
  Scene scene = EvenLight();
  const auto tile = Shared(BoxToRender({0.002, 0.03, 0.03}));
  const auto albedo = [](int i) { return 0.1 + 0.8 * (i * 733 % 2000) / 2000.0; };
  for (int i = 0; i < 2000; ++i) {
    const Pose3 X_WO = Pose3::Translation(1.0, 0.04 * (i % 50 - 24.5), 0.04 * (i / 50 - 19.5));
    scene.objects.push_back({tile, X_WO, Eigen::Vector3d::Constant(albedo(i))});
  }
  const Pose3 X_WC = LookAt({0, 0, 0}, {1, 0, 0});
  const RadianceImage image = LeftOf(scene, X_WC);
  int seen = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d front =
        scene.objects[static_cast<std::size_t>(i)].X_WO.p - Eigen::Vector3d(0.001, 0, 0);
    const auto pixel = kLens.Project(Inverse(X_WC) * front);
    if (!pixel || !kLens.Sees(*pixel, 3.0)) continue;
    ++seen;
    const double want = UnshadedRadiance(scene.light, {-1, 0, 0}, albedo(i));
    ASSERT_NEAR(RadianceAt(image, *pixel), want, 2e-3 * want) << i;
  }
  EXPECT_GT(seen, 1500);
}

// Normals have fewer bits there: light on bodies changes by less than a grey level of 255, but for
// single pixels on a shadow's edge.
TEST(ManyObjects, LookAsFewDo) {
  Scene few = EvenLight();
  few.light.sun_irradiance = 1.0;
  few.light.to_sun_W = SunAt(2.5, 0.6);
  const auto drum = Shared(CylinderToRender(0.2, 0.6));
  for (int i = 0; i < 5; ++i) {
    Pose3 X_WO = Pose3::Translation(2.0, 0.6 * (i - 2), 0.0);
    X_WO.R = RotX(0.5 * i);
    few.objects.push_back({drum, X_WO, {0.5, 0.5, 0.5}});
  }
  Scene many = few;
  const auto mote = Shared(BoxToRender({1e-4, 1e-4, 1e-4}));
  for (int i = 0; i < 300; ++i) {  // within a drum, where nobody sees them
    many.objects.push_back({mote, few.objects[2].X_WO, {0.5, 0.5, 0.5}});
  }
  const Pose3 X_WC = LookAt({0, 0, 0}, {1, 0, 0});
  const RadianceImage a = LeftOf(few, X_WC), b = LeftOf(many, X_WC);
  const float white = *std::max_element(a.values.begin(), a.values.end());
  int other = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    other += std::abs(a.values[i] - b.values[i]) > white / 255.0f;
  }
  EXPECT_LT(other, 300);  // of 307 200
  EXPECT_LT(LargestRelativeDifference(a, b), 0.03);
}

TEST(ManyObjects, AreRefusedBeyond2000) {
  Scene scene = EvenLight();
  const auto tile = Shared(BoxToRender({0.01, 0.01, 0.01}));
  scene.objects.assign(2001, {tile, Pose3::Translation(1, 0, 0), {0.5, 0.5, 0.5}});
  EXPECT_THROW(LeftOf(scene, LookAt({0, 0, 0}, {1, 0, 0})), std::invalid_argument);
}

// A plate square to the view, half a metre off: 2 mm a pixel in its middle.
struct StainedPlate {
  explicit StainedPlate(const Stains& stains) {
    scene.objects.push_back({Shared(BoxToRender({0.01, 0.4, 0.4})),
                             Pose3::Translation(0.5, 0, 0),
                             {0.5, 0.5, 0.5},
                             0,
                             true,
                             stains});
  }
  Scene scene = EvenLight();
};

struct Spread {
  double mean = 0.0, sigma = 0.0;
};

Spread SpreadOf(const RadianceImage& image) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (int y = 180; y < 300; ++y) {
    for (int x = 260; x < 380; ++x) {
      const double value = static_cast<double>(image.at(x, y));
      sum += value;
      squares += value * value;
      ++count;
    }
  }
  return {sum / count, std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)))};
}

const Pose3 kView = LookAt({0, 0, 0}, {1, 0, 0});

TEST(Stains, HaveTheContrastThatIsAskedForAboutTheSameMean) {
  const Spread none = SpreadOf(LeftOf(StainedPlate({}).scene, kView));
  // All sizes are wide against a pixel.
  const Spread wide = SpreadOf(
      LeftOf(StainedPlate({.contrast = 0.15, .largest_m = 0.02, .least_m = 0.005}).scene, kView));
  EXPECT_LT(none.sigma, 0.02 * none.mean);
  EXPECT_NEAR(wide.mean, none.mean, 0.02 * none.mean);
  EXPECT_NEAR(wide.sigma / wide.mean, 0.15, 0.02);
  // Finer than a pixel they are not seen.
  const Spread fine = SpreadOf(
      LeftOf(StainedPlate({.contrast = 0.15, .largest_m = 1e-3, .least_m = 5e-4}).scene, kView));
  EXPECT_LT(fine.sigma, 0.02 * fine.mean);
}

TEST(Stains, BelongToTheirObject) {
  const Stains stains{.contrast = 0.2};
  const StainedPlate plate(stains);
  StainedPlate moved(stains);
  const Pose3 X{RotZ(0.4), {3.0, -2.0, 0.5}};
  moved.scene.objects[0].X_WO = X * moved.scene.objects[0].X_WO;
  const RadianceImage a = LeftOf(plate.scene, kView), b = LeftOf(moved.scene, X * kView);
  EXPECT_LT(LargestRelativeDifference(a, b), 0.02);
  StainedPlate other({.contrast = 0.2, .seed = 2});
  EXPECT_GT(LargestRelativeDifference(a, LeftOf(other.scene, kView)), 0.2);
}

// What a stereo pair matches: a place of the plate is as bright in both pictures, though each
// camera's rays meet other points about it.
TEST(Stains, LieAtOnePlaceInBothPicturesOfAPair) {
  const Stains stains{.contrast = 0.2, .least_m = 0.008};
  const StainedPlate plate(stains);
  const Pose3 X_WQ = kView * Pose3::Translation(0.1, 0.003, 0.02);
  const RadianceImage left = LeftOf(plate.scene, kView), right = LeftOf(plate.scene, X_WQ);
  double squares = 0.0, mean = 0.0, count = 0.0;
  for (double y = -0.15; y < 0.1; y += 0.0037) {
    for (double z = -0.15; z < 0.15; z += 0.0041) {
      const Eigen::Vector3d p_W(0.495, y, z);
      const double a = RadianceAt(left, *kLens.Project(Inverse(kView) * p_W));
      const double b = RadianceAt(right, *kLens.Project(Inverse(X_WQ) * p_W));
      squares += (a - b) * (a - b);
      mean += a;
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 0.015 * mean / count);  // of stains of 20 %
}

TEST(Stains, AreRefusedOutOfRange) {
  EXPECT_DEATH(RequireSoundScene(StainedPlate({.contrast = 0.6}).scene), "check failed");
  const Stains narrow{.contrast = 0.1, .largest_m = 1e-3};
  EXPECT_DEATH(RequireSoundScene(StainedPlate(narrow).scene), "check failed");
}

// Height is the fourth byte, 127 steps for 3 cm. A pebble reaches up to 0.7 of its radius at most,
// so nothing that small pebbles add to bare soil is higher.
double HighestPebble(const std::vector<std::uint8_t>& with, const std::vector<std::uint8_t>& bare) {
  int most = 0;
  for (std::size_t i = 3; i < with.size(); i += 4) {
    if (with[i] > bare[i]) most = std::max(most, with[i] - 128);
  }
  return most * 0.03 / 127.0;
}

TEST(Pebbles, AboveASizeAreLeftOutOfTheGroundsTexture) {
  const auto bare = SoilTexture(3, 0.0), small = SoilTexture(3, 0.005), all = SoilTexture(3);
  EXPECT_LT(HighestPebble(small, bare), 0.7 * 0.005 + 0.0003);
  EXPECT_GT(HighestPebble(small, bare), 0.001);  // small ones stay
  EXPECT_GT(HighestPebble(all, bare), 0.01);
  EXPECT_EQ(all, SoilTexture(3, 0.05));
}

}  // namespace
}  // namespace dockyard
