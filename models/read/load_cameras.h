// models/cameras/*.yaml, and JSON objects in NASA's published form for the cameras of Mars 2020, ->
// Camera. docs/reference/cameras.md describes both.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/camera.h"

namespace dockyard {

/// A camera and where the file places it.
struct PlacedCamera {
  std::string name;
  Camera camera;                      // in its own frame: z along the view, x right, y down
  Pose3 X_FC;                         // that frame in the frame of the file's numbers
  double calibration_error_px = 0.0;  // as stated; 0: not stated
};

/// Every camera of a file: one, a list, or the left and right of a rig. Throws ConfigError.
std::vector<PlacedCamera> LoadCameras(const std::string& file);

/// The camera of that name; with an empty name the only one. Throws ConfigError.
PlacedCamera LoadCamera(const std::string& file, const std::string& name = {});

/// A pair on the rover: the file's `left` and `right`, taken to the rover body by its `in_rover`.
/// width and height 0: as in the file; else that size, which must have the same shape. Every pixel
/// must have a ray. Throws ConfigError.
StereoRig LoadRig(const std::string& file, int width = 0, int height = 0);

/// What the file states its calibration to err [px], 1 sigma, one axis: the key
/// `calibration_error_px` of the rig or the largest of its cameras; 0 when none states it. Throws
/// ConfigError.
double LoadCalibrationError(const std::string& file);

/// Throws ConfigError unless a ray reaches every pixel of the image.
void RequireRays(const std::string& place, const Camera& camera);

}  // namespace dockyard
