// What bears a joint at the end of its travel.
#pragma once

namespace dockyard {

/// A spring and a damper; of a slide [N/m, N s/m].
struct JointStop {
  double stiffness_nm_per_rad = 0.0, damping_nms_per_rad = 0.0;
};

}  // namespace dockyard
