// Where the pyramid's marks and its grey parts lie in the image, as convex polygons.
#pragma once

#include <optional>
#include <vector>

#include "controller/raposa/nominal/nominal.h"
#include "controller/vision/coverage.h"

namespace dockyard::raposa {

/// How the pyramid lies before the camera. Frame V: the camera in plan, x along its view, y left.
struct PyramidPlace {
  Pose2 X_VD;              // D: the guide's middle on the ground, x out along its axis
  double down_m = 0.0;     // of the guide's middle below the camera
  double pitch_rad = 0.0;  // of the camera, down
  double roll_rad = 0.0;   // of the camera about its view, clockwise as the camera sees it
};

/// [px], (0, 0) at the first pixel's centre. A part's polygons do not overlap each other.
struct MarksInImage {
  std::optional<Eigen::Vector2d> guide_px;  // its middle
  ConvexPolygon guide, rod;
  std::vector<ConvexPolygon> strips, faces;  // of the faces that the camera sees
  std::vector<ConvexPolygon> boxes;          // by Nominal::grey_boxes
};

/// Of a camera at that place. None if a part lies beside or behind the camera.
std::optional<MarksInImage> ProjectMarks(const Nominal& nominal, const PyramidPlace& place);
/// Only the guide with its middle.
std::optional<MarksInImage> ProjectGuide(const Nominal& nominal, const PyramidPlace& place);

/// The pose of P (the guide's middle, x level and out along its axis, z up) in the camera.
Pose3 CameraToPyramid(const PyramidPlace& place);

}  // namespace dockyard::raposa
