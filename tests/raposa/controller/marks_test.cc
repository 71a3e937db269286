// The marks in drawn pictures, whose truth is known.
#include "controller/raposa/marks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raposa/controller/drawn_marks.h"
#include "sim/base/random.h"

namespace dockyard::raposa {
namespace {

const Nominal kNominal = TestNominal();

MarksSeen Find(const Scene& scene, const Pose2& X_PC,
               const std::optional<Eigen::Vector2d>& previous_px = {}) {
  return FindMarks(ColourSearch(Draw(kNominal, X_PC, scene)), kNominal, kNominal.ferreira_vision,
                   previous_px);
}

TEST(ColourBlobs, AreaBoundsAndMomentsOfADrawnEllipse) {
  const double a = 14.0, b = 7.0, turn = 0.4;
  Clutter ellipse{{}, kOrange};
  for (int i = 0; i < 60; ++i) {
    const double t = 2.0 * kPi * i / 60.0;
    ellipse.corners_px.emplace_back(
        150.3 + a * std::cos(t) * std::cos(turn) - b * std::sin(t) * std::sin(turn),
        110.6 + a * std::cos(t) * std::sin(turn) + b * std::sin(t) * std::cos(turn));
  }
  const RgbImage image = Draw(kNominal, {}, {.pyramid = false, .clutter = {ellipse}});
  const HsvBand half{.hue_from = 4, .hue_to = 18, .saturation_from = 173};  // of 50 % cover
  const auto blobs = ColourSearch(image).Blobs(half, 12.0);
  ASSERT_EQ(blobs.size(), 1u);
  EXPECT_NEAR(blobs[0].area_px2, kPi * a * b, 6.0);
  EXPECT_NEAR(blobs[0].ellipse.semi_axes_px()(0), b, 0.2);
  EXPECT_NEAR(blobs[0].ellipse.semi_axes_px()(1), a, 0.2);
  EXPECT_NEAR(blobs[0].ellipse.centre_px.x(), 150.3, 0.1);
  EXPECT_NEAR(blobs[0].ellipse.centre_px.y(), 110.6, 0.1);
  const double half_width = std::hypot(a * std::cos(turn), b * std::sin(turn));
  EXPECT_NEAR(blobs[0].bounds.left_px, 150.3 - half_width, 1.0);
  EXPECT_NEAR(blobs[0].bounds.right_px, 150.3 + half_width, 1.0);
}

TEST(ColourBlobs, ABandOfHuePassesThroughZero) {
  const HsvBand red{.hue_from = 170, .hue_to = 10};
  EXPECT_TRUE(Within({175, 200, 200}, red));
  EXPECT_TRUE(Within({5, 200, 200}, red));
  EXPECT_FALSE(Within({90, 200, 200}, red));
}

TEST(ColourBlobs, AnImageOfHueAsTheFormulaHasIt) {
  // Full red, half green, no blue: 30 deg.
  const auto hsv = ToHsv({1, 1, {200, 100, 0}});
  EXPECT_EQ(hsv[0].hue, 15);
  EXPECT_EQ(hsv[0].saturation, 255);
  EXPECT_EQ(hsv[0].value, 200);
}

/// Bias and root mean square of alpha's error over places of the marks on the pixels.
struct AngleError {
  double bias_deg = 0.0, rms_deg = 0.0, range_rms = 0.0;
  int found = 0, sides_wrong = 0;
};
AngleError ErrorAt(double r_m, double alpha_deg, int pictures) {
  RandomStream random(StreamKey(7, "places"));
  AngleError error;
  double square = 0.0, range = 0.0;
  for (int i = 0; i < pictures; ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    const double at = r_m * random.Uniform(0.99, 1.01);
    const Pose2 X_PC = CameraAt(at, sign * Radians(alpha_deg), random.Uniform(-0.02, 0.02));
    const Scene scene{.pitch_rad = random.Uniform(-0.01, 0.01)};
    const MarksSeen seen = Find(scene, X_PC);
    if (!seen.pair) continue;
    ++error.found;
    if (alpha_deg > 5.0 && sign * seen.pair->alpha_rad < 0.0) ++error.sides_wrong;
    const double off_deg = Degrees(seen.pair->angle.alpha_rad) - alpha_deg;
    error.bias_deg += off_deg;
    square += off_deg * off_deg;
    range += std::pow(seen.pair->angle.r_m / at - 1.0, 2);
  }
  error.bias_deg /= std::max(error.found, 1);
  error.rms_deg = std::sqrt(square / std::max(error.found, 1));
  error.range_rms = std::sqrt(range / std::max(error.found, 1));
  return error;
}

/// Of (7), as the paint's front edges are nearer than the square and make g too large.
double EdgeBias_deg(double r_m, double alpha_rad) {
  const Marks& marks = kNominal.marks;
  const double depth_m = r_m + marks.behind_m * std::cos(alpha_rad);
  const double psi = std::atan2(0.5 * marks.edge_m, marks.behind_m);
  return Degrees(std::tan(alpha_rad + psi) * marks.strip_m * std::cos(alpha_rad) / depth_m);
}

// raposa.md 5.1 has 1 sigma of alpha for errors of 0.5 px in c and 0.7 px in g. Here they come from
// whole pixels and from the colours that mix at an edge.
TEST(Marks, AngleErrorsAreThoseOfPixels) {
  struct Cell {
    double r_m, alpha_deg, sigma_deg;
  };
  for (const Cell& cell :
       {Cell{0.5, 0, 0.6}, Cell{0.5, 15, 0.8}, Cell{0.5, 30, 1.2}, Cell{0.5, 45, 2.1},
        Cell{0.5, 60, 5}, Cell{1.33, 0, 1.3}, Cell{1.33, 15, 2.0}, Cell{1.33, 30, 3.2},
        Cell{1.33, 45, 5.8}, Cell{1.33, 60, 9}, Cell{2.0, 0, 2.0}, Cell{2.0, 15, 3.0},
        Cell{2.0, 30, 4.8}, Cell{2.0, 45, 9}, Cell{2.0, 60, 11}}) {
    const AngleError error = ErrorAt(cell.r_m, cell.alpha_deg, 24);
    const double bias_deg = EdgeBias_deg(cell.r_m, Radians(cell.alpha_deg));
    EXPECT_EQ(error.found, 24) << cell.r_m << ' ' << cell.alpha_deg;
    EXPECT_EQ(error.sides_wrong, 0);
    EXPECT_LT(error.rms_deg, 1.2 * std::hypot(cell.sigma_deg, bias_deg))
        << cell.r_m << ' ' << cell.alpha_deg;
    EXPECT_GT(error.rms_deg, 0.1 * cell.sigma_deg) << cell.r_m << ' ' << cell.alpha_deg;
    EXPECT_LT(error.range_rms, 0.10) << cell.r_m << ' ' << cell.alpha_deg;
  }
}

const Pose2 kPlace = CameraAt(1.0, Radians(30.0));

TEST(Marks, DeviationsAndDistanceOfAPictureInTheMiddle) {
  const MarksSeen seen = Find({}, CameraAt(1.0, 0.0));
  ASSERT_TRUE(seen.pair);
  EXPECT_NEAR(seen.deviation_px.norm(), 0.0, 0.3);
  EXPECT_NEAR(seen.orange->distance_m, 1.0, 0.07);
  const MarksSeen aside = Find({}, CameraAt(1.0, 0.0, Radians(5.0)));
  EXPECT_NEAR(aside.deviation_px.x(), 377.0 * std::tan(Radians(5.0)), 0.5);
  const MarksSeen below = Find({.camera_up_m = 0.05}, CameraAt(1.0, 0.0));
  EXPECT_NEAR(below.deviation_px.y(), 377.0 * 0.05, 0.5);
}

TEST(Marks, TheSideOfTheBlueIsTheSignOfAlpha) {
  for (const double alpha_deg : {20.0, 45.0, 70.0}) {
    const MarksSeen left = Find({}, CameraAt(1.0, Radians(alpha_deg)));
    const MarksSeen right = Find({}, CameraAt(1.0, Radians(-alpha_deg)));
    ASSERT_TRUE(left.pair && right.pair);
    EXPECT_GT(left.pair->alpha_rad, 0.1);
    EXPECT_LT(right.pair->alpha_rad, -0.1);
  }
}

/// Orange and blue things of several sizes, away from the pyramid.
std::vector<Clutter> Things() {
  return {Box(100, 60, 112, 70, kOrange), Box(95, 140, 97, 143, kOrange),
          Box(110, 150, 140, 156, kOrange), Box(110, 90, 122, 120, kBlue),
          Box(180, 170, 200, 185, kBlue)};
}

TEST(Marks, ThePairIsFoundAmongThings) {
  const auto alone = Find({}, kPlace), among = Find({.clutter = Things()}, kPlace);
  ASSERT_TRUE(alone.pair && among.pair);
  EXPECT_GT(among.oranges, 1);
  EXPECT_GT(among.blues, 1);
  EXPECT_EQ(among.pair->alpha_rad, alone.pair->alpha_rad);
  EXPECT_FALSE(Find({.pyramid = false, .clutter = Things()}, kPlace).pair);
}

TEST(Marks, FlatEllipsesAndSmallBlobsAreFilteredOut) {
  const Scene flat{.pyramid = false, .clutter = {Box(150, 110, 170, 116, kOrange)}};
  EXPECT_EQ(Find(flat, {}).oranges, 0);  // axes 20 to 6
  const Scene small{.pyramid = false, .clutter = {Box(149.5, 109.5, 152.5, 112.5, kOrange)}};
  EXPECT_EQ(Find(small, {}).oranges, 0);  // 9 px^2
  const Scene square{.pyramid = false, .clutter = {Box(150, 110, 157, 117, kOrange)}};
  EXPECT_EQ(Find(square, {}).oranges, 1);
}

// "Using the bounding region is better in the presence of a bad detection (or occlusions)" (C.3).
TEST(Marks, AHiddenCornerLeavesTheBoundingRegion) {
  const MarksSeen whole = Find({}, kPlace);
  ASSERT_TRUE(whole.pair);
  const BlobBounds& blue = whole.pair->blue;
  const Clutter leaf = Box(blue.right_px - 8, blue.top_px - 3, blue.right_px + 3,
                           blue.top_px + 0.4 * blue.height_px(), {40, 90, 40}, true);
  const MarksSeen hidden = Find({.clutter = {leaf}}, kPlace);
  ASSERT_TRUE(hidden.pair);
  EXPECT_NEAR(hidden.pair->c_px, whole.pair->c_px, 1.1);
  EXPECT_NEAR(hidden.pair->g_px, whole.pair->g_px, 1.1);
  EXPECT_NEAR(Degrees(hidden.pair->alpha_rad), 30.0, 5.0);
}

TEST(Marks, NoiseOfAPoorCameraLosesNoPair) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const MarksSeen seen = Find({.noise = 5.0, .seed = seed}, CameraAt(1.33, Radians(30.0)));
    ASSERT_TRUE(seen.pair) << seed;
    EXPECT_NEAR(Degrees(seen.pair->alpha_rad), 30.0, 3.0 * 3.2) << seed;
    EXPECT_NEAR(seen.pair->angle.r_m, 1.33, 0.2) << seed;
  }
}

TEST(Marks, EllipsesOutsideTheBallAreIgnored) {
  const Eigen::Vector2d guide_px(159.5, 119.5);
  EXPECT_TRUE(Find({}, kPlace, guide_px + Eigen::Vector2d(18, 0)).pair);
  const MarksSeen outside = Find({}, kPlace, guide_px + Eigen::Vector2d(22, 0));
  EXPECT_FALSE(outside.pair);
  EXPECT_FALSE(outside.orange);
  EXPECT_TRUE(outside.blue);
}

TEST(Marks, TheBallOpensAfterTheLostFrames) {
  MarkTracker tracker(kNominal);
  const FerreiraVision& vision = kNominal.ferreira_vision;
  ASSERT_TRUE(tracker.Find(Draw(kNominal, kPlace, {}), vision).pair);
  const RgbImage jumped = Draw(kNominal, CameraAt(1.0, Radians(30.0), Radians(5.0)), {});
  for (int i = 1; i <= vision.lost_frames; ++i) {
    EXPECT_FALSE(tracker.Find(jumped, vision).pair);
    EXPECT_EQ(tracker.lost(), i);
  }
  EXPECT_TRUE(tracker.Find(jumped, vision).pair);
  EXPECT_EQ(tracker.lost(), 0);
}

// State 6 inhibits further choices: another orange thing is none of its.
TEST(Marks, ABallThatStaysIgnoresOtherEllipsesHoweverLongTheGuideIsLost) {
  MarkTracker tracker(kNominal);
  const FerreiraVision& vision = kNominal.ferreira_vision;
  ASSERT_TRUE(tracker.Find(Draw(kNominal, kPlace, {}), vision, false).pair);
  const RgbImage jumped = Draw(kNominal, CameraAt(1.0, Radians(30.0), Radians(5.0)), {});
  for (int i = 0; i < 3 * vision.lost_frames; ++i) {
    EXPECT_FALSE(tracker.Find(jumped, vision, false).orange) << i;
  }
  EXPECT_TRUE(tracker.Find(Draw(kNominal, kPlace, {}), vision, false).pair);
}

/// A blue plate in front of the view at 1 m, in place of the square: too high by that share.
Clutter Plate(double share, double from_px) {
  const double side_px = 377.0 * 0.06 / 1.098 * (1.0 + share);
  return Box(from_px, 119.5 - 0.5 * side_px, from_px + side_px, 119.5 + 0.5 * side_px, kBlue);
}

TEST(Marks, SeveralPairsFaceTheTighterLimitsAndOneAloneDoesNot) {
  const Pose2 X_PC = CameraAt(1.0, 0.0);
  const MarksSeen right = Find({}, X_PC);
  ASSERT_TRUE(right.pair);
  EXPECT_EQ(right.pairs, 1);
  // Beside the guide, 40 % too high for 1 m; the ellipse's mixed rim brings it some 5 % nearer.
  const Clutter plate = Plate(0.4, 176.0);
  const MarksSeen both = Find({.clutter = {plate}}, X_PC);
  ASSERT_TRUE(both.pair);
  EXPECT_EQ(both.pairs, 2);
  EXPECT_EQ(both.pair->g_px, right.pair->g_px);
  const Scene alone{.blue = kGrey, .clutter = {plate}};
  const MarksSeen one = Find(alone, X_PC);
  ASSERT_TRUE(one.pair);
  EXPECT_EQ(one.pairs, 1);
  EXPECT_FALSE(Possible(*one.pair, kNominal, TightLimits(kNominal.ferreira_vision)));
}

// F, Fig. 7: three candidates pass the first criteria, and the tighter ones choose the right one.
TEST(Marks, OfThreeCandidatesThePyramidIsChosen) {
  const Pose2 X_PC = CameraAt(1.2, Radians(25.0));
  const auto alone = Find({}, X_PC);
  ASSERT_TRUE(alone.pair);
  const double side_px = alone.pair->g_px;
  // An orange thing of the guide's size before a blue one that is a quarter too high, above
  // and below.
  std::vector<Clutter> others;
  for (const Eigen::Vector2d& at_px :
       {Eigen::Vector2d(110.0, 78.0), Eigen::Vector2d(190.0, 165.0)}) {
    const double u = at_px.x(), v = at_px.y(), half_px = 0.5 * 1.28 * side_px;
    others.push_back(Box(u, v - half_px, u + 1.1 * side_px, v + half_px, kBlue));
    others.push_back(Box(u - 14.0, v - 4.0, u - 6.0, v + 4.0, kOrange));
  }
  const auto found = Find({.clutter = others}, X_PC);
  EXPECT_EQ(found.pairs, 3);
  ASSERT_TRUE(found.pair);
  EXPECT_EQ(found.pair->c_px, alone.pair->c_px);
  EXPECT_EQ(found.pair->g_px, alone.pair->g_px);
}

TEST(Marks, TheAreaFilterEndsTheRange) {
  EXPECT_TRUE(Find({}, CameraAt(2.5, 0.0)).orange);
  EXPECT_FALSE(Find({}, CameraAt(4.5, 0.0)).orange);  // 5 px^2 and a rim
}

}  // namespace
}  // namespace dockyard::raposa
