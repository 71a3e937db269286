// Marks of the arm's tip in the yard's soil.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axel/sim/product.h"

namespace dockyard::axel {
namespace {

/// Axel in loose sand, 3 m before the dock and facing it, its arm's tip on the ground.
struct Dragged {
  explicit Dragged(bool marks) : setup(TestSetup(LooseSand(), {3.0, 0.0, kPi})) {
    setup.body_marks_soil = marks;
    setup.arm_start_rad =
        std::asin((setup.rover.left_wheel_soil.rim_radius_m +
                   0.5 * setup.rover.left_wheel_soil.paddle_height_m - setup.rover.tip.radius_m) /
                  setup.rover.arm_length_m);
  }
  WorldSetup setup;
};

Eigen::Vector3d Tip(const World& world, const WorldSetup& setup) {
  return world.truth().X_WA * Eigen::Vector3d(setup.rover.arm_length_m, 0.0, 0.0);
}

/// Away from the dock, the arm held and the tether free: the wheels' torque presses its tip down.
MotorCommands Back() {
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = Velocity(-0.1, 2.8);
  At(commands, Motor::kSpool) = FreeWheel();
  return commands;
}

double Balance(const HeightGrid& grid) {
  double sum = 0.0;
  for (std::size_t i = 0; i < grid.heights_m.size(); ++i) {
    sum += grid.heights_m[i] - grid.undisturbed_m[i];
  }
  return sum * grid.cell_m * grid.cell_m;
}

TEST(SoilMarks, TheTipSinksAndPloughsAFurrowThatStays) {
  const Dragged at(true);
  World world(at.setup);
  const Eigen::Vector3d before = Tip(world, at.setup);
  EXPECT_LT(world.ground().Height(before.x(), before.y()), -2e-3);
  Play(world, Back(), 10.0);
  const Eigen::Vector3d after = Tip(world, at.setup);
  ASSERT_GT((after - before).head<2>().norm(), 0.15);
  // It was dragged backwards, from `before` to `after`.
  const Eigen::Vector3d middle = 0.5 * (before + after);
  EXPECT_LT(world.ground().Height(middle.x(), middle.y()), -2e-3);
  double highest_m = 0.0;
  for (const double aside : {-0.10, -0.08, -0.06, 0.06, 0.08, 0.10}) {
    highest_m = std::max(highest_m, world.ground().Height(middle.x(), middle.y() + aside));
  }
  EXPECT_GT(highest_m, 1e-3);
  EXPECT_GT(world.truth().tip_ground_force_n, 5.0);
  EXPECT_NEAR(Balance(world.ground()), 0.0, 1e-6);
}

TEST(SoilMarks, WithoutTheKeyTheTipLeavesNone) {
  const Dragged at(false);
  World world(at.setup);
  const Eigen::Vector3d before = Tip(world, at.setup);
  EXPECT_EQ(world.ground().Height(before.x(), before.y()), 0.0);
}

TEST(SoilMarks, AreTheSameBitsInTheSameRun) {
  const Dragged at(true);
  World first(at.setup), second(at.setup);
  for (World* world : {&first, &second}) Play(*world, Back(), 1.0);
  EXPECT_EQ(first.StateHash(1), second.StateHash(1));
  EXPECT_EQ(first.ground().heights_m, second.ground().heights_m);
}

}  // namespace
}  // namespace dockyard::axel
