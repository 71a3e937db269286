// How a part as a whole sits off the place that the rest of its file gives it.
#pragma once

#include <string>

#include "controller/geometry/pose.h"
#include "models/read/keys.h"

namespace dockyard {

/// Names the optional mapping under `key` {x_m, y_m, z_m, roll_deg, pitch_deg, yaw_deg}, each 0 if
/// left out: R turns the part about its own middle, p shifts it, both in the carrier's axes.
void VisitMounting(Keys& keys, Pose3& mounting, std::string_view key = "mounting");

/// Writes its numbers into a tree that leaves them out. `path`: dotted, of the mapping itself.
void PutMountingIfLeftOut(YamlNode& tree, const std::string& path);

}  // namespace dockyard
