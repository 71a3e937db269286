// One wheel in its rig: towed resistance, paddles, steps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

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
  const double k = setup.soil.k_c / b + setup.soil.k_phi;
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

TEST(TowedWheel, PullsHarderOnLooseThanOnCompactSoil) {
  for (double load_n : {150.0, 300.0}) {
    for (int paddles : {0, 12}) {
      const double loose = ResistanceShare(Towed(AxelWheel(paddles), Soil("loose_sand"), load_n));
      const double compact =
          ResistanceShare(Towed(AxelWheel(paddles), Soil("compact_gravel"), load_n));
      std::printf("towed, %g N, %d paddles: loose %.3f, compact %.3f\n", load_n, paddles, loose,
                  compact);
    }
  }
}

}  // namespace
}  // namespace dockyard::soil_test
