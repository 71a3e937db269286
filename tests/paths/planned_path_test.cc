#include "sim/paths/planned_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/rover_sample.h"
#include "sim/paths/path_json.h"

namespace dockyard {
namespace {

PathTask TaskTo(double x, double y, std::optional<double> heading) {
  PathTask task;
  task.rover = RockySample();
  task.p_RP = task.rover.p_RP;
  task.p_AG = {x, y};
  task.heading = heading;
  task.limits = LimitsOf(task.rover.wheels, Travel::kEither);
  return task;
}

double MissOfPoint(const PathTask& task, const std::vector<Arc>& arcs) {
  return (Advance({}, arcs) * task.p_RP - task.p_AG).norm();
}

TEST(PlanPath, BringsThePointToTheGoalByAllCandidatesAndNoneUsableIsCheaper) {
  for (const PathTask& task :
       {TaskTo(2.6, 1.0, 0.0), TaskTo(2.3, 1.1, 0.9), TaskTo(1.5, 0.3, {})}) {
    const PlannedPath plan = PlanPath(task);
    ASSERT_TRUE(plan.best);
    EXPECT_LT(MissOfPoint(task, plan.best->arcs), 1e-9);
    EXPECT_TRUE(plan.best->IsUsable());
    EXPECT_GE(plan.candidates.size(), task.heading ? 30u : 2u);
    for (const Candidate& candidate : plan.candidates) {
      EXPECT_LT(MissOfPoint(task, candidate.arcs), 1e-9);
      if (candidate.IsUsable()) {
        EXPECT_GE(candidate.cost_m, plan.best->cost_m - 1e-9);
      }
    }
  }
}

// The two drawings of the paper: pairs that change the steering direction, and pairs that keep it.
TEST(PlanPath, ChangesTheSteeringDirectionForAnEqualHeadingAndKeepsItOnAWayRound) {
  const auto s_curve = PlanPath(TaskTo(2.6, 1.0, 0.0)).best;
  ASSERT_TRUE(s_curve);
  EXPECT_LT(s_curve->arcs[0].turn_rad * s_curve->arcs[1].turn_rad, 0.0);
  const auto c_curve = PlanPath(TaskTo(2.3, 1.1, Radians(50.0))).best;
  ASSERT_TRUE(c_curve);
  EXPECT_GT(c_curve->arcs[0].turn_rad * c_curve->arcs[1].turn_rad, 0.0);
}

TEST(PlanPath, LeavesTheWayThatAnObstacleBlocks) {
  PathTask task = TaskTo(2.0, 0.5, {});
  const PlannedPath free = PlanPath(task);
  ASSERT_TRUE(free.best);
  const Eigen::Vector2d middle = Advance({}, Part(free.best->arcs[0], 0.7)) * task.p_RP;
  task.demands = {{{{middle, 0.05}}, {}}, 0.02, {}};
  const PlannedPath blocked = PlanPath(task);
  EXPECT_GT(blocked.candidates[0].missing_m, 0.0);
  if (blocked.best) {
    EXPECT_GT(blocked.best->cost_m, free.best->cost_m);
  }
}

TEST(PlanPath, SaysThatTheRoverIsThereAlready) {
  const PlannedPath plan = PlanPath(TaskTo(0.61, 0.0, {}));
  ASSERT_TRUE(plan.best);
  EXPECT_TRUE(plan.best->arcs.empty());
}

TEST(PosesAlong, AreNoFartherApartThanAskedAndHaveTheJoints) {
  const std::vector<Arc> path{{0.5, 1.0}, {-0.3, 0.0}, {0.0, 0.7}};
  const std::vector<Pose2> poses = PosesAlong(path, 0.04, 0.08);
  EXPECT_EQ(poses.front(), Pose2{});
  EXPECT_EQ(poses.back(), Advance({}, path));
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_LE(std::hypot(poses[i].x - poses[i - 1].x, poses[i].y - poses[i - 1].y), 0.04 + 1e-12);
    EXPECT_LE(std::abs(WrapPi(poses[i].heading - poses[i - 1].heading)), 0.08 + 1e-12);
  }
}

// Closed forms of Ackermann steering: atan2(L, r -+ w), and the tandem's side slip.
TEST(PathJson, HasTheWheelsOfEachArc) {
  PathTask task = TaskTo(0.0, 0.0, {});
  task.p_RP = {0.0, 0.0};
  task.p_AG = {0.5, 0.5};  // a quarter of a circle of 0.5 m
  const Json json = PathJson(task, PlanPath(task));
  const Json& wheels = json["arcs"][0]["wheels"];
  EXPECT_NEAR(json["arcs"][0]["turn_rad"].get<double>(), 0.5 * kPi, 1e-12);
  // The sample names its wheels by place alone: the right ones come last.
  EXPECT_NEAR(wheels["front"]["steer_rad"].get<double>(), std::atan2(0.40875, 0.7), 1e-12);
  EXPECT_NEAR(std::abs(wheels["back"]["side_slip_rad"].get<double>()), std::atan2(0.069, 0.7),
              1e-12);
  EXPECT_NEAR(wheels["middle"]["way_m"].get<double>(), 0.7 * 0.5 * kPi, 1e-12);
}

}  // namespace
}  // namespace dockyard
