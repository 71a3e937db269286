#include "sim/rigid/ground_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/rigid/ground_contact.h"

namespace dockyard {
namespace {

constexpr double kDt = 1e-3;
const GroundMaterial kSole{1e5, 300.0, 0.4};

/// A block on one point under gravity that is tilted by a slope.
struct Block {
  HeightGrid ground = LevelGrid(-1.0, 2.0, 2.0, 0.1);
  GroundPoint point;
  Eigen::Vector3d p = Eigen::Vector3d(0.0, 0.0, -10.0 * 9.81 / 1e5), v = Eigen::Vector3d::Zero();
  void Slide(double slope_rad, double seconds) {
    const Eigen::Vector3d g(9.81 * std::sin(slope_rad), 0.0, -9.81 * std::cos(slope_rad));
    for (long i = 0; i < std::lround(seconds / kDt); ++i) {
      v += (g + GroundForce(ground, kSole, p, v, kDt, point) / 10.0) * kDt;
      p += v * kDt;
    }
  }
};

TEST(Ground, CarriesTheWeightAtTheDepthOfHookesLaw) {
  Block block;
  block.Slide(0.0, 2.0);
  EXPECT_NEAR(block.p.z(), -10.0 * 9.81 / 1e5, 1e-9);
}

TEST(Ground, HoldsABlockBelowTheAngleOfFrictionWithoutCreep) {
  Block block;
  block.Slide(std::atan(0.39), 2.0);
  const double x = block.p.x();
  block.Slide(std::atan(0.39), 10.0);
  EXPECT_NEAR(block.p.x(), x, 1e-9);
}

TEST(Ground, LetsABlockSlideAboveTheAngleOfFriction) {
  Block block;
  const double slope = std::atan(0.5);
  block.Slide(slope, 0.5);  // the bristle bends first, the block settles
  const double speed = block.v.x();
  block.Slide(slope, 1.0);
  EXPECT_NEAR(block.v.x() - speed, 9.81 * (std::sin(slope) - 0.4 * std::cos(slope)), 1e-3);
}

TEST(Ground, NeverPulls) {
  const HeightGrid ground = LevelGrid(-1.0, 2.0, 2.0, 0.1);
  GroundPoint point;
  const Eigen::Vector3d force = GroundForce(ground, kSole, {0, 0, -1e-4}, {0, 0, 5.0}, kDt, point);
  EXPECT_EQ(force.z(), 0.0);
  EXPECT_EQ(force.norm(), 0.0);
}

TEST(Ground, ForgetsItsGripWhenLifted) {
  const HeightGrid ground = LevelGrid(-1.0, 2.0, 2.0, 0.1);
  GroundPoint point;
  for (int i = 0; i < 100; ++i) GroundForce(ground, kSole, {0, 0, -1e-3}, {1, 0, 0}, kDt, point);
  EXPECT_GT(point.bend_G.norm(), 0.0);
  GroundForce(ground, kSole, {0, 0, 1e-3}, {1, 0, 0}, kDt, point);
  EXPECT_EQ(point.bend_G.norm(), 0.0);
}

}  // namespace
}  // namespace dockyard
