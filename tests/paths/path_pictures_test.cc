#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "motion/rover_sample.h"
#include "sim/paths/path_svg.h"
#include "sim/paths/path_watch.h"
#include "sim/paths/plan_meshes.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

PathTask Task() {
  PathTask task;
  task.rover = RockySample();
  int number = 0;
  for (WheelPlan& wheel : task.rover.wheels) wheel.name += std::to_string(number++);
  task.rover.speed_m_s = 0.05;
  task.rover.steer_rate_rad_s = 0.5;
  task.p_RP = task.rover.p_RP;
  task.p_AG = {2.6, 1.0};
  task.heading = 0.0;
  task.limits = LimitsOf(task.rover.wheels, Travel::kEither);
  task.demands.obstacles.discs = {{{1.0, -0.8}, 0.1}};
  return task;
}

int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(PathSvg, DrawsTheRoverAtTheStartAtTheJointAndAtTheGoal) {
  const PathTask task = Task();
  const std::string svg = PathSvg(task, PlanPath(task));
  EXPECT_EQ(Count(svg, "fill=\"#777777\""), 3 * 6);  // wheels
  EXPECT_THAT(svg, HasSubstr("class=\"obstacles\""));
  EXPECT_THAT(svg, HasSubstr("front0"));
  EXPECT_THAT(svg, HasSubstr("cost 2.3"));
}

TEST(PathSvg, SaysWhenThereIsNoPath) {
  PathTask task = Task();
  task.demands.obstacles.discs = {{task.p_AG, 0.3}};
  const PlannedPath plan = PlanPath(task);
  EXPECT_FALSE(plan.best);
  EXPECT_THAT(PathSvg(task, plan), HasSubstr("There are no such arcs."));
}

// Wheels roll as far as their ways are long, at most at the rover's speed and steering rate.
TEST(WatchedPath, EndsAtTheGoalWithinSpeedAndSteeringRate) {
  const PathTask task = Task();
  const PlannedPath plan = PlanPath(task);
  const LoggedRun run = WatchedPath(task, plan);
  const Pose2 X_AE = ToGround(run.X_WO[0].back());
  EXPECT_LT((X_AE * task.p_RP - task.p_AG).norm(), 1e-9);
  ASSERT_EQ(run.X_WO.size(), 1u + 6u + 1u);
  for (const auto& track : run.X_WO) EXPECT_EQ(track.size(), run.times_s.size());
  for (std::size_t k = 1; k < run.times_s.size(); ++k) {
    const double period_s = run.times_s[k] - run.times_s[k - 1];
    for (const WheelPlan& wheel : task.rover.wheels) {
      const auto& steer = run.truth.at("steer_" + wheel.name + "_deg");
      EXPECT_LE(std::abs(Radians(steer[k] - steer[k - 1])), 0.5 * period_s + 1e-9);
      EXPECT_LE(std::abs(run.truth.at("speed_" + wheel.name + "_m_s")[k]), 0.05 + 1e-12);
    }
  }
  EXPECT_EQ(run.notes.size(), 5u);  // steering and driving, twice, and the goal
  EXPECT_EQ(ShapesOf(task).bodies.size(), run.body_names.size());
}

// Volume by the divergence theorem: outward triangles of a closed surface.
TEST(PrismMesh, HasTheVolumeOfItsAreaEitherWayRound) {
  const Polygon area{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  for (const Polygon& corners : {area, Polygon(area.rbegin(), area.rend())}) {
    const auto mesh = PrismMesh(corners, 0.5, 2.0);
    double volume = 0.0;
    for (const auto& triangle : mesh->triangles) {
      const Eigen::Vector3f a = mesh->vertices[triangle[0]], b = mesh->vertices[triangle[1]],
                            c = mesh->vertices[triangle[2]];
      volume += a.dot(b.cross(c)) / 6.0;
    }
    EXPECT_NEAR(volume, 3.0, 1e-5);
  }
}

}  // namespace
}  // namespace dockyard
