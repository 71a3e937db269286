// Perception of a face: an image pair of the mast and the belief before it in, a detection out.
#pragma once

#include "controller/io/belief.h"
#include "controller/rocky7/face_belief.h"

namespace dockyard::rocky7 {

struct FaceDetection {
  FaceView view;
  FaceSighting sighting;
};

/// @param angles  of the mast at the exposure
FaceDetection DetectFace(const FaceStereo& stereo, const StereoImages& images,
                         const MastAngles& angles, const ImuSample& attitude,
                         const FaceBelief& belief, const Eigen::Vector2d& click_px,
                         FaceTracker& tracker);

SightingReport ReportOf(const FaceDetection& detection, const FaceStereo& stereo,
                        const FaceBelief& belief);

}  // namespace dockyard::rocky7
