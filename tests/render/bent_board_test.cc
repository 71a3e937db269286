// Boards that are not flat: where their marks lie, and how they are lit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "render/bent_plate.h"
#include "render/measure.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Bow {
  double flatness_m, bow_rad;
};
constexpr std::array kBows{Bow{0.02, 0.0}, Bow{-0.02, 0.0}, Bow{0.05, 1.1}, Bow{-0.05, 2.3},
                           Bow{0.001, -0.4}};

BoardView ViewOf(const Bow& bow) {
  BoardView view;
  view.board = SampleBoard();
  view.board.width_m = 1.3;
  view.board.height_m = 0.9;
  view.flatness_m = bow.flatness_m;
  view.bow_rad = bow.bow_rad;
  return view;
}

Vector2d Across(const BoardView& view) { return {std::cos(view.bow_rad), -std::sin(view.bow_rad)}; }
double HalfLength(const BoardView& view) {
  const Vector2d across = Across(view).cwiseAbs();
  return 0.5 * (across.x() * view.board.width_m + across.y() * view.board.height_m);
}

/// A strip of one curvature from its middle on: along the board, and how far it has risen.
Vector2d Strip(double curvature_1_m, double length_m) {
  const double angle = curvature_1_m * length_m, half = std::sin(0.5 * angle);
  return Vector2d(std::sin(angle), 2.0 * half * half) / curvature_1_m;
}

/// The same added up piece by piece.
Vector2d StripOfPieces(double curvature_1_m, double length_m) {
  constexpr int kPieces = 2000;
  Vector2d at = Vector2d::Zero();
  for (int i = 0; i < kPieces; ++i) {
    const double angle = curvature_1_m * length_m * (i + 0.5) / kPieces;
    at += length_m / kPieces * Vector2d(std::cos(angle), std::sin(angle));
  }
  return at;
}

using StripOf = Vector2d (*)(double curvature_1_m, double length_m);

/// By bisection for the curvature whose strip rises by the bow.
PlaceOfPrint PlacesOn(const BoardView& view, StripOf strip_of = Strip) {
  const double half_m = HalfLength(view), bow_m = view.flatness_m;
  double low = 0.0, high = 2.0 / half_m;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (strip_of(middle, half_m).y() < std::abs(bow_m) ? low : high) = middle;
  }
  const Vector2d across = Across(view), along(-across.y(), across.x());
  return [=](const Vector2d& p) -> Vector3d {
    const Vector2d strip = strip_of(low, across.dot(p));
    const Vector2d in_plane = strip.x() * across + along.dot(p) * along;
    return {in_plane.x(), in_plane.y(), bow_m > 0.0 ? strip.y() - bow_m : -strip.y()};
  };
}

TEST(BentPlate, HasItsPlacesOnAStripOfOneCurvature) {
  for (const Bow& bow : kBows) {
    const BoardView view = ViewOf(bow);
    const BentPlate plate(view);
    const PlaceOfPrint place = PlacesOn(view, StripOfPieces);
    for (const Vector2d& p : {Vector2d(0.0, 0.0), {0.6, 0.4}, {-0.5, 0.3}, {0.1, -0.45}}) {
      EXPECT_LT((plate.At(p) - place(p)).norm(), 1e-7) << bow.flatness_m << ' ' << p.transpose();
    }
    const Vector2d edge = HalfLength(view) * Across(view);
    EXPECT_NEAR(plate.At(edge).z() - plate.At({0.0, 0.0}).z(), bow.flatness_m, 1e-12);
    EXPECT_NEAR(std::max(plate.At(edge).z(), plate.At({0.0, 0.0}).z()), 0.0, 1e-12);
  }
}

TEST(BentPlate, HasItsNormalAcrossItsSurface) {
  for (const Bow& bow : kBows) {
    const BentPlate plate(ViewOf(bow));
    const Vector2d p(0.31, -0.22);
    constexpr double kApart_m = 1e-6;
    const Vector3d right =
        plate.At(p + Vector2d(kApart_m, 0)) - plate.At(p - Vector2d(kApart_m, 0));
    const Vector3d down = plate.At(p + Vector2d(0, kApart_m)) - plate.At(p - Vector2d(0, kApart_m));
    EXPECT_LT((plate.Normal(p) + right.cross(down).normalized()).norm(), 1e-6);
  }
}

TEST(BentPlate, IsMetByARayWhereItsPlaceLies) {
  for (const Bow& bow : kBows) {
    const BentPlate plate(ViewOf(bow));
    for (const Vector3d& from : {Vector3d(0.0, 0.0, -0.5), {0.7, -0.2, -1.0}, {-2.0, 0.5, -3.0}}) {
      for (const Vector2d& p : {Vector2d(0.0, 0.0), {0.55, 0.4}, {-0.6, 0.1}, {0.2, -0.43}}) {
        const Vector3d ray = 0.37 * (plate.At(p) - from);
        EXPECT_LT((plate.Meet(from, ray) - p).norm(), 1e-9) << bow.flatness_m << p.transpose();
      }
    }
  }
}

/// A camera at a place, towards another; its x axis is level.
Pose3 Facing(const Vector3d& from_W, const Vector3d& target_W) {
  const Vector3d z = (target_W - from_W).normalized(), x = z.cross(Vector3d::UnitZ()).normalized();
  Pose3 X_WC;
  X_WC.p = from_W;
  X_WC.R << x, z.cross(x), z;
  return X_WC;
}

/// Even light from all sides, so that paint is alike wherever it faces.
Scene EvenlyLit(const Bow& bow) {
  Scene scene = BoardOnly();
  const Pose3 X_WB = scene.boards[0].X_WB;
  scene.boards[0] = ViewOf(bow);
  scene.boards[0].X_WB = X_WB;
  scene.light.sun_irradiance = 0.0;
  scene.light.ground_bounce_albedo = 1.0;
  return scene;
}

TEST(BentBoard, ShowsItsDiscsWhereTheirPlacesProject) {
  const Camera camera = EquidistantCamera(1024, 768, kPi / 2);
  const Pose3 X_WC = Facing({1.5, 0.6, 0.4}, {0.0, -0.03, 0.75});
  StereoRenderer renderer;
  for (const Bow& bow : {kBows[0], kBows[2], kBows[3]}) {
    const Scene scene = EvenlyLit(bow);
    const BoardView& view = scene.boards[0];
    const RadianceImage image = renderer.RenderGrey(scene, camera, X_WC);
    const double white = UnshadedRadiance(scene.light, Vector3d::UnitZ(), view.white_albedo);
    const Pose3 X_CB = Inverse(X_WC) * view.X_WB;
    const PlaceOfPrint place = PlacesOn(view);
    double squares = 0.0, moved_px = 0.0;
    for (const Fiducial& f : view.board.fiducials) {
      const Vector2d exact = ExactBlackCentroid(view.board, f, camera, X_CB, place);
      const Vector2d flat = ExactBlackCentroid(view.board, f, camera, X_CB);
      const double window = 0.068 * camera.focal_px().x() / 1.6 + 2.0;
      squares += (CentroidOfDark(image, exact, window, white) - exact).squaredNorm();
      moved_px = std::max(moved_px, (exact - flat).norm());
    }
    const double rms_px = std::sqrt(squares / static_cast<double>(view.board.fiducials.size()));
    std::printf("bow %.0f mm: rms %.4f px, moved by up to %.2f px\n", 1e3 * bow.flatness_m, rms_px,
                moved_px);
    EXPECT_LT(rms_px, 0.015);
    EXPECT_GT(moved_px, 2.0);
  }
}

TEST(BentBoard, IsLitByTheNormalOfEachPlace) {
  StereoRenderer renderer;
  const Camera camera = EquidistantCamera(640, 480, kPi / 2);
  for (const double flatness_m : {0.08, -0.08}) {
    Scene scene = EvenlyLit({flatness_m, 0.0});
    BoardView& view = scene.boards[0];
    view.board.fiducials.clear();
    scene.light = BoardOnly().light;
    const Vector3d n_W = -view.X_WB.R.col(2);
    scene.light.to_sun_W = (n_W + 0.5 * view.X_WB.R.col(0)).normalized();
    const Pose3 X_WC = Facing(view.X_WB.p + 1.2 * n_W, view.X_WB.p);
    const RadianceImage image = renderer.RenderGrey(scene, camera, X_WC);
    const PlaceOfPrint place = PlacesOn(view);
    double darkest = 1e9, lightest = 0.0;
    for (const double x : {-0.55, -0.3, 0.0, 0.25, 0.55}) {
      const Vector2d pixel = *camera.Project(Inverse(X_WC) * (view.X_WB * place({x, 0.1})));
      // The normal from two places next to it.
      const Vector3d along = place({x + 1e-3, 0.1}) - place({x - 1e-3, 0.1});
      const Vector3d n = view.X_WB.R * along.cross(Vector3d::UnitY()).normalized();
      const double wanted = UnshadedRadiance(scene.light, -n, view.white_albedo);
      EXPECT_NEAR(RadianceAt(image, pixel) / wanted, 1.0, 2e-3) << flatness_m << ' ' << x;
      darkest = std::min(darkest, wanted);
      lightest = std::max(lightest, wanted);
    }
    EXPECT_GT(lightest, 1.1 * darkest);
  }
}

TEST(BentBoard, ThatIsAllButFlatIsDrawnAsAFlatOne) {
  StereoRenderer renderer;
  Scene scene = EvenlyLit({0.0, 0.7});
  scene.light = BoardOnly().light;
  const Camera camera = EquidistantCamera(640, 480, kPi / 2);
  const Pose3 X_WC = Facing({1.2, 0.4, 0.5}, {0.0, 0.0, 0.7});
  const RadianceImage flat = renderer.RenderGrey(scene, camera, X_WC);
  scene.boards[0].flatness_m = 1e-7;
  const RadianceImage bent = renderer.RenderGrey(scene, camera, X_WC);
  // Its edge is made of other triangles, so single rays there meet the one and not the other.
  const double white = *std::max_element(flat.values.begin(), flat.values.end());
  int unlike = 0;
  for (std::size_t i = 0; i < flat.values.size(); ++i) {
    if (std::abs(flat.values[i] - bent.values[i]) > 5e-3 * white) ++unlike;
  }
  std::printf("%d pixels unlike\n", unlike);
  EXPECT_LT(unlike, 10);
  EXPECT_GT(LargestRelativeDifference(flat, bent), 0.0);
}

}  // namespace
}  // namespace dockyard
