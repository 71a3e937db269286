// Wheels of one shape in three sizes, in sand without cohesion whose pressure grows in proportion
// to the depth. Slonaker et al. (2017): lengths times q and load times q^3 leave drawbar over load,
// torque over load and radius, and sinkage over radius as they are; their pairs of wheels do so.
// "#90" sand does not: its plates bear as z^1.46, and in proportion to their width.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

struct Shares {
  double pull = 0.0, torque = 0.0, sinkage = 0.0;  // over load, load times radius, radius
};

Shares Roll(const char* name, double size, double slip) {
  SingleWheelSetup setup;
  setup.wheel = Wheel(name);
  const double radius_m = size * setup.wheel.rim_radius_m;
  setup.wheel.rim_radius_m = radius_m;
  setup.wheel.width_m *= size;
  setup.wheel.paddle_height_m *= size;
  setup.wheel.paddle_thickness_m *= size;
  setup.soil = Soil("pavlov_90");
  setup.soil.n = 1.0;
  setup.soil.k_phi = 1.1e6;  // as "#90" sand at 15 mm
  setup.soil.narrowest_plate_m = setup.soil.widest_plate_m = 0.0;
  setup.soil.cohesion_pa = 0.0;
  setup.load_n = 24.0 * size * size * size;
  setup.slip = slip;
  setup.speed_m_s = 0.02 * std::sqrt(size);
  const SingleWheelResult result = RunSingleWheel(setup);
  const Shares shares{result.ahead_n / setup.load_n, result.torque_nm / (setup.load_n * radius_m),
                      result.sinkage_m / radius_m};
  std::printf("%s x %.1f, slip %.1f: pull %.3f, torque %.3f, sinkage %.3f\n", name, size, slip,
              shares.pull, shares.torque, shares.sinkage);
  return shares;
}

TEST(Scaling, LeavesShapesOfOneKindRollingAlike) {
  for (const char* wheel : {"pavlov_grouser", "pavlov_smooth"}) {
    for (const double slip : {0.2, 0.5}) {
      const Shares one = Roll(wheel, 1.0, slip);
      for (const double size : {2.0, 4.5}) {
        const Shares other = Roll(wheel, size, slip);
        EXPECT_NEAR(other.pull, one.pull, 0.03) << wheel << " x " << size << ", slip " << slip;
        EXPECT_NEAR(other.torque / one.torque, 1.0, 0.1) << wheel << " x " << size;
        EXPECT_NEAR(other.sinkage / one.sinkage, 1.0, 0.1) << wheel << " x " << size;
      }
    }
  }
}

}  // namespace
}  // namespace dockyard::soil_test
