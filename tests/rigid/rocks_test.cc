// Sizes of rocks against the law of Golombek and Rapp (1997), their shapes against the sizes, their
// places against each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/rigid/rocks.h"

namespace dockyard {
namespace {

constexpr GroundArea kField{-20.0, 20.0, -20.0, 20.0};  // 1600 m^2

RockField Field(double cover) {
  RockField field;
  field.cover = cover;
  return field;
}

/// Share of the ground that is covered by rocks of at least this diameter, of a cover k by all:
/// k exp(-q D) with q = 1.79 + 0.152 / k (Golombek and Rapp, JGR 102, 1997).
double RockCover(double cover, double diameter_m) {
  return cover * std::exp(-(1.79 + 0.152 / cover) * diameter_m);
}

TEST(RocksPerArea, CoverByTheirCirclesWhatTheLawSays) {
  // Cut into narrow classes, the numbers times their circles add up to the cover.
  const double cover = 0.1;
  double covered = 0.0;
  for (double d = 0.05; d < 0.2999; d += 0.001) {
    const double middle = d + 0.0005;
    covered += RocksPerArea(cover, d, d + 0.001) * 0.25 * kPi * middle * middle;
  }
  EXPECT_NEAR(covered, RockCover(cover, 0.05) - RockCover(cover, 0.30), 1e-5);
}

TEST(RockField, HasTheLawsNumberOfEachSize) {
  const std::vector<double> bounds{0.05, 0.07, 0.10, 0.15, 0.30};
  for (const double cover : {0.03, 0.1, 0.2}) {
    std::vector<double> counts(bounds.size() - 1, 0.0);
    for (const Rock& rock : PlaceRocks(Field(cover), {-10, 10, -10, 10}, {}, 1)) {
      for (std::size_t i = 0; i < counts.size(); ++i) {
        const double d = rock.size.diameter_m;
        if (d >= bounds[i] && d < bounds[i + 1]) counts[i] += 1.0;
      }
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
      // A Poisson count scatters by its root.
      const double expected = 400.0 * RocksPerArea(cover, bounds[i], bounds[i + 1]);
      EXPECT_NEAR(counts[i], expected, 3.0 * std::sqrt(expected)) << cover << ' ' << bounds[i];
    }
  }
}

TEST(RockField, CoversTheShareOfTheGroundThatTheLawSays) {
  const double cover = 0.1;
  double covered = 0.0, scatter = 0.0;
  for (const Rock& rock : PlaceRocks(Field(cover), {-10, 10, -10, 10}, {}, 3)) {
    const double circle = 0.25 * kPi * rock.size.diameter_m * rock.size.diameter_m;
    covered += circle / 400.0;
    scatter += circle * circle / (400.0 * 400.0);
  }
  EXPECT_NEAR(covered, RockCover(cover, 0.05) - RockCover(cover, 0.30), 4.0 * std::sqrt(scatter));
}

TEST(RockField, RocksHaveTheirSizesAndDoNotOverlap) {
  const std::vector<Rock> rocks = PlaceRocks(Field(0.2), {-5, 5, -5, 5}, {}, 7);
  ASSERT_GT(rocks.size(), 100u);
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    const Rock& rock = rocks[i];
    EXPECT_GE(rock.size.height_m, 0.375 * rock.size.diameter_m);
    EXPECT_LE(rock.size.height_m, 0.5 * rock.size.diameter_m);
    double top = -1.0, bottom = 1.0;
    for (const Eigen::Vector3d& p : rock.body.vertices) {
      top = std::max(top, p.z());
      bottom = std::min(bottom, p.z());
    }
    EXPECT_NEAR(top, rock.size.height_m, 1e-12);
    EXPECT_NEAR(-bottom / (top - bottom), 0.3, 1e-12);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE((rocks[j].p_D - rock.p_D).norm(),
                0.5 * (rocks[j].size.diameter_m + rock.size.diameter_m));
    }
  }
}

TEST(RockShape, IsAsWideAsItsDiameterOnTheMeanAndHasALevelTop) {
  for (std::uint64_t key = 1; key <= 30; ++key) {
    const ConvexBody body = RockShape({0.2, 0.08}, 0.3, 0.0, key);
    Eigen::Vector3d low = body.vertices[0], high = low;
    int top_corners = 0;
    for (const Eigen::Vector3d& p : body.vertices) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
      if (p.z() > 0.08 - 1e-9) ++top_corners;
    }
    EXPECT_NEAR(0.5 * (high.x() - low.x() + high.y() - low.y()), 0.2, 1e-12);
    EXPECT_NEAR(high.x() + low.x(), 0.0, 1e-12);
    EXPECT_NEAR(high.z(), 0.08, 1e-12);
    EXPECT_GE(top_corners, 3);
    EXPECT_GT(DistanceTo(body, {0.0, 0.0, 0.0}).distance_m, -0.2);
    EXPECT_LT(DistanceTo(body, {0.0, 0.0, 0.04}).distance_m, 0.0);  // solid amid its height
  }
}

TEST(RockField, LeavesClearCirclesFreeAndIsOtherwiseTheSame) {
  RockField field = Field(0.1);
  const std::vector<Eigen::Vector2d> clear{{0.0, 0.0}, {4.0, 1.0}};
  const std::vector<Rock> all = PlaceRocks(field, {-5, 5, -5, 5}, {}, 9);
  const std::vector<Rock> some = PlaceRocks(field, {-5, 5, -5, 5}, clear, 9);
  std::size_t at = 0, taken = 0;
  for (const Rock& rock : all) {
    const bool in_the_way = std::any_of(clear.begin(), clear.end(), [&](const auto& p) {
      return (rock.p_D - p).norm() < field.clear_m + 0.5 * rock.size.diameter_m;
    });
    if (in_the_way) {
      ++taken;
      continue;
    }
    ASSERT_LT(at, some.size());
    EXPECT_EQ(some[at].p_D, rock.p_D);
    EXPECT_EQ(some[at++].body.vertices[0], rock.body.vertices[0]);
  }
  EXPECT_EQ(at, some.size());
  EXPECT_GT(taken, 5u);
}

TEST(RockField, GivenRocksStandWhereTheyAreGivenEvenInAClearCircle) {
  RockField field = Field(0.0);
  field.given = {{1.0, 0.5, 0.2, 0.08, 0.0}, {1.0, -0.5, 0.2, 0.08, 0.5 * kPi}};
  const std::vector<Rock> rocks = PlaceRocks(field, kField, {{1.0, 0.0}}, 4);
  ASSERT_EQ(rocks.size(), 2u);
  EXPECT_TRUE(rocks[0].given);
  EXPECT_LT(DistanceTo(rocks[0].body, {1.0, 0.5, 0.04}).distance_m, 0.0);
  EXPECT_LT(DistanceTo(rocks[1].body, {1.0, -0.5, 0.04}).distance_m, 0.0);
  EXPECT_GT(DistanceTo(rocks[1].body, {1.0, 0.0, 0.04}).distance_m, 0.0);
}

TEST(RockField, RefusesMoreRocksThanCanBeKept) {
  EXPECT_THROW(PlaceRocks(Field(0.3), {-50, 50, -50, 50}, {}, 1), std::length_error);
}

}  // namespace
}  // namespace dockyard
