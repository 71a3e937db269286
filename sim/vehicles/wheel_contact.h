// Where a wheel with paddles presses into a convex body, such as a rock.
#pragma once

#include "controller/geometry/pose.h"
#include "models/parts/wheel.h"
#include "sim/rigid/body_contact.h"

namespace dockyard {

/// Adds the contacts of the wheel's outline, in the body's frame. X_AK is the wheel's pose there;
/// its axle is y, and its first paddle stands at the wheel's phase from x, about y.
///
/// The rim is a cylinder (AddCylinderContacts). A paddle is a plate whose two faces end in an edge
/// across the width; each edge is pressed in by itself (AddEdgeContacts). Between rim and tip a
/// face meets the body along two lines from the rim outwards, at the points of Gauss's rule on the
/// width that the body covers there, so that no body is too small for them.
void AddWheelContacts(const ConvexBody& body, const WheelModel& wheel, const Pose3& X_AK,
                      std::vector<BodyContact>& contacts);

}  // namespace dockyard
