// The sensor of the tether's tension and direction: what it reads, and how a run has it.
#include "sim/axel/tether_sensor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axel/sim/product.h"
#include "axel/sim/scenarios.h"
#include "models/parts/gravity.h"
#include "sim/axel/axel_plant.h"
#include "sim/axel/nominal_json.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

/// The rover braked before the station, its spool pulling.
Truth Pulled(TetherLaw law, const Pose2& X_DR, double tension_n) {
  WorldSetup setup = TestSetup(CompactGravel(), X_DR);
  setup.rover.tether.law = law;
  setup.slack_start_m = 0.05;
  World world(setup);
  MotorCommands commands = AllBraked();
  At(commands, Motor::kSpool) = Velocity(0.8, SpoolCurrent(tension_n));
  Play(world, commands, 6.0);
  return world.truth();
}

/// Of the tether from the tip, by geometry: straight to the cone's edge, or the anchor, that takes
/// the line nearest to the axis; and at the tip below that by w L / 2 T, as a taut cable sags.
struct Direction {
  double azimuth_rad = 0.0, elevation_rad = 0.0;
};
Direction Expected(const Truth& truth, double tension_n) {
  const StationModel station = Station();
  const Eigen::Vector3d& tip_M = truth.p_MT;
  const double aside_m = std::hypot(tip_M.y(), tip_M.z());
  Eigen::Vector2d bend(0.0, 0.0);
  double descent = -1e9;
  for (const Eigen::Vector2d& edge :
       {Eigen::Vector2d(0.0, station.cone.mouth_radius_m),
        Eigen::Vector2d(-station.cone.funnel_length_m, station.cone.throat_radius_m),
        Eigen::Vector2d(-station.anchor_depth_m, 0.0)}) {
    const double needed = (aside_m - edge.y()) / (tip_M.x() - edge.x());
    if (needed <= descent) continue;
    descent = needed;
    bend = edge;
  }
  const Eigen::Vector3d bend_M(bend.x(), bend.y() * tip_M.y() / aside_m,
                               bend.y() * tip_M.z() / aside_m);
  const Pose3 X_WM = truth.X_WS * MouthInStation(station);
  Eigen::Vector3d d_W = X_WM.R * (bend_M - tip_M);
  const double level_m = d_W.head<2>().norm();
  const double weight_n = Axel().tether.mass_kg_per_m * kEarthGravity_m_s2 * d_W.norm();
  d_W.z() -= level_m * 0.5 * weight_n / tension_n;
  const Eigen::Vector3d d_R = truth.X_WR.R.transpose() * d_W;
  return {std::atan2(d_R.y(), d_R.x()), std::atan2(d_R.z(), std::hypot(d_R.x(), d_R.y()))};
}

// From the side, so that the tether bends over the throat or the lip, under both laws.
TEST(TetherSensor, ReadsTheTetherFromTheTipToTheConesEdgeWithItsSag) {
  for (const TetherLaw law : {TetherLaw::kMassless, TetherLaw::kCable}) {
    for (const Pose2& X_DR :
         {Pose2{3.0, 1.2, kPi - 0.5}, Pose2{3.0, 1.2, kPi + 0.3}, Pose2{2.5, 2.0, kPi + 0.3}}) {
      const Truth truth = Pulled(law, X_DR, 40.0);
      const std::vector<double> read = TetherTruth(truth);
      const Direction expected = Expected(truth, truth.tether_tension_n);
      EXPECT_NEAR(read[kTetherAzimuth], expected.azimuth_rad, 3e-3);
      EXPECT_NEAR(read[kTetherElevation], expected.elevation_rad, 3e-3);
      EXPECT_GT(std::abs(read[kTetherAzimuth]), 0.05);
    }
  }
}

// The spool pulls with what its current gives, less its gears' friction, at the drum's radius.
TEST(TetherSensor, ReadsTheTensionThatTheSpoolGives) {
  for (const TetherLaw law : {TetherLaw::kMassless, TetherLaw::kCable}) {
    for (const double tension_n : {40.0, 120.0}) {
      const Truth truth = Pulled(law, {3.0, 0.5, kPi}, tension_n);
      const RoverModel rover = Axel();
      const MotorModel& spool = rover.motors[static_cast<std::size_t>(Motor::kSpool)];
      const double e = spool.gear_efficiency;
      const double friction_n = spool.gear_friction_nm / rover.tether.drum_radius_m;
      const double read_n = TetherTruth(truth)[kTetherTension];
      // Standing gears hold anything between what drives them forward and back.
      EXPECT_GE(read_n, tension_n - friction_n - 0.5);
      EXPECT_LE(read_n, tension_n * (2.0 - e) / e + friction_n + 0.5);
      EXPECT_EQ(read_n, truth.tether_tension_n);
    }
  }
}

TEST(TetherSensor, FollowsTheArmAndTheBodyThatCarryIt) {
  Truth truth;
  truth.tether_tension_n = 50.0;
  const Eigen::Vector3d tip(2.0, 1.0, 0.3), out(0.6, 0.3, 0.2);  // azimuth atan2(0.3, 0.6)
  truth.tether_W = {tip, tip + 0.05 * out, tip + out};
  EXPECT_NEAR(TetherTruth(truth)[kTetherAzimuth], std::atan2(0.3, 0.6), 1e-12);
  EXPECT_NEAR(TetherTruth(truth)[kTetherElevation], std::atan2(0.2, std::hypot(0.3, 0.6)), 1e-12);
  truth.X_WR.R = RotZ(0.4);
  EXPECT_NEAR(TetherTruth(truth)[kTetherAzimuth], std::atan2(0.3, 0.6) - 0.4, 1e-12);
}

// A kink nearer than the feeler's end turns the feeler by its share alone.
TEST(TetherSensor, ReadsTheChordOfItsFeeler) {
  Truth truth;
  truth.tether_W = {{0, 0, 0}, {0.06, 0, 0}, {0.06, 1.0, 0}};
  EXPECT_NEAR(TetherTruth(truth)[kTetherAzimuth], std::atan2(0.04, 0.06), 1e-12);
  truth.tether_W = {{0, 0, 0}, {0, 0.02, 0}};  // shorter than it
  EXPECT_NEAR(TetherTruth(truth)[kTetherAzimuth], kPi / 2.0, 1e-12);
}

constexpr int kSeeds = 4000;
/// Standard deviation over the runs' seeds.
template <class Draw>
double SigmaOverSeeds(const Draw& draw) {
  double sum = 0.0, square = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const double x = draw(seed);
    sum += x / kSeeds;
    square += x * x / kSeeds;
  }
  return std::sqrt(square - sum * sum);
}

// A standard deviation of n draws errs by 1 / sqrt(2 n): 1.1 %; bounds are four of these.
TEST(TetherSensor, OffsetsAndScaleSpreadOverTheRunsByTheirSigma) {
  const TetherSensorModel model{
      .tension_offset_n = 2.0, .tension_scale_share = 0.03, .direction_offset_rad = 0.01};
  Truth slack, taut;
  slack.tether_W = taut.tether_W = {{0, 0, 0}, {1, 0, 0}};
  taut.tether_tension_n = 100.0;
  const auto read = [&](std::uint64_t seed, const Truth& truth, std::size_t value) {
    return TetherSensing(model, seed).Read(truth)[value];
  };
  EXPECT_NEAR(SigmaOverSeeds([&](auto seed) { return read(seed, slack, kTetherTension); }), 2.0,
              0.045 * 2.0);
  const double scale = SigmaOverSeeds([&](auto seed) {
    return (read(seed, taut, kTetherTension) - read(seed, slack, kTetherTension)) / 100.0;
  });
  EXPECT_NEAR(scale, 0.03, 0.045 * 0.03);
  for (const std::size_t angle : {kTetherAzimuth, kTetherElevation}) {
    EXPECT_NEAR(SigmaOverSeeds([&](auto seed) { return read(seed, slack, angle); }), 0.01,
                0.045 * 0.01);
  }
}

constexpr const char* kSensor =
    "changes.robot.tether_sensor={tension_noise_n: 1.5, direction_noise_deg: 0.5}";

TEST(TetherSensor, IsInTheFramesOfARunWithItsNoise) {
  const RunRecord record = SimulateTypical({kSensor, "time_limit_s=40"});
  ASSERT_EQ(record.sensors.size(), 3u);
  EXPECT_EQ(record.sensors[kTetherTension].name, "tether_tension_n");
  EXPECT_EQ(record.sensors[kTetherTension].noise, 1.5);
  EXPECT_DOUBLE_EQ(record.sensors[kTetherElevation].noise, Radians(0.5));
  std::size_t tension = 0;
  while (record.channels[tension].name != "tension_n") ++tension;
  double square = 0.0, largest_n = 0.0;
  for (const HistorySample& sample : record.history) {
    ASSERT_EQ(sample.sensed.size(), 3u);
    const double error_n = sample.sensed[kTetherTension] - sample.channels[tension];
    square += error_n * error_n;
    largest_n = std::max(largest_n, sample.channels[tension]);
  }
  const double count = static_cast<double>(record.history.size());
  ASSERT_GT(count, 300.0);
  EXPECT_GT(largest_n, 10.0);
  // Readings and truth of one frame; the history's first and last samples may lie between two.
  EXPECT_NEAR(std::sqrt(square / count), 1.5, 0.2 * 1.5);
}

TEST(TetherSensor, ChangesNothingButTheReadings) {
  const std::vector<std::string> short_run{"time_limit_s=20"};
  const RunRecord without = SimulateTypical(short_run);
  const RunRecord with = SimulateTypical({kSensor, "time_limit_s=20"});
  EXPECT_TRUE(without.sensors.empty());
  EXPECT_TRUE(without.history.back().sensed.empty());
  EXPECT_EQ(with.result.state_hash, without.result.state_hash);
}

TEST(TetherSensor, ItsNoiseIsInTheNominalParametersWhereThereIsOne) {
  const BuiltRun run = Build(TypicalScenario({kSensor}));
  const Json json = ToJson(run.nominal);
  EXPECT_EQ(json.at("tether_sensor").at("tension_noise_n"), 1.5);
  EXPECT_EQ(json.at("tether_sensor").at("direction_noise_rad"), Radians(0.5));
  const Nominal read = NominalFromJson(json);
  ASSERT_TRUE(read.tether_sensor);
  EXPECT_EQ(read.tether_sensor->tension_noise_n, 1.5);
  const Json none = ToJson(Build(TypicalScenario()).nominal);
  EXPECT_FALSE(none.contains("tether_sensor"));
  EXPECT_FALSE(NominalFromJson(none).tether_sensor);
}

TEST(TetherSensor, WrongKeysAreRefusedWithTheirPlace) {
  const ScratchFolder folder;
  const auto message = [&](const std::vector<std::string>& sets) {
    return MessageOf([&] { LoadModels(TypicalScenario(sets)); }, folder);
  };
  EXPECT_THAT(message({"changes.robot.tether_sensor.tension_noise_n=-1"}),
              HasSubstr("tether_sensor.tension_noise_n: expected a number >= 0"));
  EXPECT_THAT(message({"changes.robot.tether_sensor.tension_noise=1"}),
              HasSubstr("tether_sensor.tension_noise"));
  EXPECT_THAT(message({"as_built.robot.tether_sensor.tension_offset_n=1"}),
              HasSubstr("as_built.robot.tether_sensor: expected none"));
  EXPECT_THAT(message({kSensor, "as_built.robot.tether_sensor.tension_noise_n=1"}),
              HasSubstr("as_built.robot.tether_sensor.tension_noise_n: expected none"));
  EXPECT_EQ(message({kSensor, "as_built.robot.tether_sensor.tension_offset_n=1"}), "(no error)");
}

}  // namespace
}  // namespace dockyard::axel
