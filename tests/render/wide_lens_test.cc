// Lenses that reach 64 deg off the axis are drawn right out to their corners.
#include <gtest/gtest.h>

#include <cmath>

#include "render/measure.h"

namespace dockyard {
namespace {

// 103 deg across 4:3: 356 px/rad, corners 64.4 deg off the axis, as Rocky 7's body pair.
const Camera kWide = EquidistantCamera(640, 480, Radians(103.0));

double OffAxis(const Eigen::Vector2d& pixel) {
  return std::acos(kWide.Direction(pixel).normalized().z());
}

TEST(WideLens, HasItsCornersBeyond64Deg) {
  EXPECT_NEAR(kWide.focal_px().x(), 356.0, 0.1);
  EXPECT_NEAR(Degrees(OffAxis({-0.5, -0.5})), 64.4, 0.1);
}

// Black balls before an even sky: a ball's image is its cone's, whatever the renderer does. Its
// centroid is integrated here pixel by pixel from the cone and the lens alone.
Eigen::Vector2d CentroidOfCone(const Eigen::Vector3d& axis_C, double half_angle_rad,
                               const Eigen::Vector2d& middle, int half_px) {
  constexpr int kParts = 6;
  const double cosine = std::cos(half_angle_rad);
  Eigen::Vector2d sum(0, 0);
  double count = 0.0;
  for (int v = -half_px * kParts; v <= half_px * kParts; ++v) {
    for (int u = -half_px * kParts; u <= half_px * kParts; ++u) {
      const Eigen::Vector2d at = middle + Eigen::Vector2d(u, v) / kParts;
      if (kWide.Direction(at).normalized().dot(axis_C) < cosine) continue;
      sum += at;
      ++count;
    }
  }
  return sum / count;
}

RenderMesh BallToRender(double radius_m) {
  constexpr int kRings = 48, kSides = 96;
  RenderMesh mesh;
  for (int ring = 0; ring <= kRings; ++ring) {
    const double polar = kPi * ring / kRings;
    for (int side = 0; side < kSides; ++side) {
      const double around = 2.0 * kPi * side / kSides;
      mesh.vertices.push_back(
          (radius_m * Eigen::Vector3d(std::sin(polar) * std::cos(around),
                                      std::sin(polar) * std::sin(around), std::cos(polar)))
              .cast<float>());
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t next = (side + 1) % kSides, a = ring * kSides, b = a + kSides;
      mesh.triangles.push_back({a + side, b + side, b + next});
      mesh.triangles.push_back({a + side, b + next, a + next});
    }
  }
  return mesh;
}

TEST(WideLens, ShowsBallsWhereTheyProjectRightOutToItsCorners) {
  constexpr double kBall_m = 0.03, kAway_m = 1.0;
  const double half_angle = std::asin(kBall_m / kAway_m);
  const auto ball = std::make_shared<const RenderMesh>(BallToRender(kBall_m));
  Scene scene;
  scene.light = {.to_sun_W = {0, 0, 1},
                 .sun_irradiance = 0.0,
                 .sky_irradiance = 1.0,
                 .ground_bounce_albedo = 0.0};
  const Pose3 X_WC{Eigen::Matrix3d::Identity(), {0, 0, 0}};  // straight up: sky all over
  std::vector<Eigen::Vector2d> places;
  for (const double u : {16.0, 130.0, 320.0, 510.0, 623.0}) {
    for (const double v : {16.0, 130.0, 240.0, 350.0, 463.0}) places.emplace_back(u, v);
  }
  for (const Eigen::Vector2d& place : places) {
    const Eigen::Vector3d p_C = kAway_m * kWide.Direction(place).normalized();
    scene.objects.push_back({ball, Pose3::Translation(p_C.x(), p_C.y(), p_C.z()), {0, 0, 0}});
  }
  const RadianceImage image = StereoRenderer().RenderRadiance(scene, RigAt(kWide, X_WC), {})[0];
  // In the middle of the picture rays are 1.1 px apart, along its rows and columns: a ball on the
  // middle row or column has an edge along them.
  double worst_inside = 0.0, worst_outside = 0.0, farthest = 0.0;
  for (const Eigen::Vector2d& place : places) {
    constexpr int kHalf = 15;
    const Eigen::Vector2d want =
        CentroidOfCone(kWide.Direction(place).normalized(), half_angle, place, kHalf);
    // The sky's brightness changes slowly: that of the window's border, by a plane through it.
    const auto sky = [&](double x, double y) {
      const double h = kHalf, a = image.at(int(place.x()) - kHalf, int(place.y()));
      const double b = image.at(int(place.x()) + kHalf, int(place.y()));
      const double c = image.at(int(place.x()), int(place.y()) - kHalf);
      const double d = image.at(int(place.x()), int(place.y()) + kHalf);
      return 0.25 * (a + b + c + d) + (b - a) / (2 * h) * (x - place.x()) +
             (d - c) / (2 * h) * (y - place.y());
    };
    Eigen::Vector2d sum(0, 0);
    double dark = 0.0;
    for (int y = int(place.y()) - kHalf; y <= int(place.y()) + kHalf; ++y) {
      for (int x = int(place.x()) - kHalf; x <= int(place.x()) + kHalf; ++x) {
        const double here = std::max(0.0, 1.0 - image.at(x, y) / sky(x, y) - 0.02);
        sum += here * Eigen::Vector2d(x, y);
        dark += here;
      }
    }
    ASSERT_GT(dark, 100.0);
    double& worst = OffAxis(place) < Radians(40.0) ? worst_inside : worst_outside;
    worst = std::max(worst, (sum / dark - want).norm());
    farthest = std::max(farthest, OffAxis(place));
  }
  std::printf("balls up to %.1f deg off axis: worst %.3f px, within 40 deg %.3f px\n",
              Degrees(farthest), worst_outside, worst_inside);
  EXPECT_GT(Degrees(farthest), 60.0);
  EXPECT_LT(worst_outside, 0.1);
  EXPECT_LT(worst_inside, 0.2);
}

TEST(WideLens, IsRefusedBeyond65Deg) {
  Scene scene;
  EXPECT_THROW(
      StereoRenderer().RenderRadiance(
          scene, RigAt(EquidistantCamera(640, 480, Radians(105.0)), LookAt({0, 0, 0}, {1, 0, 0})),
          {}),
      std::invalid_argument);
}

}  // namespace
}  // namespace dockyard
