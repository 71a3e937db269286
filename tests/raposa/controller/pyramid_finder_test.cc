// The eye's parts against closed forms, and the whole on pictures that another painter draws.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/raposa/colour_pairs.h"
#include "controller/raposa/marks_projection.h"
#include "controller/raposa/pyramid_finder.h"

#include "controller/vision/coverage.h"
#include "controller/vision/linear_colour.h"
#include "raposa/controller/drawn_marks.h"

namespace dockyard::raposa {
namespace {

ConvexPolygon Polygon(std::initializer_list<Eigen::Vector2d> corners) {
  ConvexPolygon polygon;
  for (const Eigen::Vector2d& p : corners) polygon.Add(p);
  return polygon;
}

double Sum(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float v : values) sum += v;
  return sum;
}

TEST(Coverage, OfARectangleIsTheProductOfItsOverlaps) {
  for (const bool other_way : {false, true}) {
    Coverage coverage;
    coverage.Reset(6, 5);
    coverage.Add(other_way ? Polygon({{1.25, 0.5}, {1.25, 3.75}, {4.5, 3.75}, {4.5, 0.5}})
                           : Polygon({{1.25, 0.5}, {4.5, 0.5}, {4.5, 3.75}, {1.25, 3.75}}));
    coverage.Finish();
    const double x[6] = {0.0, 0.75, 1.0, 1.0, 0.5, 0.0}, y[5] = {0.5, 1.0, 1.0, 0.75, 0.0};
    for (std::size_t j = 0; j < 5; ++j) {
      for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(coverage.values()[6 * j + i], x[i] * y[j], 1e-6) << i << ' ' << j;
      }
    }
  }
}

TEST(Coverage, OfATriangleAddsUpToItsArea) {
  Coverage coverage;
  coverage.Reset(12, 9);
  coverage.Add(Polygon({{1.3, 0.7}, {10.9, 2.2}, {4.4, 8.1}}));
  coverage.Finish();
  const double area = 0.5 * (9.6 * 7.4 - 3.1 * 1.5);
  EXPECT_NEAR(Sum(coverage.values()), area, 1e-5);
}

TEST(Coverage, LeavesAwayWhatLiesOutside) {
  Coverage coverage;
  coverage.Reset(4, 4);
  coverage.Add(Polygon({{-3.0, -2.0}, {2.0, -2.0}, {2.0, 9.0}, {-3.0, 9.0}}));
  coverage.Finish();
  for (std::size_t k = 0; k < 16; ++k) EXPECT_NEAR(coverage.values()[k], k % 4 < 2, 1e-6);
}

TEST(Coverage, BlurKeepsTheSumAndAddsItsVariance) {
  for (const double sigma : {0.4, 1.0}) {
    std::vector<float> values(21 * 21, 0.0f);
    values[10 * 21 + 10] = 1.0f;
    BlurShares(21, 21, sigma, &values);
    EXPECT_NEAR(Sum(values), 1.0, 1e-5);
    double variance = 0.0;
    for (int k = 0; k < 441; ++k) {
      variance += std::pow(k % 21 - 10, 2) * values[static_cast<std::size_t>(k)];
    }
    EXPECT_NEAR(std::sqrt(variance), sigma, 0.02 * sigma);  // the kernel ends at 3 sigma
  }
}

TEST(LinearPairs, UndoTheTransferCurve) {
  // sRGB 188 is linear 0.5029, 255 is 1.
  const PairImage pairs = ToLinearPairs({2, 1, {188, 255, 0, 188, 255, 0}});
  ASSERT_EQ(pairs.width, 1);
  EXPECT_NEAR(pairs.At(0, 0)[0], 0.5029, 1e-3);
  EXPECT_NEAR(pairs.At(0, 0)[1], 1.0, 1e-6);
  EXPECT_EQ(pairs.At(0, 0)[2], 0.0f);
}

/// c and g of eqs. (2) and (7), by the corners of the base's strips.
struct Lengths {
  double c_px = 0.0, g_px = 0.0;
};
Lengths LengthsAt(double r_m, double alpha_deg, double bearing_deg, double dz_m) {
  Nominal nominal = TestNominal();
  nominal.marks.strip_m = 1e-6;  // the square alone, flat
  const Pose2 X_DV = CameraAt(r_m, Radians(alpha_deg), Radians(bearing_deg));
  const auto marks = ProjectMarks(nominal, {Inverse(X_DV), dz_m, 0.0, 0.0});
  Lengths out;
  double top = 1e9, bottom = -1e9;
  for (const ConvexPolygon& strip : marks->strips) {
    for (std::size_t k : {0u, 1u}) {
      out.c_px = std::max(out.c_px, std::abs(strip.corners[k].x() - marks->guide_px->x()));
      top = std::min(top, strip.corners[k].y());
      bottom = std::max(bottom, strip.corners[k].y());
    }
  }
  out.g_px = bottom - top;
  return out;
}

TEST(MarksProjection, HasThePublicVectorsOfTheTwoLengths) {
  // raposa.md 5.1, rows without pitch and tilt.
  const double rows[][5] = {
      {2.00, 0, 0, 5.390526, 10.781052},   {1.33, 30, 0, 20.208456, 16.157382},
      {2.00, 60, 0, 18.631066, 11.180960}, {0.50, 60, 0, 72.057867, 43.243696},
      {1.50, 73, 0, 25.789089, 15.080000}, {1.50, 80, 0, 25.812046, 15.206773},
      {1.50, 90, 0, 25.165540, 15.387755}};
  for (const auto& row : rows) {
    const Lengths lengths = LengthsAt(row[0], row[1], row[2], 0.0);
    EXPECT_NEAR(lengths.c_px, row[3], 1e-3) << row[0] << ' ' << row[1];
    EXPECT_NEAR(lengths.g_px, row[4], 1e-3) << row[0] << ' ' << row[1];
  }
}

TEST(MarksProjection, PitchDownRaisesTheImageAndRollTurnsItTheOtherWay) {
  const Nominal nominal = TestNominal();
  const Pose2 X_VD{1.0, 0.0, kPi};
  const Eigen::Vector2d centre = nominal.camera.centre_px();
  const auto at = [&](const PyramidPlace& place) {
    return Eigen::Vector2d(*ProjectGuide(nominal, place)->guide_px - centre);
  };
  // A guide 0.05 m below the camera at 1 m, pitch 0.02: 377 tan(atan(0.05) - 0.02) below.
  EXPECT_NEAR(at({X_VD, 0.05, 0.02, 0.0}).y(), 377.0 * std::tan(std::atan(0.05) - 0.02), 1e-6);
  // Clockwise camera: what lies below goes to the right.
  const double down_px = 377.0 * 0.05;
  EXPECT_NEAR(at({X_VD, 0.05, 0.0, 0.1}).x(), down_px * std::sin(0.1), 1e-6);
}

/// Draw makes sharp images of linear values; the eye expects a blur of 1 px and the curve of sRGB.
RgbImage Coded(RgbImage image) {
  const std::size_t pixels = image.pixels.size() / 3;
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float> channel(pixels);
    for (std::size_t k = 0; k < pixels; ++k) channel[k] = image.pixels[3 * k + c];
    BlurShares(image.width, image.height, 1.0, &channel);
    for (std::size_t k = 0; k < pixels; ++k) {
      image.pixels[3 * k + c] = static_cast<std::uint8_t>(std::lround(channel[k]));
    }
  }
  for (std::uint8_t& value : image.pixels) {
    const double v = value / 255.0;
    const double coded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
    value = static_cast<std::uint8_t>(std::lround(255.0 * coded));
  }
  return image;
}

/// Draw's faces do not rise, and there is no rod.
Nominal FlatNominal() {
  Nominal nominal = TestNominal();
  nominal.marks.rise_rad = 0.0;
  nominal.marks.rod_radius_m = 1e-4;
  nominal.marks.guide_up_rad = 0.0;
  nominal.marks.guide_half_angle_rad = std::atan(0.6);  // to a point at half its length
  nominal.X_RC.p.z() = 0.005;
  return nominal;
}

RgbImage Drawn(double r_m, double alpha_rad, double bearing_rad, Scene scene) {
  scene.camera_up_m = 0.05;
  scene.noise = 5.0;
  return Coded(Draw(FlatNominal(), CameraAt(r_m, alpha_rad, bearing_rad), scene));
}

TEST(PyramidFinder, MeasuresADrawnPyramid) {
  const PyramidFinder finder(FlatNominal());
  for (const double r_m : {0.6, 1.0, 1.6}) {
    for (const double alpha_deg : {-60.0, -25.0, 0.0, 40.0, 70.0}) {
      const double alpha = Radians(alpha_deg), right = Radians(2.0);
      const PyramidSighting sighting = finder.Find(Drawn(r_m, alpha, right, {}), 0.0);
      SCOPED_TRACE(testing::Message() << r_m << " m, " << alpha_deg << " deg");
      ASSERT_TRUE(sighting.guide);
      EXPECT_NEAR(sighting.guide->bearing_rad, -right, Radians(0.15));
      ASSERT_FALSE(sighting.fits.empty());
      const Pose2 X_DV = Inverse(sighting.fits.front().X_VD);
      EXPECT_NEAR(std::hypot(X_DV.x, X_DV.y), r_m, 0.05 * r_m);
      EXPECT_NEAR(std::atan2(X_DV.y, X_DV.x), alpha, Radians(6.0));
    }
  }
}

// The hole is built half a degree narrower or wider than told. A rim that were taken for what is
// told would cut the guide.
TEST(PyramidFinder, FindsTheRimOfItsHoleInThePicture) {
  const Nominal told = TestNominal();
  for (const double off_deg : {-0.5, 0.0, 0.5}) {
    Nominal built = told;
    built.half_view_rad += Radians(off_deg);
    const RgbImage image = Draw(built, CameraAt(0.5, 0.3), {.noise = 1.0});
    const double rim_px = built.camera.focal_px().x() * std::tan(built.half_view_rad);
    EXPECT_NEAR(TintsOf(image, told).hole_px, rim_px, 0.6) << off_deg;
  }
}

TEST(PyramidFinder, SeesNoPyramidWhereThereIsNone) {
  const PyramidFinder finder(FlatNominal());
  Scene scene{.pyramid = false};
  EXPECT_FALSE(finder.Find(Drawn(1.0, 0.0, 0.0, scene), 0.0).guide);
  // An orange box over a blue one.
  scene.clutter = {Box(150, 130, 166, 140, kOrange), Box(148, 142, 176, 156, kBlue)};
  EXPECT_TRUE(finder.Find(Drawn(1.0, 0.0, 0.0, scene), 0.0).fits.empty());
}

TEST(PyramidFinder, KnowsTheGuideAlone) {
  const PyramidFinder finder(FlatNominal());
  Scene scene;
  scene.blue = scene.background;
  const PyramidSighting sighting = finder.Find(Drawn(0.8, 0.3, 0.05, scene), 0.0);
  ASSERT_TRUE(sighting.guide);
  EXPECT_TRUE(sighting.fits.empty());
  EXPECT_FALSE(sighting.guide->clipped);
  EXPECT_NEAR(sighting.guide->bearing_rad, -0.05, 0.003);
  EXPECT_NEAR(sighting.guide->range_m, 0.8, 4.0 * sighting.guide->range_sigma_m);
  EXPECT_LT(sighting.guide->range_sigma_m, 0.12);
}

// A band of shade across the view, of a sky that is warmer than the sun: ln R/B is 1.4 above that
// of the lit ground. Guide and marks lie in it, as dark.
TEST(PyramidFinder, FindsTheGuideInAShadeThatIsWarmerThanTheLight) {
  const Nominal nominal = FlatNominal();
  for (const double bearing : {-0.1, 0.0, 0.1}) {
    Scene scene{.orange = {54, 8, 1}, .blue = {3, 8, 24}, .background = {60, 66, 72}, .noise = 0.4};
    scene.clutter = {Box(60.0, 114.0, 260.0, 134.0, {14, 9, 4.2})};
    const PyramidSighting sighting =
        PyramidFinder(nominal).Find(Drawn(0.9, 1.7, bearing, scene), 0.0);
    ASSERT_TRUE(sighting.guide) << bearing;
    EXPECT_NEAR(sighting.guide->bearing_rad, -bearing, 0.01);
    EXPECT_NEAR(sighting.guide->range_m, 0.9, 0.1);
  }
}

// An orange wall behind the guide, blue and grey ones near its square.
TEST(PyramidFinder, MeasuresAPyramidThatTouchesThingsOfItsColours) {
  const PyramidFinder finder(FlatNominal());
  const double alpha = Radians(40.0);
  Scene scene;
  const PyramidSighting bare = finder.Find(Drawn(1.0, alpha, 0.0, scene), 0.0);
  ASSERT_FALSE(bare.fits.empty());
  scene.clutter = {Box(150, 96, 168, 133, kOrange), Box(110, 96, 140, 122, kBlue),
                   Box(176, 96, 210, 160, {120, 110, 60})};
  const PyramidPrior prior{Inverse(CameraAt(1.0, alpha + 0.05, 0.005)),
                           Eigen::Vector3d(0.03, 0.03, 0.08).cwiseAbs2().asDiagonal()};
  const PyramidSighting sighting = finder.Find(Drawn(1.0, alpha, 0.0, scene), 0.0, prior);
  ASSERT_FALSE(sighting.fits.empty());
  const Pose2 off = Inverse(bare.fits.front().X_VD) * sighting.fits.front().X_VD;
  EXPECT_NEAR(off.heading, 0.0, Radians(3.0));
  EXPECT_NEAR(std::hypot(off.x, off.y), 0.0, 0.03);
}

TEST(PyramidFinder, TakesNoPartOfALargerThingForAMark) {
  const PyramidFinder finder(FlatNominal());
  Scene scene;
  // The guide and the square's frame, but a blue wall all round the frame.
  scene.clutter = {Box(100, 60, 220, 180, kBlue)};
  EXPECT_TRUE(finder.Find(Drawn(1.0, 0.0, 0.0, scene), 0.0).fits.empty());
}

// A lone guide at the middle of the view has no square at any angle from which blue shows. With its
// square, the true angle is not ruled out.
TEST(PyramidFinder, RulesOutAnglesAtWhichTheSquareWouldBeInView) {
  const PyramidFinder finder(FlatNominal());
  Scene scene;
  scene.blue = scene.background;
  const PyramidSighting lone = finder.Find(Drawn(1.0, 0.3, 0.0, scene), 0.0);
  ASSERT_TRUE(lone.guide);
  EXPECT_TRUE(lone.guide->without_square.all());
  const PyramidSighting aside = finder.Find(Drawn(0.6, 0.3, 0.12, scene), 0.0);
  ASSERT_TRUE(aside.guide);
  EXPECT_FALSE(aside.guide->without_square.all());  // the square may be beyond the view's edge
  EXPECT_TRUE(aside.guide->without_square.any());
}

TEST(PyramidFinder, SearchesNoRefutedThingUnlessTheGuideIsExpectedThere) {
  const PyramidFinder finder(FlatNominal());
  const double r_m = 1.2, alpha = 0.5;
  const RgbImage image = Drawn(r_m, alpha, 0.0, {});
  const std::vector<RefutedThing> refuted{{.bearing_rad = 0.0, .range_m = 1.2, .radius_m = 0.2}};
  const PyramidSighting sighting = finder.Find(image, 0.0, std::nullopt, refuted);
  EXPECT_FALSE(sighting.guide);
  ASSERT_EQ(sighting.known.size(), 1u);
  EXPECT_NEAR(sighting.known[0].bearing_rad, 0.0, 0.01);
  const PyramidPrior prior{Inverse(CameraAt(r_m, alpha, 0.0)),
                           Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal()};
  EXPECT_FALSE(finder.Find(image, 0.0, prior, refuted).fits.empty());
}

TEST(PyramidFinder, PriorRulesOutOtherThingsOfLikeColours) {
  const PyramidFinder finder(FlatNominal());
  const double r_m = 1.2, alpha = 0.5;
  const RgbImage image = Drawn(r_m, alpha, 0.0, {});
  const Pose2 X_VD = Inverse(CameraAt(r_m, alpha, 0.0));
  PyramidPrior prior{X_VD, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()};
  prior.covariance *= 0.01;
  EXPECT_FALSE(finder.Find(image, 0.0, prior).fits.empty());
  prior.X_VD = Inverse(CameraAt(r_m, alpha, 0.2));  // 11 deg beside
  EXPECT_FALSE(finder.Find(image, 0.0, prior).guide);
}

}  // namespace
}  // namespace dockyard::raposa
