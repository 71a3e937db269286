#include "controller/axel/axel.h"

#include <utility>

#include "controller/axel/machine.h"

namespace dockyard::axel {

namespace {

/// AxelOptions has forces on Earth. Each is a share of a weight: what rolls free wheels over a
/// paddle, lifts the arm, holds the station on its soles.
AxelOptions OptionsIn(double gravity_m_s2) {
  constexpr double kEarthGravity_m_s2 = 9.81;  // standard gravity, rounded
  AxelOptions options;
  TetherOptions& tether = options.tether;
  MateOptions& mate = options.mate;
  for (double* force_n :
       {&tether.drive_tension_n, &tether.aside_tension_n, &tether.reverse_tension_n,
        &tether.reel_tension_n, &tether.search_tension_n, &tether.first_tension_n,
        &tether.nudge_thrust_n, &options.hold.least_pull_n, &mate.thrust_n, &mate.still_thrust_n,
        &mate.enter_thrust_n, &mate.gentle_tension_n, &mate.taut_tension_n,
        &options.noise.weight_n}) {
    *force_n *= gravity_m_s2 / kEarthGravity_m_s2;
  }
  return options;
}

}  // namespace

std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal, Locator locator) {
  if (!locator) {
    locator = [rig = nominal.rig, board = nominal.board, vision = nominal.vision](
                  const StereoImages& images, const LocateHints& hints) {
      return LocateBoard(images, rig, board, hints, vision);
    };
  }
  return MakeAxelMachine(nominal, OptionsIn(nominal.gravity_m_s2), std::move(locator));
}

}  // namespace dockyard::axel
