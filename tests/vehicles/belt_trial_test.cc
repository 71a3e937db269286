// A belt at a steady slip against closed forms of uniform pressure.
#include "sim/vehicles/belt_trial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicles/belt_rig.h"

namespace dockyard {
namespace {

constexpr double kRun_m = 0.386, kApart_m = 0.426, kLoad_n = 130.0;

BeltModel Model() { return TwoBelts(kRun_m, kApart_m, 0.0, kHardFloor).belts[0].model; }

BeltTrialResult Driven(const BeltGround& ground, double slip, double side_slip_rad = 0.0) {
  return RunBelt(Model(), Belt(Model(), ground),
                 {.load_n = kLoad_n, .slip = slip, .side_slip_rad = side_slip_rad});
}

TEST(BeltTrial, CarriesItsLoad) {
  for (const BeltGround& ground : {kHardFloor, kGrass}) {
    EXPECT_NEAR(Driven(ground, 0.1).carried_n, kLoad_n, 1e-3 * kLoad_n);
  }
}

// Each place slides by slip times its path under the belt (Wong, Theory of Ground Vehicles):
//   F = mu N (1 - K / (i L) (1 - exp(-i L / K))).
TEST(BeltTrial, DrawbarFollowsWongsIntegral) {
  BeltGround soil = kGrass;
  soil.cohesion_pa = 0.0;
  const double K = soil.shear_displacement_m;
  for (const double slip : {0.05, 0.15, 0.4, 1.0}) {
    const BeltTrialResult result = Driven(soil, slip);
    const double iL = slip * kRun_m;
    const double share = 1.0 - K / iL * (1.0 - std::exp(-iL / K));
    EXPECT_NEAR(result.drawbar_n / (soil.friction * kLoad_n), share, 0.03) << slip;
    const double loss_n = soil.rolling_loss * result.carried_n;
    EXPECT_NEAR(result.torque_nm, Model().sprocket_radius_m * (result.drawbar_n + loss_n),
                0.01 * result.torque_nm);
  }
}

TEST(BeltTrial, BrakesAsItPulls) {
  EXPECT_NEAR(Driven(kHardFloor, -1.0).drawbar_n, -Driven(kHardFloor, 1.0).drawbar_n,
              0.02 * kLoad_n);
}

// Towed broadside with its belt at rest: all strength is against the side.
TEST(BeltTrial, BroadsideTakesTheLateralStrength) {
  BeltGround floor = kHardFloor;
  floor.lateral_ratio = 1.2;
  const BeltTrialResult result = Driven(floor, -1.0, kPi / 2.0);
  EXPECT_NEAR(result.side_n, 1.2 * floor.friction * kLoad_n, 0.01 * kLoad_n);
  EXPECT_NEAR(result.drawbar_n, 0.0, 0.01 * kLoad_n);
}

}  // namespace
}  // namespace dockyard
