// Internal to the vision room. The detections of one image on its tangent plane, and which of them
// lie where marks are expected.
#pragma once

#include <cstddef>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/vision/board/hypotheses.h"
#include "controller/vision/homography.h"

namespace dockyard {

using Naming = std::vector<MarkMatch>;

constexpr double kDiscSizeTolerance = 1.5;  // either way, of a disc's radius against the pose's

/// A detection.
struct SeenMark {
  Eigen::Vector2d at_T;        // on the tangent plane
  Eigen::Matrix2d px_by_T;     // about it
  Eigen::Matrix2d board_by_T;  // from a step on the plane to one on the board [m], but for a turn
  Eigen::Vector3d sight_C;
  double radius_px = 0.0;
  double gate_px = 0.0;
};

/// The detections of one image.
struct DetectedMarks {
  TangentPlane plane;
  std::vector<SeenMark> seen;
  // For NameBy: the detections from left to right on the plane, and how far from one of them a
  // place within its gate can lie.
  std::vector<std::size_t> by_x;
  double reach_T = 0.0;
};

DetectedMarks MarksOf(const std::vector<DetectedFiducial>& detections, const Camera& camera,
                      const FiducialBoard& board);

/// Each mark with the nearest detection of its size within the gate, both once.
/// @param places_T  by mark; NaN: not to be seen
/// @param radii_px  by mark; zero: any
Naming NameBy(const DetectedMarks& marks, const std::vector<Eigen::Vector2d>& places_T,
              const std::vector<double>& radii_px);

}  // namespace dockyard
