#include "controller/rocky7/place_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/motion/steering.h"
#include "controller/rocky7/paths_to_point.h"
#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

FaceAt FaceAhead(double x_m, double y_m, double up_deg, double aside_deg) {
  return {{x_m, y_m, 0.33},
          RotZ(Radians(aside_deg)) *
              Eigen::Vector3d(-std::cos(Radians(up_deg)), 0.0, std::sin(Radians(up_deg)))};
}

// A boulder as wide as the rover behind the face's foot.
std::vector<Eigen::Vector2d> Boulder(const FaceAt& face, double foot_m) {
  std::vector<Eigen::Vector2d> places;
  const Eigen::Vector2d ahead = -face.normal_R.head<2>().normalized();
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  for (double u = -foot_m; u < 0.3; u += 0.04) {
    for (double v = -0.3; v < 0.3; v += 0.04) {
      places.push_back(face.p_RT.head<2>() + u * ahead + v * left);
    }
  }
  return places;
}

TEST(PlacePlan, ArcsEndAtTheGoalsPoseWithinTheSteeringsLimits) {
  const Nominal nominal = NominalRover();
  const ArcLimits limits = GentleLimits(nominal.plan);
  for (const double aside_deg : {-35.0, 0.0, 20.0}) {
    const FaceAt face = FaceAhead(2.0, 0.2, 30.0, aside_deg);
    const auto places = Boulder(face, 0.1);
    const auto goal = GoalFor(nominal, face, LeastStandOff(nominal, face, places));
    ASSERT_TRUE(goal);
    const auto path = ArcsToGoal(nominal, *goal, DiscsOf(places));
    ASSERT_FALSE(path.empty());
    for (const Arc& arc : path) EXPECT_TRUE(Keeps(arc, limits));
    const Pose2 end = Advance({}, path);
    EXPECT_LT((goal->X_RG.x - end.x) * (goal->X_RG.x - end.x) +
                  (goal->X_RG.y - end.y) * (goal->X_RG.y - end.y),
              1e-12);
    EXPECT_NEAR(end.heading, Radians(aside_deg), 1e-6);
  }
}

TEST(PlacePlan, WheelsKeepOffTheFootOfTheFace) {
  const Nominal nominal = NominalRover();
  const FaceAt face = FaceAhead(2.0, 0.0, 50.0, 0.0);
  for (const double foot_m : {0.0, 0.1, 0.2}) {
    const auto places = Boulder(face, foot_m);
    const auto goal = GoalFor(nominal, face, LeastStandOff(nominal, face, places));
    ASSERT_TRUE(goal);
    double nearest_m = 10.0;
    for (const auto& place : places) nearest_m = std::min(nearest_m, place.x());
    EXPECT_LE(goal->X_RG.x + 0.479 + 0.05, nearest_m + 1e-9) << foot_m;
  }
}

TEST(PlacePlan, OneShortArcMakesUpForAStandOffThatIsOff) {
  const Nominal nominal = NominalRover();
  const FaceAt face = FaceAhead(0.85, 0.0, 30.0, 0.0);
  const auto goal = GoalFor(nominal, face, 0.0);
  ASSERT_TRUE(goal);
  for (const double off_m : {-0.06, -0.03, 0.03}) {
    const FaceAt seen = SeenFrom({goal->X_RG.x + off_m, 0.0, 0.0}, face);
    ASSERT_GT(Degrees(ToolOff(nominal.mast, seen)), 2.0);
    const auto now = GoalFor(nominal, seen, 0.0);
    const auto path = ArcsToCorrect(nominal, seen, *now, {});
    ASSERT_EQ(path.size(), 1u);
    EXPECT_LT(Degrees(ToolOff(nominal.mast, SeenFrom(Advance({}, path), seen))), 0.5);
  }
}

TEST(PlacePlan, TwoArcsBringTheMastAsideByCentimetres) {
  const Nominal nominal = NominalRover();
  const FaceAt face = FaceAhead(0.88, 0.08, 30.0, 0.0);
  const double before = ToolOff(nominal.mast, face);
  const auto path = ArcsToCorrect(nominal, face, *GoalFor(nominal, face, 0.0), {});
  ASSERT_FALSE(path.empty());
  EXPECT_LT(ToolOff(nominal.mast, SeenFrom(Advance({}, path), face)), 0.5 * before);
}

// Longer arcs would make the tool right by plan, and end centimetres off in soil.
TEST(PlacePlan, ADegreeIsNotWorthALongPath) {
  const Nominal nominal = NominalRover();
  const FaceAt face = FaceAhead(0.88, 0.024, 30.0, 0.0);
  const PlaceGoal goal = *GoalFor(nominal, face, 0.0);
  ASSERT_NEAR(Degrees(ToolOff(nominal.mast, face)), 1.4, 0.1);
  EXPECT_GT(Length(ArcsToGoal(nominal, goal, {})), 0.1);
  EXPECT_LT(Length(ArcsToCorrect(nominal, face, goal, {})), 0.05);
}

TEST(PlacePlan, StandingWhereTheToolIsRightAsksForNoArcs) {
  const Nominal nominal = NominalRover();
  const FaceAt face = FaceAhead(1.5, 0.0, 30.0, 0.0);
  const auto goal = GoalFor(nominal, face, 0.0);
  const FaceAt seen = SeenFrom(goal->X_RG, face);
  EXPECT_TRUE(ArcsToCorrect(nominal, seen, *GoalFor(nominal, seen, 0.0), {}).empty());
}

}  // namespace
}  // namespace dockyard::rocky7
