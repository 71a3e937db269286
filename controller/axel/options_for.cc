#include "controller/axel/options_for.h"

#include <initializer_list>

namespace dockyard::axel {
namespace {

double Weight(const Nominal& nominal) { return nominal.rover_mass_kg * nominal.gravity_m_s2; }

// Thrust of the wheels that lifts the level arm, over the weight: their torque turns the body back.
double LiftingShare(const Nominal& nominal) {
  return nominal.arm_down_nm / (nominal.wheel_radius_m * Weight(nominal));
}

void Scale(std::initializer_list<double*> numbers, double factor) {
  for (double* number : numbers) *number *= factor;
}

}  // namespace

AxelOptions OptionsFor(const Nominal& nominal) {
  const Nominal design;
  AxelOptions options;
  TetherOptions& tether = options.tether;
  MateOptions& mate = options.mate;
  auto& reel_in = options.haul;
  Scale({&tether.drive_tension_n, &tether.aside_tension_n, &tether.reverse_tension_n,
         &tether.reel_tension_n, &tether.search_tension_n, &tether.first_tension_n,
         &tether.nudge_thrust_n, &options.hold.least_pull_n, &mate.thrust_n, &mate.still_thrust_n,
         &mate.enter_thrust_n, &mate.gentle_tension_n, &mate.taut_tension_n,
         &reel_in.align_tension_n, &options.noise.weight_n},
        Weight(nominal) / Weight(design));
  const double more_play_rad = nominal.seated_play_rad - design.seated_play_rad;
  mate.lean_limit_rad += more_play_rad;
  reel_in.elevation_rad += more_play_rad;
  options.plan.lift_share *= LiftingShare(nominal) / LiftingShare(design);
  return options;
}

}  // namespace dockyard::axel
