#include "sim/spectator/belief_words.h"

#include <gtest/gtest.h>

#include <cmath>

#include "spectator/some_run.h"

namespace dockyard {
namespace {

const double kNone = std::nan("");

LoggedRun Believing(double located) {
  LoggedRun run = SomeRun();
  run.belief = {{"located", {0.0, located}},
                {"x_m", {0.0, 1.234}},
                {"y_m", {0.0, -0.5}},
                {"heading_rad", {0.0, kPi / 2.0}}};
  return run;
}

TEST(BelievedWords, AreTheRobotsPoseWhereThereIsOne) {
  EXPECT_EQ(BelievedWords(SomeRun(), 1), "");
  const LoggedRun run = Believing(1.0);
  EXPECT_EQ(BelievedWords(run, 0), "not located");
  EXPECT_EQ(BelievedWords(run, 1), "x 1.23 m, y -0.50 m, heading 90.0 deg");
}

// 0.3 m ahead and 0.4 m to the right: 0.5 m off, atan(4 / 3) = 53.13 deg.
TEST(BelievedWords, AreTheTargetsDistanceAndBearingByTheBeliefsValues) {
  LoggedRun run = Believing(0.0);
  run.belief["target_x_m"] = {0.0, 0.3};
  run.belief["target_y_m"] = {0.0, -0.4};
  EXPECT_EQ(BelievedWords(run, 0), "not located");
  EXPECT_EQ(BelievedWords(run, 1), "target at 0.50 m, 53.1 deg right");
  run.belief["target_x_m"] = {0.3, 0.3};
  run.belief["target_y_m"] = {-0.4, -0.4};
  EXPECT_EQ(BelievedWords(run, 1), "target at 0.50 m, 53.1 deg right, at 0.0 s");
  LoggedRun other = Believing(0.0);
  other.values["target_x_m"] = {kNone, -0.4};
  other.values["target_y_m"] = {kNone, 0.3};
  EXPECT_EQ(BelievedWords(other, 0), "not located");
  EXPECT_EQ(BelievedWords(other, 1), "target at 0.50 m, 143.1 deg left");
}

TEST(BelievedWords, AreThoseOfTheLastAcceptedSightingWithoutSuchValues) {
  LoggedRun run = Believing(0.0);
  SightingSample sighting{};
  sighting.time_s = 0.05;
  sighting.report.accepted = true;
  sighting.report.X_RB.p = {2.0, 0.0, 0.7};
  run.sightings = {sighting};
  sighting.time_s = 0.08;
  sighting.report.accepted = false;
  sighting.report.X_RB.p = {9.0, 0.0, 0.7};
  run.sightings.push_back(sighting);
  EXPECT_EQ(BelievedWords(run, 0), "not located");
  EXPECT_EQ(BelievedWords(run, 1), "target at 2.00 m, 0.0 deg left, at 0.1 s");
}

}  // namespace
}  // namespace dockyard
