// One wheel in its rig: towed resistance, paddles, reversal, steps.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"
#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

SingleWheelSetup Towed(const WheelModel& wheel, const SoilModel& soil, double load_n = 200.0) {
  SingleWheelSetup setup;
  setup.wheel = wheel;
  setup.soil = soil;
  setup.load_n = load_n;
  setup.speed_m_s = 0.1;
  setup.free_spin = true;
  return setup;
}

double ResistanceShare(const SingleWheelSetup& setup) {
  const SingleWheelResult result = RunSingleWheel(setup);
  EXPECT_TRUE(result.steady);
  return -result.ahead_n / setup.load_n;
}

/// Bekker's compaction resistance of a towed rigid wheel over its load (Bekker 1969):
/// z = (3 W / (b (3 - n) k sqrt(D)))^(2/(2n+1)), R = b k z^(n+1) / (n+1).
double BekkerResistance(const SingleWheelSetup& setup) {
  const double n = setup.soil.n, b = setup.wheel.width_m;
  const double k = PlateModulus(setup.soil, b);
  const double z =
      std::pow(3.0 * setup.load_n / (b * (3.0 - n) * k * std::sqrt(2 * setup.wheel.rim_radius_m)),
               2.0 / (2.0 * n + 1.0));
  return b * k * std::pow(z, n + 1.0) / (n + 1.0) / setup.load_n;
}

TEST(TowedWheel, NearsBekkersResistanceAsReboundVanishes) {
  for (SoilModel soil : {Soil("pavlov_90"), Soil("wong_dry_sand")}) {
    soil.slip_weakening = 0.0;
    SingleWheelSetup setup = Towed(AxelWheel(0), soil);
    const double with_rebound = ResistanceShare(setup);
    setup.soil.unloading_stiffness_pa_per_m = 1e9;
    setup.step_s = 2.5e-4;
    const double without = ResistanceShare(setup);
    EXPECT_LT(with_rebound, without) << soil.name;
    EXPECT_NEAR(without / BekkerResistance(setup), 1.0, 0.25) << soil.name;
  }
}

TEST(TowedWheel, ResistsAsTheTrialsDoBetweenSkidAndNone) {
  // Not measured: the trials' drawbar at slip -0.2 and 0, interpolated to the slip of no torque,
  // is -0.18 of the load (smooth) and -0.19 (grousers) at -0.09 and -0.10.
  const auto resistance = [](const char* wheel) {
    SingleWheelSetup setup = Towed(Wheel(wheel), Soil("pavlov_90"), 24.0);
    setup.speed_m_s = 0.01;
    return ResistanceShare(setup);
  };
  EXPECT_NEAR(resistance("pavlov_smooth"), 0.18, 0.02);
  // Too much: the soil between the grousers counts as going along with the wheel.
  EXPECT_NEAR(resistance("pavlov_grouser"), 0.19, 0.06);
}

TEST(TowedWheel, PullsHarderOnLooseThanOnCompactSoil) {
  // Of the smooth wheel, towed_theory_test.cc. Paddles that stand on their tips resist by the climb
  // from tip to tip, at most R (1 - cos 15 deg) for every pitch of 2 R sin 15 deg; those in sand
  // by more than the smooth wheel, and by less than what is predicted where nothing rebounds.
  const double climb = 0.5 * std::tan(Radians(7.5));
  for (double load_n : {150.0, 300.0}) {
    const double smooth = ResistanceShare(Towed(AxelWheel(0), Soil("loose_sand"), load_n));
    const double paddled = ResistanceShare(Towed(Wheel("axel"), Soil("loose_sand"), load_n));
    const double compact = ResistanceShare(Towed(Wheel("axel"), Soil("compact_gravel"), load_n));
    EXPECT_GT(paddled, 1.2 * smooth);
    EXPECT_LT(paddled, load_n < 200.0 ? 0.169 : 0.203);
    EXPECT_GT(compact, 0.1 * climb);
    EXPECT_LT(compact, climb);
    EXPECT_GT(paddled, 2.0 * compact);
  }
}

TEST(TowedWheel, RocksOverItsPaddlesOnCompactSoilOnly) {
  // A 12-cornered wheel on hard ground: height R cos(x), |x| <= 15 deg, rms 3.4 mm for 0.33 m.
  const auto rms = [](int paddles, const char* soil) {
    return RunSingleWheel(Towed(AxelWheel(paddles), Soil(soil))).height_rms_m;
  };
  EXPECT_NEAR(rms(12, "compact_gravel"), 3.4e-3, 0.7e-3);
  EXPECT_LT(rms(12, "loose_sand"), 1.0e-3);
  EXPECT_LT(rms(0, "compact_gravel"), 0.2e-3);
}

TEST(TowedWheel, PaddlesStandOnCompactSoilAndSinkIntoLoose) {
  // Below the height of a wheel that stands on its tips; 30 mm is the paddles' height.
  const auto sinkage = [](const char* soil) {
    return RunSingleWheel(Towed(AxelWheel(24), Soil(soil))).sinkage_m;
  };
  EXPECT_LT(sinkage("compact_gravel"), 0.010);
  EXPECT_GT(sinkage("loose_sand"), 0.020);
}

TEST(DrivenWheel, HalvingTheStepChangesLittle) {
  SingleWheelSetup setup = Towed(AxelWheel(12), Soil("loose_sand"));
  setup.free_spin = false;
  setup.slip = 0.17;
  const SingleWheelResult coarse = RunSingleWheel(setup);
  setup.step_s = 5e-4;
  const SingleWheelResult fine = RunSingleWheel(setup);
  EXPECT_NEAR(coarse.ahead_n, fine.ahead_n, 0.02 * setup.load_n);
  EXPECT_NEAR(coarse.sinkage_m, fine.sinkage_m, 1e-3);
}

/// A smooth wheel at fixed height, driven along x at this speed and slip; the last load.
struct Carriage {
  HeightGrid grid = LevelGrid(-3.0, 6.0, 1.2, 0.02);
  WheelSoil contact{AxelWheel(0), Soil("loose_sand")};
  WheelMotion motion;
  double angle = 0.0;

  Carriage() { motion.X_GK.p.z() = 0.28; }
  WheelLoad Drive(double speed_m_s, double slip, double way_m) {
    const double spin = speed_m_s / (1.0 - slip) / 0.30;
    WheelLoad load;
    for (double way = 0.0; way < way_m; way += std::fabs(speed_m_s) * 1e-3) {
      motion.X_GK.R = RotY(angle);
      motion.v_GK_G = Eigen::Vector3d(speed_m_s, 0.0, 0.0);
      motion.w_GK_G = Eigen::Vector3d(0.0, spin, 0.0);
      load = contact.Step(grid, motion, 1e-3);
      motion.X_GK.p.x() += speed_m_s * 1e-3;
      angle += spin * 1e-3;
    }
    return load;
  }
};

TEST(ReversedWheel, PullsBackAsItPulledForward) {
  Carriage forward, backward;
  const WheelLoad ahead = forward.Drive(0.1, 0.3, 0.6), back = backward.Drive(-0.1, 0.3, 0.6);
  EXPECT_NEAR(back.force_G.x(), -ahead.force_G.x(), 1e-6 * std::fabs(ahead.force_G.x()) + 1e-6);
  EXPECT_NEAR(back.force_G.z(), ahead.force_G.z(), 1e-6 * ahead.force_G.z());
}

TEST(ReversedWheel, UnloadsAndPullsTheOtherWayInItsOwnRut) {
  Carriage carriage;
  const WheelLoad ahead = carriage.Drive(0.1, 0.3, 0.6);
  // The soil's torque brakes the turning wheel, forward and, some centimetres later, backward.
  EXPECT_LT(ahead.torque_G.y(), -1.0);
  const WheelLoad at_once = carriage.Drive(-0.1, 0.3, 0.0005);
  EXPECT_LT(at_once.torque_G.y(), 0.0);
  EXPECT_GT(at_once.torque_G.y(), 1.2 * ahead.torque_G.y());
  const WheelLoad back = carriage.Drive(-0.1, 0.3, 0.2);
  EXPECT_GT(back.torque_G.y(), 1.0);
  // It rolls on the floor that it has pressed: less resistance than ahead.
  EXPECT_LT(back.force_G.x(), ahead.force_G.x());
}

}  // namespace
}  // namespace dockyard::soil_test
