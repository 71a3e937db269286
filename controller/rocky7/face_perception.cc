#include "controller/rocky7/face_perception.h"

namespace dockyard::rocky7 {

FaceDetection DetectFace(const FaceStereo& stereo, const StereoImages& images,
                         const MastAngles& angles, const ImuSample& attitude,
                         const FaceBelief& belief, const Eigen::Vector2d& click_px,
                         FaceTracker& tracker) {
  FaceDetection detection;
  const auto expected = belief.begun ? std::optional(belief.p_ET) : std::nullopt;
  detection.view = stereo.Look(images, angles, attitude, expected);
  detection.sighting =
      belief.begun
          ? tracker.Follow(stereo, detection.view,
                           {belief.p_ET, belief.turned_rad, belief.driven_m, belief.drift_m})
          : tracker.Begin(stereo, detection.view, stereo.Rectified(click_px));
  return detection;
}

SightingReport ReportOf(const FaceDetection& detection, const FaceStereo& stereo,
                        const FaceBelief& belief) {
  const FaceSighting& sighting = detection.sighting;
  SightingReport report;
  report.accepted = sighting.found;
  report.reason = sighting.found ? "" : sighting.why;
  report.method = "face";
  const Eigen::Vector3d p_E = sighting.found ? sighting.p_E : belief.p_ET;
  const Pose3 X_RE = Inverse(detection.view.X_ER);
  report.X_RB = {X_RE.R, X_RE * p_E};
  if (!sighting.found) return report;
  report.detected = {0, 0, 1, 1};
  for (const bool right : {false, true}) {
    const auto pixel = stereo.Pixel(detection.view, p_E, right);
    if (pixel) report.marks.push_back({0, right ? kMastRight : kMastLeft, pixel->x(), pixel->y()});
  }
  return report;
}

}  // namespace dockyard::rocky7
