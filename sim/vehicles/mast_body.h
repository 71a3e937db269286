// A mast with an instrument as links of a tree.
#pragma once

#include <vector>

#include "models/parts/mast_model.h"
#include "sim/rigid/rigid_world.h"

namespace dockyard {

/// Thickness of its bars; assumed, 2-5 cm.
inline constexpr double kMastBar_m = 0.03;

/// The instrument, among the mast's links: it slides along the second link on the spring by which
/// the mast gives way. Its frame is the second link's where the spring is free.
inline constexpr int kMastCan = kMastMotors;

/// The mast's links on link 0, in the order of its motors, and the instrument. `first`: the number
/// of the first one.
std::vector<TreeLink> MastLinks(const MastModel& mast, int first);

/// What a motor of the mast turns with no load, its rotor included, both links straight [kg m^2].
double MastInertia(const MastModel& mast, int motor);

/// Adds the stops of the joints. `first`: of the mast's links.
void LimitMast(const MastModel& mast, const BodyLink& first, RigidWorld& world);

}  // namespace dockyard
