// Internal to the vision room. From a pose and its marks to the result for the controller and the
// report for the log; both pipelines end here.
#pragma once

#include <string>
#include <vector>

#include "controller/vision/board/locate.h"

namespace dockyard {

/// A pose with the marks that it rests on.
struct Fix {
  RefinedPose fit;
  std::vector<MarkPixel> marks;  // view 0: left, 1: right, whatever the method
  std::string method;            // "stereo", "left", "right"
};

/// The rover in a camera, turned by half of the relative turn as RefinePoints does.
Pose3 TurnedView(const std::vector<CameraView>& views, std::size_t view,
                 const Eigen::Vector3d& turn_rad);

/// Fills in the pose, the measured marks and, for all others, the places that the pose gives.
/// @param views  both
void Describe(const Fix& fix, const std::vector<CameraView>& views, const FiducialBoard& board,
              SightingReport* report);

LocateOutput Refused(PoseFailure failure, SightingReport report);
/// A pose from one camera leaves the belief about the cameras' turn as it was.
LocateOutput Accepted(const Fix& fix, const LocateHints& hints, SightingReport report);

}  // namespace dockyard
