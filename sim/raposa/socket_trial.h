// What the socket lets in: the robot drives straight onto the guide, stops short of its seat, and
// closes its doors. No controller, no camera.
#pragma once

#include "sim/raposa/bench.h"

namespace dockyard::raposa {

struct SocketTrial {
  double arm_rad = 0.0;     // pressed down by this, which leans the body back
  double high_m = 0.0;      // of the guide above its model's height
  double aside_m = 0.0;     // of the robot's path from the guide's axis, to the axis' left
  double turned_rad = 0.0;  // of the path off the axis, counter-clockwise
  double short_m = 0.0;     // it stops so far before the guide would be in its seat
  double speed_m_s = 0.09;
};

struct SocketResult {
  bool held = false;      // the guide within 3 mm of its seat, doors closed
  double pushed_m = 0.0;  // the pyramid, when the doors begin to close
  double before_m = 0.0;  // of the guide before its seat, then; negative: outside of it
  double seat_m = 0.0;    // of the guide from its seat, at the end
  double peak_n = 0.0;    // largest sum of contact forces
};

/// @param base  of OnLevelGround
SocketResult TrySocket(const WorldSetup& base, const SocketTrial& trial);

}  // namespace dockyard::raposa
