// The docking as geometry: poses to reach, direction of travel, and from where cameras observe the
// dock.
#pragma once

#include <vector>

#include "controller/base/result.h"
#include "controller/custom/drive.h"

namespace dockyard::custom {

/// A: drive.h.
struct DockPlan {
  Pose2 X_DA_docked, X_DA_staging;
  Pose2 X_AP;           // of the robot's frame that meets the dock's
  double travel = 1.0;  // into the dock: 1 forward, -1 backward
  // Of A in D at the staging pose where a camera measures the dock. It differs from that of the
  // docked pose if no camera sees the dock while the robot drives in.
  double measuring_rad = 0.0;
  bool drives_blind = false;
  std::vector<int> cameras;  // those that see the dock there

  /// From A to the docked pose along the path into the dock, and to the left of that path.
  double Left(const Pose2& X_DA) const;
  double Aside(const Pose2& X_DA) const;
  /// Whether A is near enough to the staging pose to begin the drive in.
  bool IsAtStaging(const Pose2& X_DA) const;
  /// P where the robot is, in P where it is docked.
  Pose2 OffDocked(const Pose2& X_DA) const;
  /// Moves the docked pose to the left of the path into the dock.
  void Shift(double left_m);
};

/// Refuses a docked heading that does not point along x of D, and cameras that see no board from
/// the staging pose in any heading.
Result<DockPlan, Refusal> PlanDocking(const Nominal& nominal, const Drive& drive);

/// Whether the camera shows the whole board, not too obliquely, with the robot's R there.
bool Shows(const Nominal& nominal, int camera, const Pose2& X_DR);

}  // namespace dockyard::custom
