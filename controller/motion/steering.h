// Wheels on an arc: steering angles and ways of any list of wheels, on level ground without slip
// along them; and the arcs that the wheels can steer. Nesnas, Maimone and Das (ICRA 2000),
// section III-A.
#pragma once

#include <vector>

#include "controller/geometry/rover_plan.h"
#include "controller/motion/arcs.h"
#include "controller/motion/two_arcs.h"

namespace dockyard {

struct WheelOnArc {
  double steer_rad = 0.0;      // counter-clockwise, within a quarter circle; 0 of a fixed wheel
  double way_m = 0.0;          // that it rolls over the whole arc; negative: backwards
  double side_slip_rad = 0.0;  // from where it points or rolls to where it goes; 0 if it is steered
};

WheelOnArc OnArc(const WheelPlan& wheel, const Arc& arc);

/// The radii that the steered wheels reach, `travel` as given. With all wheels fixed, or able to
/// turn by 90 deg, there are no limits. Where left and right differ, what both sides allow.
ArcLimits LimitsOf(const std::vector<WheelPlan>& wheels, Travel travel);

}  // namespace dockyard
