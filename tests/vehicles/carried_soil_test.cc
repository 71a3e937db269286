// Soil that shut scoops lift, against the volume between their floors and its own slope.
#include "sim/vehicles/carried_soil.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "models/parts/scoop_shape.h"
#include "vehicles/stone_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

/// Scoops that hang straight down, their lips this deep in level sand at first.
struct Hand {
  Hand(ScoopSides sides, double lips_m)
      : scoop(RoverRig::Model("rocky7").arm->scoop),
        soil(SoilNamed("loose_sand")),
        ground(LevelGrid(-0.5, 1.0, 1.0, 5e-3)) {
    scoop.sides = sides;
    carried.emplace(scoop, std::vector<SoilModel>{soil});
    motion.X_GL.p.z() = scoop.depth_m - lips_m;
    carried->Step(ground, {&motion, &motion}, 0.0);
  }
  void Raise(double by_m, double open_rad = 0.0) {
    for (int i = 0; i < 200; ++i) {
      motion.X_GL.p.z() += by_m / 200;
      loads = carried->Step(ground, {&motion, &motion}, open_rad);
    }
  }
  double InGround_m3() const {
    const auto& heights = ground.heights_m;
    return std::accumulate(heights.begin(), heights.end(), 0.0) * ground.cell_m * ground.cell_m;
  }
  double Weight_n() const { return -(loads[0].force_G + loads[1].force_G).z(); }

  ScoopModel scoop;
  SoilModel soil;
  HeightGrid ground;
  LinkMotion motion;
  std::optional<CarriedSoil> carried;
  std::array<CarriedSoil::Load, 2> loads{};
};

/// Over both floors: below the ground as it was, and no steeper than the soil from an open side.
double Volume_m3(const Hand& hand, double lips_m) {
  const auto profile = ScoopProfile(hand.scoop);
  const double rise = (profile[2] - profile[3]).y() / (profile[2] - profile[3]).x();
  constexpr int kCells = 400;
  const double dx = profile[2].x() / kCells, dy = hand.scoop.width_m / kCells;
  double volume_m3 = 0.0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const double side_m = 0.5 * hand.scoop.width_m - std::abs((j + 0.5) * dy - 0.025);
      const double slope_m = side_m * std::tan(hand.soil.friction_angle_rad);
      const double depth_m = std::max(0.0, lips_m - rise * (i + 0.5) * dx);
      const bool open = hand.scoop.sides == ScoopSides::kOpen;
      volume_m3 += 2.0 * dx * dy * (open ? std::min(depth_m, slope_m) : depth_m);
    }
  }
  return volume_m3;
}

TEST(CarriedSoil, IsWhatLayOnTheFloorsAndWeighsSoMuch) {
  for (const ScoopSides sides : {ScoopSides::kClosed, ScoopSides::kOpen}) {
    for (const double lips_m : {0.005, 0.012, 0.02}) {
      Hand hand(sides, lips_m);
      hand.Raise(0.06);
      const double expected_m3 = Volume_m3(hand, lips_m);
      EXPECT_NEAR(hand.carried->volume_m3(), expected_m3, 0.05 * expected_m3) << lips_m;
      EXPECT_NEAR(hand.InGround_m3(), -hand.carried->volume_m3(), 1e-12);
      const double weight_n =
          hand.soil.density_kg_m3 * kEarthGravity_m_s2 * hand.carried->volume_m3();
      EXPECT_NEAR(hand.Weight_n(), weight_n, 1e-9);
    }
  }
}

// 2 cm deep in sand open scoops bring up as much as a stone of 4 cm weighs.
TEST(CarriedSoil, WeighsLikeAStoneBetweenOpenSides) {
  Hand hand(ScoopSides::kOpen, 0.02);
  hand.Raise(0.06);
  EXPECT_GT(hand.Weight_n() / kEarthGravity_m_s2, 0.010);
  EXPECT_LT(hand.Weight_n() / kEarthGravity_m_s2, 0.060);
}

TEST(CarriedSoil, NoneIsTakenWithoutDepthNorThroughPartedLips) {
  Hand above(ScoopSides::kOpen, -0.001);
  above.Raise(0.06);
  EXPECT_EQ(above.carried->volume_m3(), 0.0);
  Hand apart(ScoopSides::kOpen, 0.02);
  apart.Raise(0.0, 0.2);
  apart.Raise(0.06, 0.2);  // 10 mm
  EXPECT_EQ(apart.carried->volume_m3(), 0.0);
}

TEST(CarriedSoil, FallsBackToTheGroundWhenTheLipsPart) {
  Hand hand(ScoopSides::kOpen, 0.02);
  hand.Raise(0.06);
  ASSERT_LT(hand.InGround_m3(), -1e-6);
  hand.Raise(0.001, 0.2);
  EXPECT_EQ(hand.carried->volume_m3(), 0.0);
  EXPECT_EQ(hand.Weight_n(), 0.0);
  EXPECT_NEAR(hand.InGround_m3(), 0.0, 1e-12);
}

// A pyramid whose sides are as steep as the soil lies along the grid's lines: V = 2 h^3 / (3
// tan^2). Over the hole that it came from it is lower.
TEST(CarriedSoil, FallsAsAHeapThatIsNoSteeperThanItsSoilLies) {
  Hand hand(ScoopSides::kClosed, 0.02);
  hand.Raise(0.06);
  hand.motion.X_GL.p.x() += 0.2;  // from where it was taken
  const double volume_m3 = hand.carried->volume_m3();
  hand.Raise(0.001, 0.2);
  const double tan_phi = std::tan(hand.soil.friction_angle_rad);
  const Eigen::Vector2d at = hand.motion.X_GL.p.head<2>();
  EXPECT_LT(Steepest(hand.ground, at, 0.1), tan_phi + 0.003);
  const double peak_m = std::cbrt(1.5 * volume_m3 * tan_phi * tan_phi);
  const double high_m =
      *std::max_element(hand.ground.heights_m.begin(), hand.ground.heights_m.end());
  EXPECT_GT(high_m, 0.5 * peak_m);
  EXPECT_LT(high_m, 1.01 * peak_m);
}

}  // namespace
}  // namespace dockyard
