// How a face bends, from disparities of shapes in closed form.
#include "controller/stereo/face_bend.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <optional>

#include "sim/base/hash.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kFocal_px = 800.0, kBaseline_m = 0.2, kAbout_m = 0.035;

RectifiedPair BendPair() {
  RectifiedPair pair;
  pair.width = 320;
  pair.height = 240;
  pair.focal_px = kFocal_px;
  pair.baseline_m = kBaseline_m;
  pair.centre_px = {160.0, 120.0};
  pair.X_RC = {RotZ(0.3) * RotX(-1.9), Vector3d(0.2, -0.1, 0.9)};
  return pair;
}

/// Of the depth along each ray that the function gives, with that noise.
Disparities DisparitiesOf(const std::function<std::optional<double>(const Vector3d&)>& depth_m,
                          double noise_px) {
  const RectifiedPair pair = BendPair();
  Disparities all{pair.width, pair.height, {}};
  for (int v = 0; v < pair.height; ++v) {
    for (int u = 0; u < pair.width; ++u) {
      const Vector3d ray((u - pair.centre_px.x()) / kFocal_px, (v - pair.centre_px.y()) / kFocal_px,
                         1.0);
      const auto z_m = depth_m(ray);
      const std::uint64_t hash = HashDouble(HashDouble(3, u), v);
      const double noise = static_cast<double>(hash >> 40) / static_cast<double>(1U << 24) - 0.5;
      const double px = z_m ? kFocal_px * kBaseline_m / *z_m + 3.46 * noise_px * noise : 0.0;
      all.px.push_back(static_cast<float>(px));
    }
  }
  return all;
}

// A ball whose middle is ahead, 0.7 m away and more.
Disparities Ball(double radius_m, double noise_px) {
  return DisparitiesOf(
      [=](const Vector3d& ray) -> std::optional<double> {
        const Vector3d middle(0.01, -0.005, 0.7 + radius_m);
        const double b = ray.dot(middle), a = ray.squaredNorm();
        const double rest = b * b - a * (middle.squaredNorm() - radius_m * radius_m);
        if (rest < 0.0) return std::nullopt;
        return (b - std::sqrt(rest)) / a;
      },
      noise_px);
}

TEST(FaceBend, OfABallIsOneOverItsRadiusAlongTheSurfaceAndNoneAcross) {
  for (const double radius_m : {0.08, 0.12, 0.25}) {
    const Disparities disparities = Ball(radius_m, 0.2);
    const auto plane = PlaneUnder(BendPair(), disparities, {150.0, 110.0}, {.radius_m = kAbout_m});
    ASSERT_TRUE(plane);
    const auto bend = BendAbout(BendPair(), disparities, *plane, kAbout_m);
    ASSERT_TRUE(bend);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> of(*bend);
    EXPECT_NEAR(of.eigenvalues()[0], 0.0, 1e-9) << radius_m;
    EXPECT_NEAR(of.eigenvalues()[1] * radius_m, 1.0, 0.1) << radius_m;
    EXPECT_NEAR(of.eigenvalues()[2] * radius_m, 1.0, 0.1) << radius_m;
    EXPECT_LT((*bend * plane->normal).norm(), 1e-9);
  }
}

// 8 mm along the surface of the ball the normal is the one from its middle.
TEST(FaceBend, PredictsTheNormalOfAPlaceNearBy) {
  constexpr double kBall_m = 0.1;
  const Disparities disparities = Ball(kBall_m, 0.2);
  const auto plane = PlaneUnder(BendPair(), disparities, {160.0, 120.0}, {.radius_m = kAbout_m});
  ASSERT_TRUE(plane);
  const auto bend = BendAbout(BendPair(), disparities, *plane, kAbout_m);
  ASSERT_TRUE(bend);
  const Vector3d middle = BendPair().X_RC * Vector3d(0.01, -0.005, 0.7 + kBall_m);
  for (const double angle_rad : {0.0, 1.5, 3.0, 4.5}) {
    const Vector3d x = plane->normal.unitOrthogonal(), y = plane->normal.cross(x);
    const Vector3d along = 0.008 * (std::cos(angle_rad) * x + std::sin(angle_rad) * y);
    const Vector3d predicted = (plane->normal + *bend * along).normalized();
    const Vector3d is = (plane->p + along - middle).normalized();
    EXPECT_LT(Degrees(std::acos(predicted.dot(is))), 1.0);
    EXPECT_GT(Degrees(std::acos(plane->normal.dot(is))), 3.0);
  }
}

TEST(FaceBend, OfAPlaneIsNone) {
  const Vector3d normal = Vector3d(0.3, -0.2, -1.0).normalized();
  const Disparities disparities = DisparitiesOf(
      [&](const Vector3d& ray) { return normal.dot(Vector3d(0.0, 0.0, 0.7)) / normal.dot(ray); },
      0.2);
  const auto plane = PlaneUnder(BendPair(), disparities, {160.0, 120.0}, {.radius_m = kAbout_m});
  ASSERT_TRUE(plane);
  const auto bend = BendAbout(BendPair(), disparities, *plane, kAbout_m);
  ASSERT_TRUE(bend);
  EXPECT_LT(bend->norm(), 0.7);  // a ball of 1.4 m or more
}

TEST(FaceBend, FewPointsGiveNone) {
  Disparities disparities = Ball(0.1, 0.0);
  const auto plane = PlaneUnder(BendPair(), disparities, {160.0, 120.0}, {.radius_m = kAbout_m});
  ASSERT_TRUE(plane);
  for (std::size_t i = 0; i < disparities.px.size(); ++i) {
    if (i % 97 != 0) disparities.px[i] = 0.0F;
  }
  EXPECT_FALSE(BendAbout(BendPair(), disparities, *plane, kAbout_m));
}

}  // namespace
}  // namespace dockyard
