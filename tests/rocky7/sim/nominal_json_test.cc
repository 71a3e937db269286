#include "sim/rocky7/nominal_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/rocky7/dockyard.h"
#include "models/read/config_error.h"
#include "models/rocky7/load_robot.h"
#include "models/rocky7/make_nominal.h"
#include "sim/log/logged_run.h"
#include "support/bad_files.h"

namespace dockyard::rocky7 {
namespace {

Nominal Sample() {
  Nominal nominal = MakeNominal(LoadRobot(SourceFile("models/rocky7/rocky7.yaml")));
  nominal.target_px = {12.5, 99.25};
  nominal.nesnas = {0.05, 0.2, 0.01, FrontEnd::kSandAndStones};
  nominal.compute_s = 7.5;
  return nominal;
}

/// Every number of a tree made another one.
void Shift(Json& json) {
  if (json.is_number_float()) json = json.get<double>() + 0.25;
  if (json.is_structured()) {
    for (Json& part : json) Shift(part);
  }
}

TEST(Rocky7NominalJson, ComesBackBitForBit) {
  const Nominal nominal = Sample();
  const Nominal back = NominalFromJson(Json::parse(ToJson(nominal).dump()));
  EXPECT_EQ(ToJson(back), ToJson(nominal));
  EXPECT_EQ(back.nesnas, nominal.nesnas);
  EXPECT_EQ(back.front.left, nominal.front.left);
  EXPECT_EQ(back.motors, nominal.motors);
  EXPECT_EQ(back.masses, nominal.masses);
  EXPECT_EQ(back.mast.watch_rad, nominal.mast.watch_rad);
  EXPECT_EQ(back.mast.pair_K.left, nominal.mast.pair_K.left);
}

TEST(Rocky7NominalJson, ReadsEveryNumberThatItWrites) {
  Json shifted = ToJson(Sample());
  Shift(shifted);
  EXPECT_EQ(ToJson(NominalFromJson(shifted)), shifted);
}

// Of before the keys were there.
TEST(Rocky7NominalJson, WithoutAProcessorsTimeAndMassesItTakesNone) {
  Json json = ToJson(Sample());
  json.erase("compute_s");
  json.erase("masses");
  EXPECT_EQ(NominalFromJson(json).compute_s, 0.0);
  EXPECT_EQ(NominalFromJson(json).masses.rover_kg, 0.0);
}

TEST(Rocky7NominalJson, RefusesAnothersParameters) {
  EXPECT_THROW(NominalFromJson(Json{{"belts", 2}}), ConfigError);
}

// Written by the last program of version 5: contact switches as bytes, images without the time of
// their exposure, planar poses. It is of 0.1 s with two images.
TEST(Rocky7Log, OfVersion5IsReadAndAnsweredAsThen) {
  const Folder folder(SourceFile("tests/log/version_5"));
  RunLogReader frames(folder);
  EXPECT_EQ(frames.header().version, 5u);
  int images = 0;
  while (const auto entry = frames.Next()) {
    EXPECT_THAT(entry->sensed.values, testing::ElementsAre(0.0, 0.0, 0.0));
    images += static_cast<int>(entry->sensed.images.size());
  }
  EXPECT_TRUE(frames.complete());
  EXPECT_EQ(images, 2);
  const LoggedRun run = ReadLoggedRun(folder);
  EXPECT_EQ(run.truth.at("x_m").size(), run.times_s.size());
  EXPECT_EQ(run.truth.count("z_m"), 0u);
  EXPECT_TRUE(run.header.sensors.empty());

  RunLogReader log(folder);
  const Nominal nominal = NominalFromJson(log.header().nominal);
  const auto controller = MakeDockyardController(nominal);
  const ControllerReplay replay = ReplayController(
      log, *controller,
      {.motors = static_cast<int>(nominal.motors.size()), .cameras = kCameraCount, .sensors = 3});
  EXPECT_TRUE(replay.same());
  EXPECT_EQ(replay.compared, 2u);
}

}  // namespace
}  // namespace dockyard::rocky7
