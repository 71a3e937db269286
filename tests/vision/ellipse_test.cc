#include "controller/vision/ellipse.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

const Eigen::Vector2d kCentre(512.3, 207.8);

/// Semi-axes 9 and 14 px, the long one 30 deg off the x axis.
Eigen::Matrix2d Shape() {
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(Radians(30.0)).toRotationMatrix();
  return R * Eigen::Vector2d(14.0, 9.0).asDiagonal() * R.transpose();
}

std::vector<Eigen::Vector2d> Rim(int count, double from_rad, double to_rad) {
  std::vector<Eigen::Vector2d> rim;
  for (int i = 0; i < count; ++i) {
    const double angle = from_rad + (to_rad - from_rad) * i / count;
    rim.emplace_back(kCentre + Shape() * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return rim;
}

TEST(EllipseFit, IsExactOnExactPoints) {
  const auto ellipse = FitEllipse(Rim(24, 0.0, 2.0 * kPi));
  ASSERT_TRUE(ellipse);
  EXPECT_NEAR((ellipse->centre_px - kCentre).norm(), 0.0, 1e-7);
  EXPECT_NEAR((ellipse->shape_px - Shape()).norm(), 0.0, 1e-7);
}

TEST(EllipseFit, IsExactOnFivePointsOfHalfARim) {
  const auto ellipse = FitEllipse(Rim(5, 0.0, kPi));
  ASSERT_TRUE(ellipse);
  EXPECT_NEAR((ellipse->centre_px - kCentre).norm(), 0.0, 1e-5);
}

TEST(EllipseFit, AveragesNoiseDown) {
  // 64 points with 0.1 px: the centre's sigma per axis is sigma sqrt(2/N) = 0.018 px; 5 sigma.
  std::vector<Eigen::Vector2d> rim = Rim(64, 0.0, 2.0 * kPi);
  RandomStream random(11);
  for (Eigen::Vector2d& p : rim) p += 0.1 * Eigen::Vector2d(random.Normal(), random.Normal());
  const auto ellipse = FitEllipse(rim);
  ASSERT_TRUE(ellipse);
  EXPECT_LT((ellipse->centre_px - kCentre).norm(), 0.09);
}

TEST(EllipseFit, RefusesFourPoints) { EXPECT_FALSE(FitEllipse(Rim(4, 0.0, 2.0 * kPi))); }

TEST(EllipseFit, RefusesPointsOnALine) {
  std::vector<Eigen::Vector2d> line;
  for (int i = 0; i < 12; ++i) line.emplace_back(3.0 * i, 40.0 + 2.0 * i);
  EXPECT_FALSE(FitEllipse(line));
}

TEST(Ellipse, MeanRadiusKeepsTheArea) {
  const Ellipse ellipse{.centre_px = kCentre, .shape_px = Shape()};
  EXPECT_NEAR(ellipse.mean_radius_px(), std::sqrt(9.0 * 14.0), 1e-12);
}

TEST(Ellipse, MapsItsRimToTheUnitCircle) {
  const Ellipse ellipse{.centre_px = kCentre, .shape_px = Shape()};
  for (const Eigen::Vector2d& p : Rim(7, 0.0, 2.0 * kPi)) {
    EXPECT_NEAR(ellipse.ToDisc(p).norm(), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace dockyard
