// Those of AxelOptions that follow from the nominal rover, its station and the place.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"

namespace dockyard::axel {

/// AxelOptions has its numbers for the rover of Nominal's defaults. For another nominal rover:
/// - forces go with its weight, mass times gravity: what rolls free wheels over a paddle, lifts the
///   arm, and pulls it downhill;
/// - the most that a seated arm may lean is its play in the socket and what arm and cone bend;
/// - the thrust that plans avoid goes with what lifts the arm, as a share of the weight.
/// The station's hold, which limits all pulls, comes from its nominal weight (station_hold.h).
AxelOptions OptionsFor(const Nominal& nominal);

}  // namespace dockyard::axel
