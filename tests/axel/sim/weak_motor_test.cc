// A motor that gives less torque per ampere than its controller is told.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "axel/sim/product.h"

namespace dockyard::axel {
namespace {

MotorModel& MotorOf(WorldSetup& setup, Motor motor) {
  return setup.rover.motors[static_cast<std::size_t>(motor)];
}

/// The tether's tension at which the spool stalls under braked wheels [N].
double StallTension(double share, double current_a) {
  WorldSetup setup = TestSetup(LooseSand(), {3.0, 0.0, kPi});
  MotorOf(setup, Motor::kSpool).torque_per_amp_nm *= share;
  World world(setup);
  MotorCommands commands = AllBraked();
  At(commands, Motor::kSpool) = Velocity(0.8, current_a);
  Play(world, commands, 6.0);
  EXPECT_NEAR(world.truth().motor_speed_rad_s[3], 0.0, 1e-3);
  return world.truth().tether_tension_n;
}

// T r = k (i - i_0) - f, k with the gears' efficiency in it.
TEST(WeakMotor, SpoolStallsWhereItsTorqueEnds) {
  const RoverModel rover = Axel();
  const MotorModel& spool = rover.motors[static_cast<std::size_t>(Motor::kSpool)];
  for (const double share : {1.0, 0.8, 0.6}) {
    for (const double current_a : {0.6, 1.0}) {
      const double motor_nm =
          share * spool.torque_per_amp_nm * (current_a - spool.no_load_current_a);
      const double expected_n = (motor_nm - spool.gear_friction_nm) / rover.tether.drum_radius_m;
      const double stalled_n = StallTension(share, current_a);
      std::printf("%.0f %% of its torque, %.1f A: stalls at %.1f N, by the balance %.1f N\n",
                  1e2 * share, current_a, stalled_n, expected_n);
      EXPECT_NEAR(stalled_n, expected_n, 0.02 * expected_n);
    }
  }
}

// The drives hold their speed, so a weak wheel draws more: (i - i_0) goes as 1 / k.
TEST(WeakMotor, WheelDrawsTheMoreCurrent) {
  WorldSetup setup = TestSetup(LooseSand(), {4.0, 0.0, kPi});
  MotorOf(setup, Motor::kLeftWheel).torque_per_amp_nm *= 0.6;
  World world(setup);
  Play(world, Drive(0.05 / 0.3, 45.0), 3.0);
  double left_a = 0.0, right_a = 0.0;
  for (int i = 0; i < 60; ++i) {
    Play(world, Drive(0.05 / 0.3, 45.0), 0.05);
    left_a += world.truth().motor_current_a[0] / 60.0;
    right_a += world.truth().motor_current_a[1] / 60.0;
  }
  const double idle_a = MotorOf(setup, Motor::kLeftWheel).no_load_current_a;
  std::printf("left %.3f A, right %.3f A\n", left_a, right_a);
  EXPECT_NEAR((left_a - idle_a) / (right_a - idle_a), 1.0 / 0.6, 0.05);
}

}  // namespace
}  // namespace dockyard::axel
