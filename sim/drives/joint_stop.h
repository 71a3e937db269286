// End stops of a joint.
#pragma once

#include <algorithm>

namespace dockyard {

/// A spring with a damper, beyond the limits alone; never pulls. Loads [N m, N] by places [rad, m].
struct JointStop {
  double stiffness = 0.0, damping = 0.0;

  double Load(double at, double rate, double low, double high) const {
    const double beyond = at > high ? at - high : at < low ? at - low : 0.0;
    if (beyond == 0.0) return 0.0;
    const double load = -stiffness * beyond - damping * rate;
    return beyond > 0.0 ? std::min(load, 0.0) : std::max(load, 0.0);
  }
};

}  // namespace dockyard
