#include "controller/vision/board/locate.h"

#include "controller/base/check.h"

namespace dockyard {

const char* Name(PoseFailure failure) {
  switch (failure) {
    case PoseFailure::kTooFewFiducials:
      return "too few fiducials";
    case PoseFailure::kNoCorrespondence:
      return "no correspondence";
    case PoseFailure::kBehindCamera:
      return "behind camera";
    case PoseFailure::kPoorFit:
      return "poor fit";
    case PoseFailure::kCamerasDisagree:
      return "cameras disagree";
    case PoseFailure::kUncertain:
      return "too uncertain";
    case PoseFailure::kNotUpright:
      return "not upright";
    case PoseFailure::kAmbiguous:
      return "ambiguous";
  }
  return "unknown";
}

LocateOutput LocateBoard(const StereoImages& images, const StereoRig& rig,
                         const FiducialBoard& board, const LocateHints& hints,
                         const VisionSettings& settings, const ErrorAllowance& errors) {
  if (settings.pipeline == VisionPipeline::kTsai2013) {
    DOCKYARD_CHECK(HasTwoOfEachRotation(board));
    return LocateTsai2013(images, rig, board, hints, settings);
  }
  return LocateDockyard(images, rig, board, hints, errors);
}

}  // namespace dockyard
