#include "controller/axel/excursion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard::axel {
namespace {

Nominal TippedBy(double tip_rad) {
  Nominal nominal;
  nominal.X_DB.R.col(2) = Eigen::Vector3d(-std::cos(tip_rad), 0.0, std::sin(tip_rad));
  nominal.seat_depth_m = 0.27;
  return nominal;
}

TEST(Excursion, TheSeatedArmTellsTheFallOfTheGround) {
  const Nominal nominal = TippedBy(Radians(5.0));
  EXPECT_NEAR(FallBySeatedArm(nominal, Radians(5.0)), 0.0, 1e-12);
  EXPECT_NEAR(FallBySeatedArm(nominal, Radians(20.0)), Radians(15.0), 1e-12);
}

TEST(Excursion, TheSpoolHoldsMoreTheSteeperItGoesDownAndNeverLessThanInReverse) {
  const AxelOptions options;
  const double level_n = options.tether.reverse_tension_n;
  EXPECT_EQ(OutwardTension(options, 0.0), level_n);
  EXPECT_EQ(OutwardTension(options, Radians(-15.0)), level_n);
  EXPECT_NEAR(OutwardTension(options, Radians(30.0)),
              level_n + 0.5 * options.excursion.weight_share * options.noise.weight_n, 1e-9);
}

TEST(Excursion, NeitherSpinningWheelsNorASlackTetherCountAsWay) {
  EXPECT_EQ(WayOut(10.0, 6.0), 6.0);
  EXPECT_EQ(WayOut(6.0, 10.0), 6.0);
}

TEST(Excursion, TheUndockedTipIsClearOfTheMouth) {
  const ExcursionOptions options;
  EXPECT_DOUBLE_EQ(UndockedWay(TippedBy(0.0), options) - 0.27, options.clear_gap_m);
}

TEST(Excursion, TheWayBackEndsWhereTheBoardIsSeen) {
  const ExcursionOptions options;
  EXPECT_DOUBLE_EQ(10.0 - WayBack(10.0, options), options.return_m);
  EXPECT_EQ(WayBack(3.0, options), 0.0);
}

}  // namespace
}  // namespace dockyard::axel
