// Internal to the vision room. Searches for fiducials that the search of the whole image missed,
// where a first pose puts them.
#pragma once

#include <vector>

#include "controller/vision/board/blobs.h"
#include "controller/vision/board/fiducials.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

/// DetectFiducials on levels that the caller keeps.
std::vector<DetectedFiducial> DetectFiducials(const GrayImage& image,
                                              const std::vector<BlobLevel>& levels,
                                              const FiducialBoard& board);

/// Replaces the rim's centre by that of the grey levels where the light allows, and predicts the
/// centre's error.
void SettleCentre(const GrayImage& image, const FiducialBoard& board, DetectedFiducial* fiducial);

/// The rim of a fiducial as a pose puts it; none when part of it lies outside the image.
std::optional<Ellipse> ExpectedRim(const Camera& camera, const Pose3& X_CB,
                                   const Fiducial& fiducial, double diameter_m);

/// Searches for one fiducial about an expected rim. Its place, size and rotation are known, so a
/// weaker match is enough than in a search of the whole image.
/// @param gate_px  how far from its place it may be
std::optional<DetectedFiducial> DetectAt(const GrayImage& image,
                                         const std::vector<BlobLevel>& levels,
                                         const Ellipse& expected, double bar_direction_rad,
                                         const FiducialBoard& board, double gate_px);

/// Direction of a fiducial's bar in the rim's own plane (BarMatch's angle), as the pose puts it.
double ExpectedBar(const Camera& camera, const Pose3& X_CB, const Fiducial& fiducial,
                   double length_m, const Ellipse& rim);

}  // namespace dockyard
