#include "models/axel/make_nominal.h"

#include <algorithm>

#include "models/axel/mating_fit.h"

namespace dockyard::axel {
namespace {

Eigen::Vector2d MiddleOfSoles(const StationModel& station) {
  Eigen::Vector2d middle(0.0, 0.0);
  for (const FootModel& foot : station.feet) middle += foot.p_SF.head<2>();
  return middle / static_cast<double>(station.feet.size());
}

double SpreadOfSoles(const StationModel& station) {
  double sum_m = 0.0;
  for (const FootModel& foot : station.feet) {
    sum_m += (foot.p_SF.head<2>() - MiddleOfSoles(station)).norm();
  }
  return sum_m / static_cast<double>(station.feet.size());
}

// The body's centre of mass behind the axle bears a part of the arm's weight.
double ArmDownMoment(const RoverModel& rover, double gravity_m_s2) {
  const double arm_kg_m = rover.arm.mass_kg * rover.arm.p_LoCom_L.x();
  return gravity_m_s2 * (arm_kg_m + rover.body.mass_kg * rover.body.p_LoCom_L.x());
}

// A socket without walls for the arm to meet lets it turn as far as it likes.
constexpr double kMostPlay_rad = Radians(10.0);

}  // namespace

Nominal MakeNominal(const RoverModel& rover, const StationModel& station, double arm_at_zero_rad,
                    double gravity_m_s2) {
  Nominal nominal;
  nominal.rig = rover.stereo.nominal;
  nominal.shutter_s = rover.stereo.sensor.shutter_s;
  nominal.board = station.board;
  nominal.X_DB = BoardInDock(station);
  for (std::size_t i = 0; i < rover.motors.size(); ++i) {
    nominal.motors[i] = NominalOf(rover.motors[i]);
  }
  nominal.wheel_radius_m =
      0.5 * (RollingRadius(rover.left_wheel_soil) + RollingRadius(rover.right_wheel_soil));
  const int paddles = rover.left_wheel_soil.paddle_count;
  nominal.paddle_pitch_m = paddles > 0 ? 2.0 * kPi * nominal.wheel_radius_m / paddles : 0.0;
  nominal.track_m = rover.track_m();
  nominal.arm_length_m = rover.arm_length_m;
  nominal.arm_at_zero_rad = arm_at_zero_rad;
  nominal.drum_radius_m = rover.tether.drum_radius_m;
  const MotorModel& spool = rover.motors[static_cast<std::size_t>(Motor::kSpool)];
  nominal.spool_friction_n = spool.gear_friction_nm / rover.tether.drum_radius_m;
  nominal.gravity_m_s2 = gravity_m_s2;
  nominal.rover_mass_kg = rover.mass_kg();
  nominal.arm_down_nm = ArmDownMoment(rover, gravity_m_s2);
  nominal.seated_play_rad = std::min(SeatedPlay(rover, station.cone), kMostPlay_rad);
  nominal.station_weight_n = station.module.mass_kg * gravity_m_s2;
  nominal.station_friction = station.foot_friction;
  nominal.station_back_m = -MiddleOfSoles(station).x();
  nominal.station_spread_m = SpreadOfSoles(station);
  nominal.mouth_height_m = station.mouth_height_m;
  nominal.anchor_depth_m = station.anchor_depth_m;
  nominal.throat_depth_m = station.cone.funnel_length_m;
  nominal.seat_depth_m = SeatDepth(station.cone);
  if (rover.tether_sensor) {
    nominal.tether_sensor = {rover.tether_sensor->tension_noise_n,
                             rover.tether_sensor->direction_noise_rad};
  }
  return nominal;
}

Nominal MakeNominal(const RoverModel& rover, const StationModel& station) {
  return MakeNominal(rover, station, rover.arm_at_power_on_rad);
}

}  // namespace dockyard::axel
