// Where a thin plate and a stone press into each other.
#pragma once

#include <vector>

#include "sim/rigid/body_contact.h"

namespace dockyard {

/// Adds the contacts of a convex plate with a stone, both in the stone's frame.
///
/// The plate's edges bear where the stone is pressed over them, each by the two points of Gauss's
/// rule. The stone's corners bear where they are in the plate, and leave it by a face that the
/// stone's centre is in front of: a plate is thinner than a stone is deep in it, and the nearest
/// face could be the one behind. Features: two for each edge of the plate, then one for each corner
/// of the stone.
void AddPlateContacts(const ConvexBody& stone, const ConvexBody& plate,
                      std::vector<BodyContact>& contacts);

}  // namespace dockyard
