#include "controller/rocky7/detour.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "controller/geometry/pose.h"

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector2d;

// A slope of 9 deg straight ahead; the body is level across.
ImuSample Uphill(double yaw_rad) {
  ImuSample attitude;
  attitude.pitch_rad = -0.157;
  attitude.yaw_rad = yaw_rad;
  return attitude;
}

TEST(Detour, ClimbsAt45DegToAPlaceAsideAndFromThere) {
  Detour detour;
  detour.Begin({1.0, 0.0}, Uphill(0.3));
  const Vector2d aside = Vector2d(1.0, 0.0) + detour.FromTarget(0.3).value();
  EXPECT_NEAR(aside.x(), 0.5, 1e-12);
  EXPECT_NEAR(std::abs(aside.y()), 0.5, 1e-12);
  // The place stays where it is while the rover turns.
  const Vector2d turned = detour.FromTarget(0.3 + 0.5 * kPi).value();
  const Vector2d was = detour.FromTarget(0.3).value();
  EXPECT_NEAR((turned - Vector2d(was.y(), -was.x())).norm(), 0.0, 1e-12);
}

TEST(Detour, GoesToTheOtherSideTheNextTime) {
  Detour detour;
  detour.Begin({1.0, 0.0}, Uphill(0.0));
  const double first_m = detour.FromTarget(0.0).value().y();
  detour.Begin({1.0, 0.0}, Uphill(0.0));
  EXPECT_NEAR(detour.FromTarget(0.0).value().y(), -first_m, 1e-12);
}

TEST(Detour, IsOnlyForTargetsUpASteepSlope) {
  Detour detour;
  ImuSample gentle = Uphill(0.0);
  gentle.pitch_rad = -0.05;
  detour.Begin({1.0, 0.0}, gentle);
  EXPECT_FALSE(detour.FromTarget(0.0));
  detour.Begin({-1.0, 0.0}, Uphill(0.0));
  EXPECT_FALSE(detour.FromTarget(0.0));
  detour.Begin({0.3, 1.0}, Uphill(0.0));
  EXPECT_FALSE(detour.FromTarget(0.0));
}

TEST(Detour, EndsNearItsPlaceOrWhereItComesNoNearer) {
  for (const bool arrives : {true, false}) {
    Detour detour;
    detour.Begin({1.0, 0.0}, Uphill(0.0));
    const Vector2d p_TD = detour.FromTarget(0.0).value();
    int pairs = 0;
    for (double off_m = 0.7; detour.FromTarget(0.0) && pairs < 20; ++pairs) {
      if (arrives) off_m -= 0.1;
      detour.Update(Vector2d(off_m, 0.0) - p_TD, 0.0);
    }
    EXPECT_EQ(pairs, arrives ? 6 : 5);
  }
}

}  // namespace
}  // namespace dockyard::rocky7
