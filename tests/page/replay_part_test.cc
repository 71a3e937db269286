#include "sim/page/replay_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/images/png.h"
#include "sim/page/replay_ground.h"

namespace dockyard {
namespace {

/// Two samples of a robot in a site that lies elsewhere and is turned.
LoggedRun SomeRun() {
  LoggedRun run;
  run.times_s = {0.0, 0.1};
  const Pose3 X_WG{RotZ(1.0), {10.0, 5.0, 0.0}};
  run.X_WG = {X_WG, X_WG};
  run.X_WD = {X_WG, X_WG};
  run.body_names = {"robot"};
  run.X_WO = {{X_WG * Pose3::Translation(1.0, 0.5, 0.2), X_WG * Pose3::Translation(1.1, 0.5, 0.2)}};
  run.truth = {{"x_m", {1.0, 1.1}},
               {"y_m", {0.5, 0.5}},
               {"heading_rad", {0.0, 0.0}},
               {"force_n", {0.0, 3.0}}};
  run.notes = {{0.0, {"phase", "look"}}, {0.05, {"phase", "drive"}}, {0.1, {"outcome", "docked"}}};
  return run;
}

TEST(ReplayPart, OfALogWithoutASampleIsNone) {
  Payload payload;
  EXPECT_TRUE(ReplayPart(LoggedRun{}, {}, payload).is_null());
}

TEST(ReplayPart, HasThePhasesAndTheSystemsScalars) {
  Payload payload;
  const Json json = ReplayPart(
      SomeRun(), {.run = 7, .channels = {{"force_n", "N", "how hard"}}, .beliefs = {}}, payload);
  EXPECT_EQ(json["run"], 7);
  EXPECT_EQ(json["samples"], 2);
  EXPECT_NEAR(json["period_s"].get<double>(), 0.1, 1e-12);
  EXPECT_EQ(json["phases"], Json::parse(R"([[0, "look"], [1, "drive"]])"));
  ASSERT_EQ(json["scalars"].size(), 1u);
  EXPECT_EQ(json["scalars"][0]["group"], "Forces");
  EXPECT_TRUE(json["ground"].is_null());
}

// The page draws the ground along its axes, so its world is the site.
TEST(ReplayPart, StandsInTheSite) {
  Payload moved_payload, here_payload;
  LoggedRun here = SomeRun();
  here.X_WG = here.X_WD = {Pose3{}, Pose3{}};
  here.X_WO = {{Pose3::Translation(1.0, 0.5, 0.2), Pose3::Translation(1.1, 0.5, 0.2)}};
  const Json moved_json = ReplayPart(SomeRun(), {}, moved_payload);
  const Json here_json = ReplayPart(here, {}, here_payload);
  EXPECT_EQ(moved_json["bodies"], here_json["bodies"]);
  EXPECT_EQ(moved_payload.Text({}), here_payload.Text({}));
}

TEST(ReplayGround, IsCutToWhereTheRobotWasAndKeepsWhatChanges) {
  LoggedRun run = SomeRun();
  LoggedGround whole{.x0_m = -10.0,
                     .y0_m = -10.0,
                     .cell_m = 0.02,
                     .step_m = 1e-4,
                     .nx = 1001,
                     .ny = 1001,
                     .cells = {},
                     .heights = std::vector<std::int16_t>(1001 * 1001, 7)};
  const std::uint32_t inside = 525 * 1001 + 550, far_away = 3;
  run.ground = {{0.0, whole}, {0.1, {.cells = {far_away, inside}, .heights = {100, -200}}}};
  Payload payload;
  const std::vector<std::vector<Pose3>> X_GO{
      {Pose3::Translation(1.0, 0.5, 0.2), Pose3::Translation(1.1, 0.5, 0.2)}};
  const Json json = ReplayGround(run, X_GO, payload);
  EXPECT_NEAR(json["x0_m"].get<double>(), 0.0, 0.03);  // 1 m before the robot
  EXPECT_NEAR(json["y0_m"].get<double>(), -0.5, 0.03);
  EXPECT_NEAR(json["cell_m"].get<double>(), 0.02, 1e-12);
  EXPECT_NEAR(json["columns"].get<int>(), 106, 2);
  EXPECT_LE(json["columns"].get<int>() * json["rows"].get<int>(), 50000);
  ASSERT_EQ(json["changes"].size(), 1u);
  EXPECT_EQ(json["changes"][0]["cells"]["length"], 4);  // the one inside
  EXPECT_EQ(json["changes"][0]["sample"], 1);
}

}  // namespace
}  // namespace dockyard
