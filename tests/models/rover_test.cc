#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "controller/geometry/pose.h"
#include "models/read/load_obstacles.h"
#include "models/read/load_rover.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

// What a loader says of Rocky 7's file with a change.
template <class Load>
std::string MessageWith(const Load& load, const std::string& from, const std::string& to) {
  const ScratchFolder folder;
  const std::string good = Slurp(SourceFile("models/rovers/rocky7.yaml"));
  const std::string file = folder.Write("rover.yaml", Replaced(good, from, to));
  return MessageOf([&] { load(file); }, folder);
}

TEST(LoadRoverPlan, ReadsTheSixRoversOfTheFigure) {
  int rovers = 0, skid = 0, free = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SourceFile("models/rovers"))) {
    const RoverPlan rover = LoadRoverPlan(entry.path().string());
    EXPECT_EQ(rover.name, entry.path().stem());
    EXPECT_TRUE(rover.view);
    ++rovers;
    bool all_fixed = true;
    for (const WheelPlan& wheel : rover.wheels) all_fixed &= wheel.steer_limit_rad == 0.0;
    skid += all_fixed;
    free += !TurningLine_m(rover.wheels);
  }
  EXPECT_EQ(rovers, 6);
  EXPECT_EQ(skid, 1);  // (a)
  EXPECT_EQ(free, 2);  // (c) and (f)
}

// The published sizes: 0.288 m to the rocker's pivot and 0.12075 m on to the front axle.
TEST(LoadRoverPlan, HasTheWheelbaseOfRocky7) {
  const RoverPlan rover = LoadRoverPlan(SourceFile("models/rovers/rocky7.yaml"));
  ASSERT_EQ(rover.wheels.size(), 6u);
  EXPECT_NEAR(rover.wheels[0].p_RW.x(), 0.288 + 0.12075, 1e-12);
  EXPECT_NEAR(rover.wheels[0].steer_limit_rad, Radians(70.0), 1e-12);
  EXPECT_EQ(rover.wheels[5].steer_limit_rad, 0.0);
}

// Rocky 7: about 15 kg, as published; 0.81 kg of arm and scoops come on top of what is known of the
// rest.
TEST(LoadRover, HasTheMassOfRocky7AndBogiesUnderItsFixedWheels) {
  const RoverModel rover = LoadRover(SourceFile("models/rovers/rocky7.yaml"));
  EXPECT_NEAR(rover.mass_kg(), 16.01, 0.005);
  EXPECT_EQ(rover.suspension.kind, SuspensionKind::kRockerBogie);
  EXPECT_EQ(rover.on_bogie, (std::vector<bool>{false, false, true, true, true, true}));
}

TEST(LoadRover, ReadsAllRoversAndRefusesAWheelThatIsNotThere) {
  for (const auto& entry : std::filesystem::directory_iterator(SourceFile("models/rovers"))) {
    const RoverModel rover = LoadRover(entry.path().string());
    EXPECT_EQ(rover.suspension.kind == SuspensionKind::kRockerBogie, rover.plan.wheels.size() == 6)
        << entry.path();
  }
  EXPECT_THAT(MessageWith(LoadRover, "on_bogies: [middle_left", "on_bogies: [mid_left"),
              HasSubstr("expected the name of a wheel, found 'mid_left'"));
}

TEST(LoadRover, RefusesASuspensionThatCarriesNoWheelsOrIsRigidWithBogies) {
  EXPECT_THAT(
      MessageWith(LoadRover, "on_bogies: [middle_left, middle_right, back_left, back_right]",
                  "on_bogies: [middle_left, back_left]"),
      HasSubstr("on_bogies with some of each side's wheels"));
  EXPECT_THAT(
      MessageWith(LoadRover, "    on_bogies: [middle_left, middle_right, back_left, back_right]\n",
                  ""),
      HasSubstr("on_bogies, the wheels that the bogies carry"));
  EXPECT_THAT(MessageWith(LoadRover, "kind: rocker_bogie", "kind: rigid"),
              HasSubstr("no other key beside rigid"));
  EXPECT_THAT(MessageWith(LoadRover, "mass_kg: 11", "mass_kg: -1"),
              HasSubstr("build.body.mass_kg"));
}

// The arm reaches the ground at the point that the planner brings to its goal.
TEST(LoadRover, ReadsTheArmThatReachesItsPointAndNoneWhereThereIsNone) {
  const RoverModel rover = LoadRover(SourceFile("models/rovers/rocky7.yaml"));
  ASSERT_TRUE(rover.arm);
  const double down_m = rover.arm->p_RA.z() + rover.tyre.rim_radius_m;
  EXPECT_NEAR(rover.arm->p_RA.x() + std::sqrt(0.32 * 0.32 - down_m * down_m), rover.plan.p_RP.x(),
              1e-3);
  EXPECT_FALSE(LoadRover(SourceFile("models/rovers/steered_six.yaml")).arm);
}

TEST(LoadRover, RefusesAnArmThatCannotBe) {
  EXPECT_THAT(MessageWith(LoadRover, "opening_m: 0.08 ", "opening_m: 0.1 "),
              HasSubstr("build.arm.scoops.opening_m: expected less than twice depth_m"));
  EXPECT_THAT(MessageWith(LoadRover, "wall_m: 0.002", "wall_m: 0.02"),
              HasSubstr("at most a fifth of width_m, depth_m and belly_m"));
  EXPECT_THAT(MessageWith(LoadRover, "stowed_pitch_deg: -80", "stowed_pitch_deg: -100"),
              HasSubstr("build.arm.stowed_pitch_deg: expected a number from -90 to 80"));
  EXPECT_THAT(MessageWith(LoadRover, "    length_m: 0.32 ", "    longness_m: 0.32 "),
              HasSubstr("longness_m"));
}

TEST(LoadRoverPlan, RefusesWhatCannotBeARoverWithLineAndReason) {
  EXPECT_THAT(MessageWith(LoadRoverPlan, "x_m: -0.069, y_m: 0.2", "x_m: -0.5, y_m: 0.2"),
              HasSubstr("expected fixed wheels whose places have a mean x_m of 0"));
  EXPECT_THAT(MessageWith(LoadRoverPlan, "name: front_right", "name: front_left"),
              HasSubstr("rover.yaml:9:12: wheels[1].name: expected a name of its own"));
  EXPECT_THAT(MessageWith(LoadRoverPlan, "far_m: 3", "far_m: 0.01"),
              HasSubstr("a number above near_m"));
  EXPECT_THAT(MessageWith(LoadRoverPlan, "speed_m_s: 0.05", "speed_m_s: 0"),
              HasSubstr("speed_m_s"));
}

std::string ObstaclesMessage(const std::string& text) {
  const ScratchFolder folder;
  const std::string file = folder.Write("stones.yaml", text);
  return MessageOf([&] { LoadObstacles(file); }, folder);
}

TEST(LoadObstacles, ReadsDiscsAndAreas) {
  const Obstacles obstacles = LoadObstacles(SourceFile("examples/obstacles.yaml"));
  ASSERT_EQ(obstacles.discs.size(), 3u);
  EXPECT_EQ(obstacles.discs[1].radius_m, 0.2);
  ASSERT_EQ(obstacles.polygons.size(), 1u);
  EXPECT_EQ(obstacles.polygons[0].size(), 4u);
}

TEST(LoadObstacles, ReadsATableOfDiscs) {
  const ScratchFolder folder;
  std::string rows = "radius_m,x_m,y_m\r\n";
  for (int i = 0; i < 20000; ++i) rows += "0.1," + std::to_string(i / 100) + ",-2.5\r\n";
  const std::string file = folder.Write("stones.CSV", rows);
  const Obstacles obstacles = LoadObstacles(file);
  ASSERT_EQ(obstacles.discs.size(), 20000u);
  EXPECT_EQ(obstacles.discs[19999].centre, Eigen::Vector2d(199.0, -2.5));
  EXPECT_EQ(obstacles.discs[19999].radius_m, 0.1);
  EXPECT_TRUE(IsDiscTable(file));
  EXPECT_FALSE(IsDiscTable(folder.Write("runs.csv", "run,x_m\n1,2\n")));
  const std::string capitals = folder.Write("capitals.csv", "X_m,Y_M,radius_m\n1,2,0.5\n");
  EXPECT_TRUE(IsDiscTable(capitals));
  EXPECT_EQ(MessageOf([&] { LoadObstacles(capitals); }, folder),
            "capitals.csv:1:1: row 1.X_m: unknown key, did you mean 'x_m'?");
  const std::string bad = folder.Write("bad.csv", "x_m,y_m,radius_m\n1,2,0.5\n1,2,-0.5\n");
  EXPECT_THAT(MessageOf([&] { LoadObstacles(bad); }, folder),
              HasSubstr("bad.csv:3:5: row 2.radius_m: expected a number > 0"));
}

TEST(LoadObstacles, ReadsTenThousandDiscsOfAListAndNoMoreThanItsMost) {
  std::string list = "obstacles:\n";
  for (int i = 0; i < 10000; ++i) {
    list += "  - {x_m: " + std::to_string(i % 100) + ", y_m: 1, radius_m: 0.1}\n";
  }
  const ScratchFolder folder;
  EXPECT_EQ(LoadObstacles(folder.Write("stones.yaml", list)).discs.size(), 10000u);
  std::string areas = "obstacles:\n";
  for (int i = 0; i < 1001; ++i) {
    areas += "  - corners: [{x_m: 0, y_m: 0}, {x_m: 1, y_m: 0}, {x_m: 0, y_m: 1}]\n";
  }
  EXPECT_THAT(ObstaclesMessage(areas),
              HasSubstr("stones.yaml:1002:5: obstacles: expected at most"));
}

TEST(LoadObstacles, RefusesWhatHasNoArea) {
  EXPECT_THAT(ObstaclesMessage("obstacles:\n  - {x_m: 1, y_m: 0, radius_m: 0}\n"),
              HasSubstr("stones.yaml:2:"));
  EXPECT_THAT(ObstaclesMessage("obstacles:\n  - {x_m: 1, y_m: 0}\n"), HasSubstr("radius_m"));
  const std::string line = "{x_m: 0, y_m: 0}, {x_m: 1, y_m: 1}, {x_m: 2, y_m: 2}";
  EXPECT_THAT(ObstaclesMessage("obstacles:\n  - corners: [" + line + "]\n"),
              HasSubstr("expected corners round an area"));
  EXPECT_THAT(ObstaclesMessage("stones: []\n"), HasSubstr("stones"));
}

}  // namespace
}  // namespace dockyard
