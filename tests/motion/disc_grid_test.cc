#include "controller/motion/disc_grid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "controller/motion/steering.h"
#include "motion/rover_sample.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

std::vector<Disc> StrewnDiscs(RandomStream& random, int count, double within_m) {
  std::vector<Disc> discs;
  for (int i = 0; i < count; ++i) {
    const double radius_m = i % 100 == 0 ? random.Uniform(1, 20) : random.Uniform(0.02, 0.2);
    discs.push_back(
        {{random.Uniform(-within_m, within_m), random.Uniform(-within_m, within_m)}, radius_m});
  }
  return discs;
}

std::vector<Eigen::Vector2d> PlacesAlong(const std::vector<Arc>& path, int steps) {
  std::vector<Eigen::Vector2d> places;
  Pose2 X_AR;
  for (const Arc& arc : path) {
    for (int step = 0; step <= steps; ++step) {
      const Pose2 at = Advance(X_AR, Part(arc, static_cast<double>(step) / steps));
      places.emplace_back(at.x, at.y);
    }
    X_AR = Advance(X_AR, arc);
  }
  return places;
}

// Places along the path are compared with every disc.
TEST(DiscGrid, LeavesOutNoDiscThatAPathComesNear) {
  RandomStream random(StreamKey(1, "grid"));
  const std::vector<Disc> discs = StrewnDiscs(random, 1000, 30.0);
  const DiscGrid grid(discs);
  constexpr double kReach_m = 0.5;
  std::size_t most = 0;
  for (int path = 0; path < 24; ++path) {
    const double length_m = path < 20 ? 3.0 : 60.0;  // the last ones leave the discs' area
    std::vector<Arc> arcs;
    for (int i = 0; i < 2; ++i) {
      arcs.push_back({random.Uniform(-length_m, length_m), random.Uniform(-3, 3)});
    }
    const std::vector<Disc> near = grid.Near(arcs, kReach_m);
    if (path < 20) most = std::max(most, near.size());
    const std::vector<Eigen::Vector2d> places = PlacesAlong(arcs, 150);
    std::size_t next = 0;  // in the order in which they were given
    for (const Disc& disc : discs) {
      if (next < near.size() && near[next].centre == disc.centre) {
        ++next;
        continue;
      }
      const double far_m = disc.radius_m + kReach_m;
      for (const Eigen::Vector2d& place : places) {
        ASSERT_GT((disc.centre - place).squaredNorm(), far_m * far_m) << path;
      }
    }
    EXPECT_EQ(next, near.size());
  }
  EXPECT_LT(most, discs.size() / 4);
}

TEST(DiscGrid, TakesNoDiscsOneDiscAndDiscsInALine) {
  EXPECT_TRUE(DiscGrid({}).Near({{1.0, 0.0}}, 1.0).empty());
  EXPECT_EQ(DiscGrid({{{1.0, 0.0}, 0.1}}).Near({}, 2.0).size(), 1u);
  std::vector<Disc> line;
  for (int i = 0; i < 2000; ++i) line.push_back({{0.5 * i, 0.0}, 0.1});
  EXPECT_EQ(DiscGrid(line).Near({{1.0, 0.0}}, 0.2).front().centre.x(), 0.0);
}

// Bit for bit: the discs near a path decide alone.
TEST(CheapestFreePair, IsTheSameWithAGrid) {
  RandomStream random(StreamKey(2, "grid"));
  const RoverPlan rover = RockySample();
  const ArcLimits limits = LimitsOf(rover.wheels, Travel::kEither);
  int found = 0;
  for (int i = 0; i < 8; ++i) {
    const Pose2 goal{random.Uniform(0.5, 3), random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5)};
    PathDemands demands = SampleDemands(random, goal, 8, false);
    for (Disc disc : StrewnDiscs(random, 300, 60.0)) {
      disc.radius_m = std::min(disc.radius_m, 0.2);
      if (disc.centre.norm() > 5.0) demands.obstacles.discs.push_back(disc);
    }
    const auto all = CheapestFreePair(rover, goal, limits, demands);
    const auto near = CheapestFreePair(rover, goal, limits, WithGrid(demands));
    ASSERT_EQ(all.has_value(), near.has_value()) << i;
    if (!all) continue;
    ++found;
    for (std::size_t arc = 0; arc < 2; ++arc) {
      EXPECT_EQ((*all)[arc].length_m, (*near)[arc].length_m);
      EXPECT_EQ((*all)[arc].turn_rad, (*near)[arc].turn_rad);
    }
    const std::vector<Arc> path{Arc{2.0, 0.5}, Arc{-1.0, 1.0}};
    EXPECT_EQ(MissingOf(rover, demands, path), MissingOf(rover, WithGrid(demands), path));
  }
  EXPECT_GT(found, 2);
}

}  // namespace
}  // namespace dockyard
