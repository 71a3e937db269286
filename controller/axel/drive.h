// From a twist to wheel speeds, and from a tension to a spool command.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "controller/motion/path_follower.h"

namespace dockyard::axel {

inline MotorCommand& CommandOf(Commands* commands, Motor motor) {
  return commands->motors[static_cast<std::size_t>(motor)];
}

/// Wheel commands for a twist. If one wheel would exceed the nominal limit, both are slowed by the
/// same factor.
void CommandWheels(const Nominal& nominal, const Twist& twist, double accel_rad_s2,
                   Commands* commands);
void SetWheels(MotorMode mode, Commands* commands);
/// Wheels that push or hold back with at most thrust_n together.
void LimitThrust(const Nominal& nominal, double thrust_n, Commands* commands);

/// The force of both wheels, by their currents, less what their gears take [N], >= 0. Currents do
/// not tell which way.
double WheelThrust(const Nominal& nominal, const SensorFrame& sensed);

/// Spool current for a tension: torque T r over torque per ampere, plus no-load current.
double CurrentForTension(const Nominal& nominal, double tension_n);
/// The reverse: tension from a current while reeling [N], >= 0.
double TensionFromCurrent(const Nominal& nominal, double current_a);
/// Drives the tether out at this speed.
MotorCommand PayOut(const Nominal& nominal, double speed_m_s, double accel_rad_s2);
/// Reels in at this speed, with the current limit for this tension: the spool takes up slack,
/// stalls at the tension and pays out above it.
MotorCommand Winch(const Nominal& nominal, double reel_m_s, double tension_n, double accel_rad_s2);

}  // namespace dockyard::axel
