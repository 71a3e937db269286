// Time of a plan beside the Reeds-Shepp path of OMPL, and of plans among obstacles. CPU time; on a
// busy machine only the ratio holds.
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "controller/motion/free_path.h"
#include "controller/motion/steering.h"
#include "motion/rover_sample.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

double Cpu_s() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Turning radius of both; goals as an approach has them.
constexpr double kRadius_m = 0.5;

void CompareWithReedsShepp() {
  constexpr int kGoals = 2000, kRounds = 9;
  RandomStream random(StreamKey(1, "arc speed"));
  std::vector<Pose2> goals;
  for (int i = 0; i < kGoals; ++i) {
    goals.push_back({random.Uniform(-1, 3), random.Uniform(-2, 2), random.Uniform(-kPi, kPi)});
  }
  const ompl::base::ReedsSheppStateSpace space(kRadius_m);
  using State = ompl::base::SE2StateSpace::StateType;
  State* from = static_cast<State*>(space.allocState());
  State* to = static_cast<State*>(space.allocState());
  from->setXY(0.0, 0.0);
  from->setYaw(0.0);
  double sum_m = 0.0, ours_s = 1e9, theirs_s = 1e9;
  for (int round = 0; round < kRounds; ++round) {
    double start_s = Cpu_s();
    for (const Pose2& goal : goals) {
      const auto pair = CheapestPair(goal, {kRadius_m});
      sum_m += pair ? PairCost(*pair) : 0.0;
    }
    ours_s = std::min(ours_s, Cpu_s() - start_s);
    start_s = Cpu_s();
    for (const Pose2& goal : goals) {
      to->setXY(goal.x, goal.y);
      to->setYaw(goal.heading);
      sum_m += space.distance(from, to);
    }
    theirs_s = std::min(theirs_s, Cpu_s() - start_s);
  }
  space.freeState(from);
  space.freeState(to);
  std::printf("two arcs %.2f us, Reeds-Shepp of OMPL %.2f us: %.2f times as long (mean %.2f m)\n",
              1e6 * ours_s / kGoals, 1e6 * theirs_s / kGoals, ours_s / theirs_s,
              sum_m / (2.0 * kRounds * kGoals));
}

void TimeFreePlans(bool cornered) {
  constexpr int kScenes = 400, kObstacles = 30;
  RandomStream random(StreamKey(7, "free plans"));
  const RoverPlan rover = RockySample();
  const ArcLimits limits = LimitsOf(rover.wheels, Travel::kEither);
  std::vector<double> times_ms;
  double sum_ms = 0.0;
  for (int i = 0; i < kScenes; ++i) {
    const Pose2 goal{random.Uniform(0.5, 3), random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5)};
    const PathDemands demands = SampleDemands(random, goal, kObstacles, cornered);
    const double start_s = Cpu_s();
    (void)CheapestFreePair(rover, goal, limits, demands);
    times_ms.push_back(1e3 * (Cpu_s() - start_s));
    sum_ms += times_ms.back();
  }
  std::sort(times_ms.begin(), times_ms.end());
  std::printf("among 30 %s: mean %.2f ms, 95 %% within %.2f ms, at most %.2f ms\n",
              cornered ? "pentagons" : "discs", sum_ms / kScenes, times_ms[kScenes * 95 / 100],
              times_ms.back());
}

}  // namespace
}  // namespace dockyard

int main() {
  dockyard::CompareWithReedsShepp();
  for (const bool cornered : {false, true}) dockyard::TimeFreePlans(cornered);
}
