// The rover and its station in the gravity of another place, against closed forms; and a docking on
// Mars.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "axel/sim/product.h"
#include "axel/sim/scenarios.h"

namespace dockyard::axel {
namespace {

constexpr double kMars = 3.71, kMoon = 1.62, kEarth = 9.81;  // [m/s^2]

SoilModel In(double gravity_m_s2, SoilModel soil) {
  soil.gravity_m_s2 = gravity_m_s2;
  return soil;
}

/// The rover 3.5 m before the station, braked, tether slack.
WorldSetup SetupIn(double gravity_m_s2, const SoilModel& soil) {
  WorldSetup setup = TestSetup(In(gravity_m_s2, soil), {3.5, 0.0, kPi});
  setup.slack_start_m = 0.3;
  return setup;
}

std::unique_ptr<World> Resting(const WorldSetup& setup) {
  auto world = std::make_unique<World>(setup);
  Play(*world, AllBraked(), 8.0);
  return world;
}

TEST(Gravity, GroundBearsTheRoversWeight) {
  for (const SoilModel& soil : {LooseSand(), CompactGravel()}) {
    for (const double g : {kEarth, kMars, kMoon}) {
      const WorldSetup setup = SetupIn(g, soil);
      const Truth truth = Resting(setup)->truth();
      const double borne_n =
          truth.left_wheel_load_n + truth.right_wheel_load_n + truth.tip_ground_force_n;
      const double weight_n = g * setup.rover.mass_kg();
      EXPECT_NEAR(borne_n, weight_n, 0.01 * weight_n) << soil.name << ", " << g;
    }
  }
}

TEST(Gravity, IsTheInertialUnitsSpecificForceAtRest) {
  for (const double g : {kEarth, kMars, kMoon}) {
    const auto world = Resting(SetupIn(g, LooseSand()));
    world->TakeTrueImu();
    Play(*world, AllBraked(), 0.5);
    EXPECT_NEAR(world->TakeTrueImu().sample.specific_force_R.norm(), g, 1e-3) << g;
  }
}

// On four springs: m g / 4 k at its middle; it leans a little, as its weight is not there.
TEST(Gravity, StationPressesItsFeetInByItsWeight) {
  const StationModel station = Station();
  const auto height_m = [&](double g) {
    return Resting(SetupIn(g, CompactGravel()))->truth().X_WS.p.z();
  };
  const double stiffness_n_per_m =
      station.foot_stiffness_n_per_m * static_cast<double>(station.feet.size());
  const double rise_m = station.module.mass_kg * (kEarth - kMars) / stiffness_n_per_m;
  EXPECT_NEAR(height_m(kMars) - height_m(kEarth), rise_m, 0.06 * rise_m);
}

// k and load go with gravity, so grains sink as deep (Kobayashi et al. 2010); cohesion does not, so
// that its share of what carries a paddle grows as the weight falls.
TEST(Gravity, WheelsSinkAsDeepInSandWithoutCohesion) {
  const auto sinkage_m = [](double g, double cohesion_pa) {
    SoilModel sand = LooseSand();
    sand.cohesion_pa = cohesion_pa;
    const Truth truth = Resting(SetupIn(g, sand))->truth();
    return 0.5 * (truth.left_sinkage_m + truth.right_sinkage_m);
  };
  const double here_m = sinkage_m(kEarth, 0.0);
  EXPECT_GT(here_m, 0.02);
  EXPECT_NEAR(sinkage_m(kMars, 0.0), here_m, 0.06 * here_m);
  EXPECT_NEAR(sinkage_m(kMoon, 0.0), here_m, 0.06 * here_m);
  EXPECT_LT(sinkage_m(kMoon, 2000.0), sinkage_m(kEarth, 2000.0) - 0.002);
}

// The nominal one alone: a place whose gravity is 2 % more than its map has.
TEST(Gravity, OfThePlaceIsANominalParameter) {
  const BuiltRun run = Build(
      TypicalScenario({"changes.soil.gravity_m_s2=3.71", "as_built.soil.gravity_m_s2.times=1.02"}));
  EXPECT_EQ(run.nominal.gravity_m_s2, kMars);
  EXPECT_NEAR(run.nominal.station_weight_n, kMars * run.world.station.module.mass_kg, 1e-9);
  EXPECT_NEAR(run.world.soil.gravity_m_s2, 1.02 * kMars, 1e-12);
  EXPECT_NEAR(GravityOf(run.world).z(), -1.02 * kMars, 1e-9);
  EXPECT_EQ(Build(TypicalScenario()).nominal.gravity_m_s2, kEarth);
}

TEST(Gravity, OfEarthIsThatOfAScenarioWithoutIt) {
  WorldSetup setup = SetupIn(kEarth, LooseSand()), plain = setup;
  plain.soil = LooseSand();
  const auto a = Resting(setup), b = Resting(plain);
  EXPECT_EQ(a->StateHash(1), b->StateHash(1));
  EXPECT_EQ(GravityOf(setup), GravityInSite(setup.slope));
}

// The typical docking in closed loop. The controller multiplies its forces by the nominal gravity;
// with those of Earth it drags the station, which weighs less.
TEST(Gravity, OfMarsLetsTheRoverDockWhereItIsNominal) {
  const RunRecord nominal = SimulateTypical({"changes.soil.gravity_m_s2=3.71"});
  EXPECT_EQ(nominal.result.outcome, "docked") << nominal.failure_note;
  EXPECT_LT(MeasureOf(nominal, "station_shift_m"), 0.02);
  const RunRecord earths = SimulateTypical({"as_built.soil.gravity_m_s2=3.71"});
  EXPECT_GT(MeasureOf(earths, "station_shift_m"), 0.03);
}

}  // namespace
}  // namespace dockyard::axel
