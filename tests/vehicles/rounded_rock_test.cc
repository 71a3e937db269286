#include "sim/vehicles/rounded_rock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/base/median.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kRocks = 40;

StarBody Rock(std::uint64_t key, double roughness_m = 0.0) {
  return MakeRoundedRock({.width_m = 0.6, .target_up_m = 0.25, .roughness_m = roughness_m}, key);
}

TEST(RoundedRock, ItsSummitLiesOverTheOrigin) {
  for (std::uint64_t key = 1; key <= kRocks; ++key) {
    const StarBody rock = Rock(key, 1e-3);
    double highest_m = 0.0;
    for (const Vector3d& p : rock.vertices) highest_m = std::max(highest_m, p.z());
    EXPECT_DOUBLE_EQ(highest_m, 0.25);
    EXPECT_NEAR(DepthIn(rock, {0.0, 0.0, 0.25}).depth_m, 0.0, 1e-9);
  }
}

// A ridge would have no summit: a rover's map could not tell where along it a user clicked.
TEST(RoundedRock, ItsTopIsAPlaceAndNoRidge) {
  std::vector<double> across_m;
  for (std::uint64_t key = 1; key <= kRocks; ++key) {
    double farthest_m = 0.0;
    for (const Vector3d& p : Rock(key).vertices) {
      if (p.z() > 0.245) farthest_m = std::max(farthest_m, p.head<2>().norm());
    }
    across_m.push_back(farthest_m);
  }
  EXPECT_LT(*std::ranges::max_element(across_m), 0.16);
  EXPECT_LT(Median(across_m), 0.09);
}

// The drop at 3 cm from the summit, over all directions, is that of a dome: r^2 / (2 R).
TEST(RoundedRock, ItsSummitIsRound) {
  std::vector<double> radii_m;
  for (std::uint64_t key = 1; key <= kRocks; ++key) {
    const StarBody rock = Rock(key);
    double drop_m = 0.0;
    for (int i = 0; i < 16; ++i) {
      const double angle = 2.0 * kPi * i / 16;
      const auto at = FirstOnRay(rock, {0.03 * std::cos(angle), 0.03 * std::sin(angle), 1.0},
                                 -Vector3d::UnitZ());
      ASSERT_TRUE(at);
      drop_m += (0.25 - at->z()) / 16;
    }
    radii_m.push_back(0.03 * 0.03 / (2.0 * drop_m));
  }
  EXPECT_GT(*std::ranges::min_element(radii_m), 0.03);
  EXPECT_GT(Median(radii_m), 0.08);
  EXPECT_LT(Median(radii_m), 0.4);
}

TEST(RoundedRock, IsAsWideAsItWasAskedToBe) {
  double sum_m = 0.0;
  for (std::uint64_t key = 1; key <= kRocks; ++key) {
    const StarBody rock = Rock(key);
    Vector3d low(0.0, 0.0, 0.0), high = low;
    for (const Vector3d& p : rock.vertices) {
      if (p.z() < 0.0) continue;  // in the ground
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    sum_m += 0.5 * (high - low).head<2>().sum() / kRocks;
  }
  EXPECT_NEAR(sum_m, 0.6, 0.06);
}

// Between two points of a convex surface all is inside.
TEST(RoundedRock, HasHollows) {
  int hollow = 0;
  for (std::uint64_t key = 1; key <= kRocks; ++key) {
    const StarBody rock = Rock(key);
    double deepest_m = 0.0;
    for (std::size_t i = 0; i < rock.vertices.size(); i += 7) {
      for (std::size_t j = i + 50; j < rock.vertices.size(); j += 301) {
        const Vector3d middle = 0.5 * (rock.vertices[i] + rock.vertices[j]);
        if ((rock.vertices[i] - rock.vertices[j]).norm() > 0.25) continue;
        deepest_m = std::max(deepest_m, -DepthIn(rock, middle).depth_m);
      }
    }
    hollow += deepest_m > 2e-3;
  }
  EXPECT_GE(hollow, static_cast<int>(kRocks) / 3);
}

// Of a can's face on it: triangles of 9 mm, hollows and rounded edges turn it by some degrees.
TEST(RoundedRock, ItsTargetHasTheNormalThatWasAskedFor) {
  std::vector<double> off_deg;
  for (std::uint64_t key = 1; key <= kRocks; ++key) {
    for (const double up_deg : {20.0, 40.0, 55.0}) {
      const double up_rad = Radians(up_deg), turn_rad = Radians(30.0);
      const StarBody rock = MakeRoundedRock(
          {.target_up_m = 0.25, .face_up_rad = up_rad, .face_turn_rad = turn_rad}, key);
      const Vector3d normal(std::cos(up_rad) * std::cos(turn_rad),
                            std::cos(up_rad) * std::sin(turn_rad), std::sin(up_rad));
      EXPECT_NEAR(DepthIn(rock, {0.0, 0.0, 0.25}).depth_m, 0.0, 1e-9);
      const auto felt = NormalUnderDisc(rock, {0.0, 0.0, 0.25}, normal, 0.033);
      ASSERT_TRUE(felt);
      off_deg.push_back(Degrees(std::acos(std::min(1.0, felt->dot(normal)))));
    }
  }
  EXPECT_LT(Median(off_deg), 5.0);
  EXPECT_LT(*std::ranges::max_element(off_deg), 30.0);
}

TEST(RoundedRock, SameKeySameRock) {
  EXPECT_EQ(Rock(7, 1e-3).vertices, Rock(7, 1e-3).vertices);
  EXPECT_NE(Rock(7, 1e-3).vertices, Rock(8, 1e-3).vertices);
}

}  // namespace
}  // namespace dockyard
