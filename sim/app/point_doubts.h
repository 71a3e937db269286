// Poses that the points contradict: the usual mistakes are tried, or the user is warned.
#pragma once

#include "controller/vision/points/point_pose.h"
#include "sim/app/point_files.h"
#include "sim/app/point_report.h"

namespace dockyard {

/// Chi-square above this multiple of its freedom is beyond reason: pixels of 0.15 px then err by
/// 0.34 px. Other people's detectors do, so this alone is a warning. A small body in an image of
/// half the size makes 6 to 7 times; no frame of STAR-loc has 3. Assumed, 4-10.
constexpr double kBeyondReason = 5.0;

/// The pose of a frame by one pipeline. When pipeline dockyard refuses it, or its chi-square is
/// beyond reason, the frame is tried with left and right exchanged, with the body mirrored, and
/// with pixels of an image of another size. When one of these brings chi-square within reason and
/// down to a tenth, the pose is refused as a poor fit and the answer names the mistake. Else a pose
/// beyond reason has a warning.
FrameAnswer AnswerFor(const PointFrame& frame, const StereoRig& rig, const VisionSettings& settings,
                      const PointOptions& options);

}  // namespace dockyard
