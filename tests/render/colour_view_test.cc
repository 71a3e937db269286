// The views of colour cameras against closed forms: sizes, light, colours, hole, shadow, motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/colour_samples.h"
#include "render/measure.h"
#include "render/scene_light.h"
#include "render/shutter.h"

namespace dockyard {
namespace {

constexpr double kFocal_px = 377.0;

ColourView Open() {  // the same camera without a hole
  ColourView view = MarksView();
  view.hole = {};
  return view;
}

ColourRadiance DrawBy(StereoRenderer& renderer, const MarksScene& marks, const ColourView& view) {
  return renderer.RenderThrough(marks.scene, MakeColourTable(marks.spectra, CheapCamera()), view,
                                {marks.X_WC});
}
ColourRadiance DrawOne(const MarksScene& marks, const ColourView& view) {
  StereoRenderer renderer;
  return DrawBy(renderer, marks, view);
}

/// Pixels that objects of black paint cover of an even white wall.
struct Cover {
  double area = 0.0, width = 0.0, height = 0.0;  // of the middle row and column
};
Cover CoverOf(MarksScene& marks, std::size_t kept, int row, int column) {
  SceneObject object = marks.scene.objects[kept], wall = object;
  object.material = kBlack;
  wall.material = kWhite;
  wall.mesh = std::make_shared<const RenderMesh>(BoxToRender({0.01, 9.0, 9.0}));
  wall.X_WO = Pose3::Translation(object.X_WO.p.x() + 0.1, 0.0, 0.0);
  marks.scene.objects = {object, wall};
  marks.scene.light.sun_irradiance = 0.0;
  const ColourRadiance light = DrawOne(marks, Open());
  const RadianceImage& green = light.part[1];
  Cover cover;
  for (int y = 0; y < green.height; ++y) {
    for (int x = 0; x < green.width; ++x) {
      const double share = 1.0 - green.at(x, y) / green.at(5, 5);
      cover.area += share;
      if (y == row) cover.width += share;
      if (x == column) cover.height += share;
    }
  }
  return cover;
}

// A ball of radius R at the distance d on the axis: a disc of the radius f tan(asin(R / d)). The
// drawn one has 96 x 48 facets: 0.2 % less area.
TEST(ColourView, BallHasItsSize) {
  for (const double d : {0.3, 0.7, 1.1, 2.0}) {
    const auto marks = MarksAt(d, PlanckLight(5000.0), false);
    const double radius = kFocal_px * std::tan(std::asin(kBallRadius_m / d));
    const double area = CoverOf(*marks, 0, 119, 159).area;
    std::printf("ball at %.1f m: %.2f px^2, exact %.2f\n", d, area, kPi * radius * radius);
    EXPECT_NEAR(area, kPi * radius * radius, 0.03 * kPi * radius * radius) << d;
  }
}

// Off the axis it is an ellipse: with half angle a, middle at the angle t off the axis, its half
// axes are f sin a cos a / (cos^2 t - sin^2 a) and f sin a / sqrt(cos^2 t - sin^2 a).
TEST(ColourView, BallOffTheAxisIsAnEllipse) {
  const auto marks = MarksAt(0.4, PlanckLight(5000.0), false);
  marks->scene.objects[0].X_WO.p.y() = 0.12;
  marks->scene.interest->p_W.y() = 0.12;
  const double t = std::atan2(0.12, 0.4), a = std::asin(kBallRadius_m / std::hypot(0.12, 0.4));
  const double below = std::pow(std::cos(t), 2) - std::pow(std::sin(a), 2);
  const double long_px = kFocal_px * std::sin(a) * std::cos(a) / below;
  const double short_px = kFocal_px * std::sin(a) / std::sqrt(below);
  // The row through its middle; the ball lies to the left.
  const Cover cover = CoverOf(*marks, 0, 119, static_cast<int>(std::lround(159.5 - 377.0 * 0.3)));
  EXPECT_NEAR(cover.area, kPi * long_px * short_px, 0.02 * kPi * long_px * short_px);
  EXPECT_NEAR(cover.width, 2.0 * long_px, 0.5);
  EXPECT_GT(cover.width - cover.height, 0.5 * 2.0 * (long_px - short_px));
}

TEST(ColourView, SquareBehindTheBallHasTheSizeOfTheReference) {
  const std::pair<double, double> kTable[] = {{0.7, 28.0}, {1.1, 19.0}, {2.0, 10.8}};
  for (const auto& [d, listed] : kTable) {
    const auto marks = MarksAt(d, PlanckLight(5000.0), false);
    const double exact = kFocal_px * kSquareSide_m / (d + kSquareBehind_m);
    const Cover cover = CoverOf(*marks, 1, 119, 159);
    std::printf("square at %.1f m: %.2f x %.2f px, area's root %.2f, exact %.2f\n", d, cover.width,
                cover.height, std::sqrt(cover.area), exact);
    EXPECT_NEAR(std::sqrt(cover.area), exact, 0.15) << d;
    EXPECT_NEAR(cover.width, exact, 0.3) << d;
    EXPECT_NEAR(cover.height, exact, 0.3) << d;
    EXPECT_NEAR(exact, listed, 0.4);
  }
}

/// Mean of a colour in a window of the image round (x, y), of the part's pixels.
Eigen::Vector3d ColourAt(const ColourRadiance& light, int x, int y, int half = 2) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int dy = -half; dy <= half; ++dy) {
    for (int dx = -half; dx <= half; ++dx) {
      for (int c = 0; c < 3; ++c) sum[c] += light.part[c].at(x + dx - light.x0, y + dy - light.y0);
    }
  }
  return sum / ((2 * half + 1) * (2 * half + 1));
}

/// The square alone, 0.6 m ahead, facing the camera; sun from behind the camera's back.
std::unique_ptr<MarksScene> SquareAlone() {
  auto marks = MarksAt(0.5, PlanckLight(5000.0));
  marks->scene.objects.erase(marks->scene.objects.begin());
  marks->scene.light.to_sun_W = Eigen::Vector3d(-0.6, 0.0, 0.8);
  return marks;
}

TEST(ColourView, EachLightAddsItsOwnColour) {
  const auto marks = SquareAlone();
  marks->spectra.sun = PlanckLight(3000.0);
  marks->spectra.sky = DaylightLight(6500.0);
  marks->spectra.materials[kGreyFloor] = Brick();
  const ColourRadiance light = DrawOne(*marks, Open());
  const CameraResponse camera = CheapCamera();
  // Facing -x: sun's cosine 0.6, half the sky, half the bounce of ground under sun and sky.
  const Eigen::Vector3d exact =
      (0.6 * ColourOf(PlanckLight(3000.0), BluePaint(), camera) +
       0.5 * 0.4 * ColourOf(DaylightLight(6500.0), BluePaint(), camera) +
       0.5 * (0.8 * ColourOff(PlanckLight(3000.0), Brick(), BluePaint(), camera) +
              0.4 * ColourOff(DaylightLight(6500.0), Brick(), BluePaint(), camera))) /
      kPi;
  const Eigen::Vector3d seen = ColourAt(light, 159, 119);
  EXPECT_LT((seen - exact).norm(), 2e-3 * exact.norm()) << seen.transpose();
  // Level plain ground: the sun's cosine 0.8 and the whole sky.
  const Eigen::Vector3d floor = (0.8 * ColourOf(PlanckLight(3000.0), Brick(), camera) +
                                 0.4 * ColourOf(DaylightLight(6500.0), Brick(), camera)) /
                                kPi;
  const Eigen::Vector3d seen_floor = ColourAt(light, 60, 220);
  EXPECT_LT((seen_floor - floor).norm(), 2e-3 * floor.norm()) << seen_floor.transpose();
}

// A level ground is drawn as a plane, one that is not level as triangles: a step of a tenth of a
// millimetre far off changes the way, not the picture.
TEST(ColourView, LevelGroundIsWhereItsTrianglesAre) {
  const auto marks = MarksAt(0.7, PlanckLight(5000.0));
  marks->scene.objects[1].X_WO.p.z() -= 0.08;  // half in the ground
  const ColourRadiance plane = DrawOne(*marks, MarksView());
  marks->heights_m[0] = 1e-4;
  const ColourRadiance triangles = DrawOne(*marks, MarksView());
  double most = 0.0;
  int apart = 0;
  for (std::size_t i = 0; i < plane.part[2].values.size(); ++i) {
    const double d = std::abs(plane.part[2].values[i] - triangles.part[2].values[i]);
    apart += d > 0.02 * plane.part[2].at(90, 60);
    most = std::max(most, d);
  }
  std::printf("%d pixels apart, at most by %.3f\n", apart, most);
  EXPECT_LT(apart, 20) << "along the horizon and where the square meets the ground";
}

TEST(ColourView, LampFallsOffWithDistanceAngleAndCosine) {
  const auto marks = SquareAlone();
  marks->scene.light.sun_irradiance = marks->scene.light.sky_irradiance = 0.0;
  const double half_angle = 0.4, at_m = 0.5 + kSquareBehind_m;
  StereoRenderer renderer;
  const auto green = [&](const Lamp& lamp) {
    marks->scene.lamps = {lamp};
    return ColourAt(DrawBy(renderer, *marks, Open()), 159, 119).y();
  };
  const double white = ColourOf(WhiteDiodeLight(), BluePaint(), CheapCamera()).y() / kPi;
  // Where the middle of the window meets the square.
  const Eigen::Vector3d p(at_m, 0.5 * at_m / kFocal_px, 0.1 + 0.5 * at_m / kFocal_px);
  Lamp lamp{.p_W = {0.0, 0.0, 0.1},
            .axis_W = {1, 0, 0},
            .half_angle_rad = half_angle,
            .irradiance_1m = 0.2,
            .kind = 0};
  EXPECT_NEAR(green(lamp), 0.2 * white / (at_m * at_m), 2e-3 * green(lamp));
  const double ahead = std::atan2(p.y(), p.x());
  lamp.axis_W = {std::cos(ahead + half_angle), std::sin(ahead + half_angle), 0.0};
  EXPECT_NEAR(green(lamp), 0.1 * white / (at_m * at_m), 2e-3 * green(lamp));
  lamp.axis_W = {-1, 0, 0};
  EXPECT_EQ(green(lamp), 0.0);
  lamp = {.p_W = {0.0, p.y() + at_m, 0.1}, .irradiance_1m = 0.2};  // on all sides; 45 deg beside
  EXPECT_NEAR(green(lamp), 0.2 * white * std::sqrt(0.5) / (2.0 * at_m * at_m), 2e-3 * green(lamp));
}

TEST(ColourView, PaintsHaveTheTablesLogChromaticity) {
  for (const double t : {3000.0, 6500.0}) {
    const auto marks = MarksAt(0.3, PlanckLight(t));
    marks->spectra.materials[kGreyFloor] = EvenGrey(0.3);
    const ColourRadiance light = DrawOne(*marks, MarksView());
    const Eigen::Vector3d balance = BalanceFor(PlanckLight(5000.0), CheapCamera());
    // In the bounce of a grey floor under one light only the paint colours.
    const Eigen::Vector3d blue = ColourAt(light, 140, 100).cwiseProduct(balance);
    const Eigen::Vector3d orange = ColourAt(light, 159, 115).cwiseProduct(balance);
    const Eigen::Vector2d xy(std::log(orange.x() / orange.y()) - std::log(blue.x() / blue.y()),
                             std::log(orange.z() / orange.y()) - std::log(blue.z() / blue.y()));
    const Eigen::Vector2d listed =
        t < 4000.0 ? Eigen::Vector2d(1.45, -2.67) : Eigen::Vector2d(1.79, -2.25);
    EXPECT_LT((xy - listed).cwiseAbs().maxCoeff(), 0.03) << t << " K: " << xy.transpose();
  }
}

// Half the pupil sees out at the hole's half angle; all of it and none of it do half a pupil over
// the distance inside and outside.
TEST(ViewHole, IsARoundHoleWithTheRimsPenumbra) {
  const auto marks = MarksAt(2.0, PlanckLight(5000.0), false);
  marks->scene.objects = {marks->scene.objects[1]};
  marks->scene.objects[0].mesh = std::make_shared<const RenderMesh>(BoxToRender({0.01, 9, 9}));
  marks->scene.objects[0].material = kWhite;
  marks->scene.light.sun_irradiance = 0.0;
  ColourView view = MarksView();
  const ColourRadiance light = DrawOne(*marks, view);
  const RadianceImage& green = light.part[1];
  const double full = ColourAt(light, 159, 119).y();
  double area = 0.0;
  for (const float v : green.values) area += v / full;
  const double radius = kFocal_px * std::tan(view.hole.half_angle_rad);
  EXPECT_NEAR(radius, 83.6, 0.05);
  // The light of the disc and its rim: the rim's ring adds pi r^2 / 4 of its width.
  const double rim = kFocal_px * 0.5 * view.hole.pupil_m / view.hole.distance_m;
  EXPECT_NEAR(area, kPi * radius * radius, 0.005 * area);
  for (const double side : {-1.0, 1.0}) {
    const auto at = [&](double r) {
      return green.at(static_cast<int>(std::lround(159.5 + side * r)) - light.x0, 119 - light.y0) /
             full;
    };
    EXPECT_NEAR(at(radius - 0.5), 0.5, 0.06);
    EXPECT_NEAR(at(radius - rim - 1.5), 1.0, 1e-3);
    EXPECT_GT(at(radius + rim - 2.0), 0.0);
    EXPECT_EQ(at(radius + rim + 1.5), 0.0);
  }
  EXPECT_LT(green.width, 320);
}

TEST(ViewHole, ShareIsTheOverlapOfTwoDiscs) {
  ViewHole hole{.half_angle_rad = 0.2, .distance_m = 0.04, .pupil_m = 0.006};
  const double a = hole.distance_m * std::tan(0.2), r = 0.003;
  for (const double tan : {0.13, 0.18, 0.2027, 0.22, 0.26}) {
    int inside = 0, count = 0;  // points of the pupil
    for (int i = 0; i < 400; ++i) {
      for (int j = 0; j < 400; ++j) {
        const double x = r * (2.0 * (i + 0.5) / 400 - 1.0), y = r * (2.0 * (j + 0.5) / 400 - 1.0);
        if (x * x + y * y > r * r) continue;
        ++count;
        inside += std::hypot(x + tan * hole.distance_m, y) < a;
      }
    }
    EXPECT_NEAR(ShareThroughHole(hole, {tan, 0.0}), static_cast<double>(inside) / count, 2e-3);
    EXPECT_NEAR(ShareThroughHole(hole, {0.6 * tan, 0.8 * tan}), ShareThroughHole(hole, {tan, 0.0}),
                1e-12);
  }
  hole.half_angle_rad = 0.0;
  EXPECT_EQ(ShareThroughHole(hole, {0.9, 0.0}), 1.0);
}

// An edge before a camera that turns by 10 deg/s for 20 ms moves by 1.3 px and is widened by that
// box, whose variance is d^2 / 12.
TEST(ColourMotion, WidensAnEdgeByTheTurn) {
  const auto marks = MarksAt(0.5, PlanckLight(5000.0), false);
  marks->scene.objects = {marks->scene.objects[1]};
  marks->scene.objects[0].mesh = std::make_shared<const RenderMesh>(BoxToRender({0.01, 2.0, 9}));
  marks->scene.objects[0].X_WO.p.y() = 1.003;
  marks->scene.objects[0].material = kWhite;
  marks->scene.light.sun_irradiance = 0.0;
  marks->scene.interest.reset();
  const double turn = 10.0 * kPi / 180.0, open_s = 0.02;
  const double d = MotionInExposure_px(MarksView().camera, turn, 0.0, 1.0, open_s);
  EXPECT_NEAR(d, 1.3, 0.02);
  StereoRenderer renderer;
  const ColourTable table = MakeColourTable(marks->spectra, CheapCamera());
  // Mean over places of the edge in a pixel, on which the variance of differences depends.
  const auto variance = [&](double turn_rad_s, double motion_px) {
    double sum = 0.0;
    constexpr int kPlaces = 4;
    for (int place = 0; place < kPlaces; ++place) {
      Pose3 X_WC = marks->X_WC;
      X_WC.R = RotZ(place / (1.0 * kPlaces) / kFocal_px) * X_WC.R;
      const auto poses = PosesInExposure(X_WC, {0, 0, 0}, {0, 0, turn_rad_s}, open_s, motion_px);
      const RadianceImage green =
          renderer.RenderThrough(marks->scene, table, Open(), poses).part[1];
      double total = 0.0, mean = 0.0, second = 0.0;
      for (int x = 140; x < 180; ++x) {
        double slope = 0.0;  // of rows of other places among the rays
        for (int y = 40; y < 200; ++y) slope += green.at(x + 1, y) - green.at(x, y);
        total += slope;
        mean += slope * x;
        second += slope * x * x;
      }
      mean /= total;
      sum += second / total - mean * mean;
    }
    return sum / kPlaces;
  };
  const double widened = variance(turn, d) - variance(0.0, 0.0);
  std::printf("widened by %.3f px^2, exact %.3f\n", widened, d * d / 12.0);
  EXPECT_NEAR(widened, d * d / 12.0, 0.015);
}

TEST(ColourShadow, OfTheSmallMapLiesWhereItMust) {
  // A bar before the square throws its shadow onto it.
  const auto marks = SquareAlone();
  const double wall_x = 0.5 + kSquareBehind_m;
  SceneObject bar = marks->scene.objects[0];
  bar.mesh = std::make_shared<const RenderMesh>(BoxToRender({0.002, 0.06, 0.004}));
  bar.X_WO = Pose3::Translation(wall_x - 0.03, 0.0, 0.14);
  marks->scene.objects.push_back(bar);
  marks->scene.light.sky_irradiance = 0.0;
  marks->scene.light.sun_angular_diameter_rad = 1e-4;
  const ColourRadiance light = DrawOne(*marks, Open());
  // Down the column right of the middle: the darkest stretch.
  const RadianceImage& green = light.part[1];
  double dark = 0.0, sum = 0.0;
  const double lit = green.at(160, 130);
  for (int y = 103; y < 136; ++y) {
    const double share = 1.0 - std::min(green.at(160, y) / lit, 1.0);
    sum += share;
    dark += share * y;
  }
  // The sun's rays sink by 0.8 in 0.6: 3 cm (1 mm less, from the bar's middle) farther, 4 cm lower.
  const double height_m = 0.14 - 0.03 * 0.8 / 0.6;
  EXPECT_NEAR(dark / sum, 119.5 + kFocal_px * (0.1 - height_m) / wall_x, 1.0);
  EXPECT_NEAR(sum, kFocal_px * (0.004 + 0.002 * 0.8 / 0.6) / wall_x, 1.3);
}

// A robot's body round its camera throws its shadow and hides nothing.
TEST(ColourShadow, OfABodyRoundTheCameraIsSeenAndTheBodyIsNot) {
  const auto marks = MarksAt(0.5, PlanckLight(5000.0));
  marks->scene.light.to_sun_W = SunAt(kPi, 0.25);
  StereoRenderer renderer;
  const ColourRadiance alone = DrawBy(renderer, *marks, MarksView());
  SceneObject body = marks->scene.objects[0];
  body.mesh = std::make_shared<const RenderMesh>(BoxToRender({0.4, 0.5, 0.16}));
  body.X_WO = Pose3::Translation(-0.15, 0.0, 0.09);
  body.seen = false;
  marks->scene.objects.push_back(body);
  const ColourRadiance with = DrawBy(renderer, *marks, MarksView());
  // The top edge, 0.17 m high at x = 0.05, throws its shadow onto the floor up to 0.72 m.
  const double end_m = 0.05 + 0.17 / std::tan(0.25);
  const auto row = [](double x_m) { return static_cast<int>(119.5 + kFocal_px * 0.1 / x_m); };
  const auto share = [&](double x_m) {
    return ColourAt(with, 110, row(x_m), 1).y() / ColourAt(alone, 110, row(x_m), 1).y();
  };
  EXPECT_NEAR(share(end_m + 0.1), 1.0, 0.01);
  // There the sky alone is left: 0.4 of 0.4 + sin(0.25).
  EXPECT_NEAR(share(end_m - 0.1), 0.4 / (0.4 + std::sin(0.25)), 0.01);
  // The marks are in sight; the ball stands in the shadow's upper end.
  EXPECT_EQ(ColourAt(with, 159, 60).y(), ColourAt(alone, 159, 60).y());
}

TEST(ColourView, HasEqualBitsWhateverWasDrawnBefore) {
  const auto marks = MarksAt(0.7, PlanckLight(4000.0)), other = MarksAt(0.4, PlanckLight(3000.0));
  marks->scene.ground.grain = 0.5;
  const ColourTable table = MakeColourTable(marks->spectra, CheapCamera());
  StereoRenderer fresh, used;
  const ColourRadiance one = fresh.RenderThrough(marks->scene, table, MarksView(), {marks->X_WC});
  used.RenderThrough(other->scene, table, Open(), {other->X_WC});
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  const StereoImages before =
      used.Render(yard->scene, SampleRig(160, 120), yard->X_WR, {.noise_key = 1});
  const ColourRadiance two = used.RenderThrough(marks->scene, table, MarksView(), {marks->X_WC});
  for (int c = 0; c < 3; ++c) EXPECT_EQ(one.part[c].values, two.part[c].values);
  // And grey pairs do not know of colour cameras.
  EXPECT_EQ(before, used.Render(yard->scene, SampleRig(160, 120), yard->X_WR, {.noise_key = 1}));
}

TEST(ColourView, RefusesWhatTheTableDoesNotHave) {
  const auto marks = MarksAt(0.7, PlanckLight(4000.0));
  const ColourTable table = MakeColourTable(marks->spectra, CheapCamera());
  marks->scene.objects[0].material = 9;
  EXPECT_DEATH(LightBy(table, marks->scene, marks->X_WC), "check failed");
  marks->scene.objects[0].material = 0;
  marks->scene.lamps = {{.kind = 3}};
  EXPECT_DEATH(LightBy(table, marks->scene, marks->X_WC), "check failed");
}

}  // namespace
}  // namespace dockyard
