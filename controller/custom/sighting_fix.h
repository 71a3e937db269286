// A board's sighting as the filter and the log want it.
#pragma once

#include <vector>

#include "controller/custom/dock_filter.h"
#include "controller/custom/sighting.h"

namespace dockyard::custom {

/// Against gravity in the robot; along its z without a unit.
Eigen::Vector3d UpIn(const ImuSample& imu);

/// The dock in O by each branch.
/// @param X_OR  at the exposure, as is imu
std::vector<DockFix> FixesOf(const BoardSighting& sighting, const Nominal& nominal,
                             const Pose2& X_OR, const ImuSample& imu);

/// For the log, with the pose of the better branch.
SightingReport ReportOf(const BoardSighting& sighting, const Nominal& nominal);

}  // namespace dockyard::custom
