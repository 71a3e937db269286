// A controller of one's own: from straight ahead, the tether pulls the rover into the cone.
#pragma once

#include <memory>

#include "controller/axel/nominal/nominal.h"
#include "controller/io/controller.h"

/// Wheels free, arm held, the spool reels in until it stalls. Below 5 deg off the cone's axis that
/// is enough (Tsai, Nesnas and Zarzhitsky 2013, V-C).
std::unique_ptr<dockyard::Controller> MakeStraightIn(const dockyard::axel::Nominal& nominal);
