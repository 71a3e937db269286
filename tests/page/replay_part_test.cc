#include "sim/page/replay_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "sim/images/png.h"
#include "sim/page/pictures.h"
#include "sim/page/replay_ground.h"
#include "sim/page/simplified.h"

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

TEST(ReplayPart, HasTheControllersValuesInPanelsOfTheirUnits) {
  LoggedRun run = SomeRun();
  for (const char* name : {"a_m", "b_m", "c_m", "d_m", "e_m", "f_m", "g_m"}) {
    run.values[name] = {1.0, 2.0};
  }
  run.values["<b>turn_rad"] = {std::nan(""), 0.5};
  run.values["speed_m_s"] = {1e-320, 1e308};
  run.values["never"] = {std::nan(""), std::nan("")};
  Payload payload;
  const Json scalars = ReplayPart(run, {}, payload)["scalars"];
  std::map<std::string, std::string> shown;
  for (const Json& each : scalars) {
    EXPECT_EQ(each["source"], "belief");
    EXPECT_GT(each["channel"]["quantum"].get<double>(), 0.0);
    shown[each["name"]] = each["group"].get<std::string>() + " " + each["unit"].get<std::string>();
  }
  EXPECT_EQ(shown.size(), 9u);
  EXPECT_EQ(shown["f_m"], "Values m");
  EXPECT_EQ(shown["g_m"], "Values 2 m");
  EXPECT_EQ(shown["<b>turn_rad"], "Values rad");
  EXPECT_EQ(shown["speed_m_s"], "Values m/s");
}

TEST(ReplayPart, HasTheCamerasThatTookAnImageOrHaveAMark) {
  LoggedRun run = SomeRun();
  run.cameras = {{"left", 4, 2}, {"right", 4, 2}, {"mast", 4, 2}};
  SightingSample sighting{};
  sighting.report.marks = {{.id = 3, .camera = 2, .u_px = 1.5, .v_px = 0.25}};
  run.sightings = {sighting};
  const auto names = [&run] {
    Payload payload;
    std::vector<std::string> found;
    const Json json = ReplayPart(run, {}, payload);
    for (const Json& camera : json["sightings"][0]["cameras"]) {
      found.push_back(camera["name"]);
    }
    return found;
  };
  EXPECT_THAT(names(), testing::ElementsAre("left", "right", "mast"));  // no image is kept
  run.images = {{0.0, {"left", EncodePng(GrayImage{4, 2, std::vector<std::uint8_t>(8, 9)})}}};
  EXPECT_THAT(names(), testing::ElementsAre("left", "mast"));
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
  EXPECT_EQ(json["changes"][0]["cells"]["length"], 1 + 2);  // the one inside: its place, 2 bytes
  EXPECT_EQ(json["changes"][0]["sample"], 1);
}

/// Distance of a point from the nearest point of a line of pieces.
double DistanceFrom(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& p) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    for (int k = 0; k <= 1000; ++k) {
      const double share = 0.001 * k;
      nearest = std::min(nearest, (p - (1.0 - share) * line[i] - share * line[i + 1]).norm());
    }
  }
  return nearest;
}

TEST(Simplified, LeavesNoPointFartherOffThanTheTolerance) {
  std::vector<Eigen::Vector3d> hanging;
  for (int i = 0; i <= 64; ++i) {
    const double x = i / 64.0 - 0.5;
    hanging.emplace_back(x, 0.3 * x, 0.4 * x * x);
  }
  const auto few = Simplified(hanging, 1e-3);
  EXPECT_LT(few.size(), 20u);
  EXPECT_EQ(few.front(), hanging.front());
  EXPECT_EQ(few.back(), hanging.back());
  for (const Eigen::Vector3d& p : hanging) EXPECT_LT(DistanceFrom(few, p), 1.01e-3);
}

TEST(Simplified, KeepsTheEndsOfAStraightLineAlone) {
  std::vector<Eigen::Vector3d> taut;
  for (int i = 0; i < 40; ++i) taut.emplace_back(0.1 * i, -0.02 * i, 0.5);
  EXPECT_EQ(Simplified(taut, 1e-3).size(), 2u);
  EXPECT_EQ(Simplified({}, 1e-3).size(), 0u);
  EXPECT_EQ(Simplified({{1, 2, 3}}, 1e-3).size(), 1u);
}

TEST(SmallPictures, AreTheSameOfGreyAndOfEqualColoursAndKeepTheirPlaces) {
  GrayImage gray{1024, 768, std::vector<std::uint8_t>(1024 * 768)};
  for (std::size_t i = 0; i < gray.pixels.size(); ++i) {
    gray.pixels[i] = static_cast<std::uint8_t>((i * 7 + i / 1024) % 251);
  }
  const LoggedImage as_gray{"left", EncodePng(gray)}, as_colour{"left", EncodePng(AsColour(gray))};
  const LoggedImage nonsense{"left", "nonsense"};
  const auto pictures = SmallPictures({nullptr, &as_gray, &nonsense, &as_colour, nullptr});
  ASSERT_EQ(pictures.size(), 5u);
  EXPECT_GT(pictures[1].size(), 100u);
  EXPECT_EQ(pictures[1], pictures[3]);
  for (const std::size_t none : {0, 2, 4}) EXPECT_EQ(pictures[none], "");
}

}  // namespace
}  // namespace dockyard
