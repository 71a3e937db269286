#include "controller/rocky7/face_decision.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/face_scene.h"

namespace dockyard::rocky7 {
namespace {

using testing::HasSubstr;

constexpr FaceApproachOptions kOurs{
    .image_share = 0.3, .least_step_m = 0.12, .most_step_m = 0.6, .corrects = true};

// A rover on level ground that believes the truth.
struct Before {
  Nominal nominal = NominalRover();
  FaceBelief belief;
  FaceProgress progress;

  Before(double x_m, double up_deg, double aside_deg) {
    belief.begun = true;
    belief.p_ET = {x_m, 0.1, 0.4};
    belief.normal_E = NormalOf(up_deg, aside_deg);
    belief.normal_sigma_rad = Radians(1.0);
  }
  FaceAt Face() const { return FaceNow(nominal, {}, belief); }
  double Least_m() const { return LeastStandOff(nominal, Face(), belief.obstacles_E); }
  double ToolOffNow() const { return ToolOff(nominal.mast, Face()); }
  FaceDecision Decide(const FaceApproachOptions& options) {
    return DecideNext(nominal, options, belief, Face(), ToolOffNow(), progress);
  }
  void Drive(const std::vector<Arc>& arcs) {
    for (const Arc& arc : arcs)
      MoveOn(Advance({}, arc), arc.length_m, Eigen::Vector2d(0.0, 0.0), belief);
  }
};

TEST(FaceDecision, FarAwayItIsOneArcWithinTheStepsBounds) {
  Before before(6.0, 25.0, 20.0);
  const FaceDecision next = before.Decide(kOurs);
  ASSERT_EQ(next.arcs.size(), 1u) << next.why_not;
  EXPECT_DOUBLE_EQ(next.arcs[0].length_m, kOurs.most_step_m);
  EXPECT_FALSE(before.progress.near);
}

// The paper's tenth of what is left.
TEST(FaceDecision, TheStepIsItsShareOfTheDistanceToAMetreBeforeTheGoal) {
  const FaceApproachOptions paper{};
  Before before(6.0, 25.0, 0.0);
  const auto goal = GoalFor(before.nominal, before.Face(), before.Least_m(), 1.0);
  ASSERT_TRUE(goal);
  const auto whole = OneArcTo(goal->p_RM_goal, before.nominal.mast.p_RM.head<2>());
  EXPECT_NEAR(before.Decide(paper).arcs.at(0).length_m, 0.1 * whole->length_m, 1e-9);
}

// Without errors of odometry and perception the rover comes to where the tool fits.
TEST(FaceDecision, RepeatedItLeadsToWhereTheToolIsOnTheNormal) {
  for (const double aside_deg : {-30.0, 0.0, 25.0}) {
    Before before(5.0, 30.0, aside_deg);
    int steps = 0;
    FaceDecision next = before.Decide(kOurs);
    while (!next.arcs.empty() && steps < 60) {
      before.Drive(next.arcs);
      next = before.Decide(kOurs);
      ++steps;
    }
    EXPECT_EQ(next.why_not, "") << aside_deg;
    EXPECT_LT(steps, 40);
    EXPECT_LT(Degrees(before.ToolOffNow()), 3.5) << aside_deg;
  }
}

TEST(FaceDecision, WithoutCorrectionsTheArcsOfTheLastMetreAreDrivenWholeAndThatIsAll) {
  const FaceApproachOptions paper{};
  Before before(1.9, 30.0, 15.0);
  before.progress.near = true;
  const FaceDecision first = before.Decide(paper);
  ASSERT_GE(first.arcs.size(), 2u) << first.why_not;
  before.Drive(first.arcs);
  const FaceDecision second = before.Decide(paper);
  EXPECT_TRUE(second.arcs.empty());
  EXPECT_EQ(second.why_not, "");
  EXPECT_LT(Degrees(before.ToolOffNow()), 0.1);
}

// At most a degree and a quarter at first, then a quarter of a degree more each time.
TEST(FaceDecision, AsksForLessWithEachPairNearBy) {
  Before before(2.0, 30.0, 0.0);
  const auto goal = GoalFor(before.nominal, before.Face(), 0.0);
  ASSERT_TRUE(goal);
  before.progress.near = true;
  // So near that the tool is off by some 2 deg.
  double back_m = 0.0;
  const FaceBelief at_start = before.belief;
  while (before.ToolOffNow() > kPi - 1e-9 || Degrees(before.ToolOffNow()) > 2.2) {
    before.belief = at_start;
    back_m += 0.001;
    MoveOn({goal->X_RG.x - 0.05 + back_m, goal->X_RG.y, goal->X_RG.heading}, 1.0,
           Eigen::Vector2d(0.0, 0.0), before.belief);
    ASSERT_LT(back_m, 0.1);
  }
  const double off_rad = before.ToolOffNow();
  ASSERT_GT(Degrees(off_rad), 1.3);
  int pairs = 1;
  while (!before.Decide(kOurs).arcs.empty() && pairs < 20) ++pairs;
  EXPECT_EQ(pairs, 1 + static_cast<int>(std::ceil((Degrees(off_rad) - 1.2) / 0.25)));
}

// Aside by 24 mm the tool is off by more than the first pair asks for, but no short path takes that
// away.
TEST(FaceDecision, PlacesWhereNoPathIsExpectedToLeaveLess) {
  Before before(2.0, 30.0, 0.0);
  before.progress.near = true;
  const auto goal = GoalFor(before.nominal, before.Face(), 0.0);
  ASSERT_TRUE(goal);
  const Pose2 aside = goal->X_RG * Pose2{0.0, -0.024, 0.0};
  MoveOn(aside, 1.0, Eigen::Vector2d(0.0, 0.0), before.belief);
  ASSERT_GT(Degrees(before.ToolOffNow()), 1.25);
  ASSERT_LT(Degrees(before.ToolOffNow()), 1.6);
  const FaceDecision next = before.Decide(kOurs);
  EXPECT_EQ(next.why_not, "");
  EXPECT_TRUE(next.arcs.empty());
}

// A foot before the face keeps the goal 10 deg off the normal. Nearer by 3 cm of the 5 that wheels
// keep at the goal the tool is less off: those are driven, and then it places. After eight pairs it
// places from where it is.
TEST(FaceDecision, BeforeAGoalOffTheNormalItDrivesNearerWhileThatHelps) {
  Before before(2.0, 45.0, 0.0);
  before.progress.near = true;
  double foot_m = 0.0;
  std::optional<PlaceGoal> goal;
  while (!goal || std::abs(goal->stance.off_rad) < Radians(10.0)) {
    foot_m += 0.005;
    ASSERT_LT(foot_m, 0.5);
    before.belief.obstacles_E = {{2.0 - foot_m, 0.1}};
    goal = GoalFor(before.nominal, before.Face(), before.Least_m());
  }
  MoveOn(goal->X_RG, 1.0, Eigen::Vector2d(0.0, 0.0), before.belief);
  ASSERT_GT(Degrees(before.ToolOffNow()), 9.5);
  Before late = before;
  late.progress.near_pairs = 8;
  EXPECT_TRUE(late.Decide(kOurs).arcs.empty());
  const double before_rad = before.ToolOffNow();
  int pairs = 1;
  FaceDecision next = before.Decide(kOurs);
  EXPECT_FALSE(next.arcs.empty());
  while (!next.arcs.empty() && ++pairs < 20) {
    before.Drive(next.arcs);
    next = before.Decide(kOurs);
  }
  EXPECT_EQ(next.why_not, "");
  EXPECT_LE(pairs, 3);
  EXPECT_LT(Degrees(before.ToolOffNow()), Degrees(before_rad) - 2.0);
}

// A short arc back alone would be followed by a shorter one, again and again.
TEST(FaceDecision, AShortArcBackIsFollowedByTheNextOneOfItsPath) {
  int back = 0;
  for (const double turn_deg : {-40.0, 40.0}) {
    for (double off_m = -0.05; off_m < 0.06; off_m += 0.02) {
      Before before(2.0, 30.0, 0.0);
      before.progress.near = true;
      const auto goal = GoalFor(before.nominal, before.Face(), 0.0);
      ASSERT_TRUE(goal);
      MoveOn({goal->X_RG.x + off_m, goal->X_RG.y, goal->X_RG.heading + Radians(turn_deg)}, 1.0,
             Eigen::Vector2d(0.0, 0.0), before.belief);
      const std::vector<Arc> arcs = before.Decide(kOurs).arcs;
      if (arcs.empty() || arcs.front().length_m >= 0.0) continue;
      if (-arcs.front().length_m < 0.9 * kOurs.least_step_m) ++back;
      EXPECT_TRUE(arcs.size() > 1 || Length(arcs) >= kOurs.least_step_m - 1e-9) << off_m;
    }
  }
  EXPECT_GE(back, 1);
}

TEST(FaceDecision, SaysWhyItCannotGoOn) {
  Before high(3.0, 30.0, 0.0);
  high.belief.p_ET.z() = 3.0;
  EXPECT_THAT(high.Decide(kOurs).why_not, HasSubstr("does not reach the target from anywhere"));
  Before blind(1.3, 30.0, 0.0);
  blind.belief.normal_E.reset();
  blind.progress.near = true;
  EXPECT_THAT(blind.Decide(kOurs).why_not, HasSubstr("normal is not"));
}

TEST(FaceDecision, AnUnsureNormalDoesNotSayWhereToGo) {
  Before sure(5.0, 30.0, 60.0), unsure(5.0, 30.0, 60.0);
  unsure.belief.normal_sigma_rad = Radians(20.0);
  const double to_target = std::atan2(0.1, 5.0);
  // The arc turns twice as far as its chord is aside.
  const Arc arc = unsure.Decide(kOurs).arcs.at(0);
  EXPECT_NEAR(arc.turn_rad, 0.0, 2.0 * to_target);
  EXPECT_GT(std::abs(sure.Decide(kOurs).arcs.at(0).turn_rad), std::abs(arc.turn_rad));
}

}  // namespace
}  // namespace dockyard::rocky7
