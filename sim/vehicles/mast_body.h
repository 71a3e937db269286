// A mast with an instrument as links of a tree.
#pragma once

#include <vector>

#include "models/parts/mast_model.h"
#include "sim/rigid/tree_body.h"

namespace dockyard {

/// The mast's links on link 0, in the order of its motors. `first`: the number of the first one.
std::vector<TreeLink> MastLinks(const MastModel& mast, int first);

/// What a motor of the mast turns with no load, its rotor included, both links straight [kg m^2].
double MastInertia(const MastModel& mast, int motor);

/// Loads of a step: stops of the joints.
void WorkMastStops(const MastModel& mast, int first, TreeBody& tree);

}  // namespace dockyard
