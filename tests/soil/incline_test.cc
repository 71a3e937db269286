// One of Axel's wheels drives itself up an incline, on both soils of the Mars Yard. Published of
// the real wheel (R. Kurdyumov, senior thesis on Axel's paddle wheels, Caltech): slip is about
// twice, power over 1.5 times as high on loose as on compact soil.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "controller/geometry/pose.h"
#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

constexpr double kWeight_n = 196.0;  // half of the rover's

struct Climb {
  double slip = 0.0;               // of the paddles' tips
  double shaft_joule_per_m = 0.0;  // work of the axle per way
};

/// The slip at which the wheel's pull is the weight's share along the incline, by bisection.
Climb Drive(const char* soil, double incline_rad) {
  SingleWheelSetup setup;
  setup.wheel = Wheel("axel");
  setup.soil = Soil(soil);
  setup.load_n = kWeight_n * std::cos(incline_rad);
  setup.speed_m_s = 0.05;
  double low = -0.2, high = 0.6;
  SingleWheelResult result;
  for (int i = 0; i < 9; ++i) {
    setup.slip = 0.5 * (low + high);
    result = RunSingleWheel(setup);
    (result.ahead_n < kWeight_n * std::sin(incline_rad) ? low : high) = setup.slip;
  }
  // Per way of 1 m the wheel turns by 1 / (r (1 - s)), or (1 + s) / r where it is dragged.
  const double rim_m = setup.wheel.rim_radius_m, s = setup.slip;
  const double turn_rad = (s >= 0.0 ? 1.0 / (1.0 - s) : 1.0 + s) / rim_m;
  return {1.0 - 1.0 / (turn_rad * RollingRadius(setup.wheel)), result.torque_nm * turn_rad};
}

TEST(Incline, CostsMoreSlipAndPowerOnLooseThanOnCompactSoilAsPublished) {
  for (const double incline_deg : {0.0, 5.0, 10.0, 15.0}) {
    const Climb loose = Drive("loose_sand", Radians(incline_deg));
    const Climb compact = Drive("compact_gravel", Radians(incline_deg));
    const double slips = loose.slip / compact.slip;
    const double powers = loose.shaft_joule_per_m / compact.shaft_joule_per_m;
    std::printf("%2.0f deg: slip %.1f, %.1f %% (ratio %.1f), shaft %.1f, %.1f J/m (ratio %.1f)\n",
                incline_deg, 1e2 * loose.slip, 1e2 * compact.slip, slips, loose.shaft_joule_per_m,
                compact.shaft_joule_per_m, powers);
    EXPECT_GT(loose.slip, compact.slip);
    EXPECT_GT(loose.shaft_joule_per_m, compact.shaft_joule_per_m);
    if (incline_deg < 10.0) continue;  // docs/results/soil.md has the level's
    EXPECT_GT(slips, 1.5);
    EXPECT_LT(slips, 3.5);
    EXPECT_GT(powers, 1.25);
    EXPECT_LT(powers, 2.2);
  }
}

}  // namespace
}  // namespace dockyard::soil_test
