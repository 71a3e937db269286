// `dockyard plan` as its users meet it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/program.h"
#include "sim/base/json.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

Json PlanOf(const std::string& arguments) {
  const Ended ended = Dockyard("plan --json " + arguments);
  EXPECT_EQ(ended.code, 0) << arguments << ended.err;
  return Json::parse(ended.out);
}

void ExpectArc(const Json& arc, double length_m, double turn_rad) {
  EXPECT_NEAR(arc["length_m"].get<double>(), length_m, 1e-8);
  EXPECT_NEAR(arc["turn_rad"].get<double>(), turn_rad, 1e-8);
}

// An independent computation's vectors, to 9 digits.
TEST(PlanCommand, GivesOneArcToAPlace) {
  const Json ahead = PlanOf("--point 0.6,0 --goal 1.5,0.3");
  EXPECT_EQ(ahead["feasible"], true);
  ASSERT_EQ(ahead["arcs"].size(), 1u);
  ExpectArc(ahead["arcs"][0], 0.936520560, 0.283794109);
  EXPECT_NEAR(ahead["cost_m"].get<double>(), 0.936520560, 1e-8);
  ExpectArc(PlanOf("--point 0.6,0 --goal 0.5,0.05")["arcs"][0], -0.097660051, 0.090846559);
  ExpectArc(PlanOf("--point 0.6,-0.1 --goal -0.9,0.2")["arcs"][0], -1.256637061, -1.570796327);
}

TEST(PlanCommand, DrivesOneArcTheOtherWayRoundIfOnlyForwards) {
  const Json arc = PlanOf("--point 0.6,-0.1 --goal -0.9,0.2 --forward-only")["arcs"][0];
  ExpectArc(arc, 0.8 * 1.5 * M_PI, 1.5 * M_PI);  // (3) as printed: theta + 2 pi
}

TEST(PlanCommand, GoesStraightBackToThePointsMirrorImageAndNowhereToThePoint) {
  ExpectArc(PlanOf("--point 0.6,0.1 --goal -0.6,0.1")["arcs"][0], -1.2, 0.0);
  const Json none = PlanOf("--point 0.6,0.1 --goal 0.6,0.1");
  EXPECT_EQ(none["feasible"], true);
  EXPECT_EQ(none["cost_m"], 0.0);
}

TEST(PlanCommand, GivesTheCheapestTwoArcsToAHeading) {
  const Json plan = PlanOf("--point 0.6,0 --goal 2,0.5 --heading-deg -51.56620156177409");
  ASSERT_EQ(plan["arcs"].size(), 2u);
  ExpectArc(plan["arcs"][0], 1.150612339, 1.489537888);
  ExpectArc(plan["arcs"][1], 1.150612339, -2.389537888);
  EXPECT_NEAR(plan["cost_m"].get<double>(), 2.301224678, 1e-8);
  const Json limited =
      PlanOf("--goal 1.5,-0.6 --heading-deg 68.75493541569878 --min-radius 0.4 --forward-only");
  EXPECT_NEAR(limited["cost_m"].get<double>(), 1.999400106, 1e-8);
}

TEST(PlanCommand, EndsWithFourWhereTwoArcsCannotAndThreeCan) {
  const std::string near =
      "--point 0,0 --goal 0.3,0.2 --heading-deg 0 --min-radius 0.5 --forward-only";
  const Ended two = Dockyard("plan --json " + near);
  EXPECT_EQ(two.code, 4);
  EXPECT_EQ(Json::parse(two.out)["feasible"], false);
  EXPECT_THAT(Dockyard("plan " + near).out, HasSubstr("no such arcs"));
  const Json three = PlanOf(near + " --arcs 3");
  EXPECT_EQ(three["arcs"].size(), 3u);
  for (const Json& arc : three["arcs"]) EXPECT_GE(arc["length_m"].get<double>(), -1e-9);
}

const std::string kRocky = "--robot " + SourceFile("models/rovers/rocky7.yaml");

TEST(PlanCommand, KeepsTheSteeringLimitAndTheOutlineOfARover) {
  const Json plan = PlanOf(kRocky + " --goal 2.6,0.8 --heading-deg 10 --obstacles " +
                           SourceFile("examples/obstacles.yaml"));
  int blocked = 0;
  for (const Json& candidate : plan["candidates"]) blocked += candidate["missing_m"] > 0.0;
  EXPECT_GT(blocked, 5);
  for (const Json& arc : plan["arcs"]) {
    ASSERT_EQ(arc["wheels"].size(), 6u);
    for (const auto& [name, wheel] : arc["wheels"].items()) {
      EXPECT_LE(std::abs(wheel["steer_rad"].get<double>()), 70.0 * M_PI / 180.0 + 1e-7) << name;
    }
  }
}

// A centimetre to the side with the same heading: the cheapest pair turns on the spot.
TEST(PlanCommand, TurnsARoverInPlaceOnlyWhereThatIsAskedFor) {
  const std::string aside = kRocky + " --goal 0.61,0.01 --heading-deg 0";
  EXPECT_EQ(Dockyard("plan " + aside).code, 4);
  const Json pivots = PlanOf(aside + " --pivot");
  for (const Json& arc : pivots["arcs"]) {
    EXPECT_NEAR(std::abs(arc["turn_rad"].get<double>()), M_PI, 1e-6);
    EXPECT_LT(std::abs(arc["length_m"].get<double>()), 0.02);
  }
  for (const Json& arc : PlanOf(aside + " --arcs 3")["arcs"]) {
    EXPECT_LE(std::abs(arc["turn_rad"].get<double>()), 0.3);
  }
  EXPECT_EQ(Dockyard("plan " + aside + " --pivot --min-radius 1").code, 2);
}

double LeastRadius(const Json& plan) {
  double least_m = HUGE_VAL;
  for (const Json& arc : plan["arcs"]) {
    const double turn_rad = arc["turn_rad"].get<double>();
    if (turn_rad == 0.0) continue;
    least_m = std::min(least_m, std::abs(arc["length_m"].get<double>() / turn_rad));
  }
  return least_m;
}

TEST(PlanCommand, DrivesARoverOnSharpArcsOnlyWhereGentleOnesLeadNowhere) {
  const std::string among =
      " --goal 2.6,0.8 --heading-deg 10 --obstacles " + SourceFile("examples/obstacles.yaml");
  const Json gentle = PlanOf(kRocky + among);
  EXPECT_GE(LeastRadius(gentle), 1.0 - 1e-9);
  EXPECT_LT(LeastRadius(PlanOf(kRocky + among + " --min-radius 0.3")), 1.0);
  const double sharp_m =
      LeastRadius(PlanOf(kRocky + " --goal 1.3,0.2 --heading-deg 40 --forward-only"));
  EXPECT_LT(sharp_m, 1.0);
  // The wheels' own: 0.40875 m ahead, 0.2 m aside, 70 deg.
  EXPECT_NEAR(sharp_m, 0.40875 / std::tan(70.0 * M_PI / 180.0) + 0.2, 1e-6);
}

TEST(PlanCommand, WritesADrawingAndAPage) {
  const ScratchFolder folder;
  const std::string svg = folder.path() / "plan.svg", page = folder.path() / "plan.html";
  const Ended ended =
      Dockyard("plan --goal 2.6,1 --heading-deg 0 " + kRocky + " --svg " + svg + " --page " + page);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(Slurp(svg), HasSubstr("</svg>"));
  EXPECT_THAT(Slurp(page), HasSubstr("</html>"));
  const Ended none = Dockyard("plan --goal 2,1 --svg " + (folder.path() / "no" / "x.svg").string());
  EXPECT_NE(none.code, 0);
  EXPECT_THAT(none.err, HasSubstr("x.svg"));
}

TEST(PlanCommand, KeepsATargetInView) {
  const std::string ahead = kRocky + " --goal 2.6,0.5 --heading-deg 0 --keep-in-view 3.2,0.5";
  const Json plan = PlanOf(ahead);
  EXPECT_EQ(plan["feasible"], true);
  EXPECT_EQ(Dockyard("plan " + kRocky + " --goal 2.6,0.5 --heading-deg 0 --keep-in-view -1,0").code,
            4);
}

// A map of rocks: a lattice all about, and free ground before the rover.
TEST(PlanCommand, TakesAHundredThousandDiscsOfATable) {
  const ScratchFolder folder;
  std::string rows = "x_m,y_m,radius_m\n";
  for (int i = 0; i < 100000; ++i) {
    const double x_m = 0.5 * (i % 400) - 100.0, y_m = 0.8 * (i / 400) - 100.0;
    if (std::hypot(x_m - 1.0, y_m - 0.4) < 3.0) continue;
    rows += std::to_string(x_m) + "," + std::to_string(y_m) + ",0.150000000000000\n";
  }
  const std::string goal = kRocky + " --goal 2.6,0.8 --heading-deg 10";
  const Json strewn = PlanOf(goal + " --obstacles " + folder.Write("rocks.csv", rows));
  EXPECT_EQ(strewn["arcs"], PlanOf(goal)["arcs"]);
  EXPECT_EQ(strewn["warnings"], Json::array());
}

TEST(PlanCommand, SaysThatAnObstacleIsTooNearAtTheStart) {
  const ScratchFolder folder;
  const std::string rocks = folder.Write("rocks.csv", "x_m,y_m,radius_m\n0.2,0,0.1\n");
  const Ended ended = Dockyard("plan --json " + kRocky + " --goal 2.6,0.8 --heading-deg 10" +
                               " --obstacles " + rocks);
  EXPECT_EQ(ended.code, 4);
  ASSERT_EQ(Json::parse(ended.out)["warnings"].size(), 1u);
  EXPECT_THAT(ended.err, HasSubstr("warning: the rover is nearer to an obstacle"));
}

TEST(PlanCommand, ListsItsWarningsWhenItFails) {
  const ScratchFolder folder;
  const std::string rocks = folder.Write("rocks.csv", "x_m,y_m,radius_m\n0.2,0,0.1\n");
  const Ended ended = Dockyard("plan --json " + kRocky + " --goal 2.6,0.8 --heading-deg 10" +
                               " --obstacles " + rocks + " --svg /proc/nothing/plan.svg");
  EXPECT_EQ(ended.code, 50) << ended.err;
  const Json answer = Json::parse(ended.out);
  EXPECT_EQ(answer["error"]["exit_code"], 50);
  ASSERT_EQ(answer["warnings"].size(), 1u);
  EXPECT_THAT(answer["warnings"][0].get<std::string>(),
              testing::StartsWith("the rover is nearer to an obstacle"));
}

TEST(PlanCommand, NamesTheLineOfABadFile) {
  const ScratchFolder folder;
  const std::string bad = folder.Write("stones.yaml", "obstacles:\n  - {x_m: 1}\n");
  const Ended ended = Dockyard("plan " + kRocky + " --goal 1,0.1 --obstacles " + bad);
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("stones.yaml:2:"));
}

TEST(PlanCommand, EndsWithTwoForArgumentsThatMakeNoSense) {
  for (const char* arguments :
       {"", "--goal 1", "--goal 1,nan", "--goal 1,2,3", "--goal 1,2 --arcs 3",
        "--goal 1,2 --heading-deg 0 --arcs 4", "--goal 1,2 --min-radius -1",
        "--goal 1,2 --obstacles examples/obstacles.yaml", "--goal 1,2 --page x.html",
        "--goal 1,2 --keep-in-view 1,1", "--goal 1,2 --pivot"}) {
    const Ended ended = Dockyard(std::string("plan ") + arguments);
    EXPECT_EQ(ended.code, 2) << arguments;
    EXPECT_EQ(ended.out, "") << arguments;
  }
}

}  // namespace
}  // namespace dockyard
