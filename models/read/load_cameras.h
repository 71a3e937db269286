// models/cameras/*.yaml, JSON objects in NASA's published form for the cameras of Mars 2020, and
// the calibrations of ROS, Kalibr and OpenCV -> Camera. docs/reference/cameras.md describes them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/camera.h"

namespace dockyard {

/// A camera and where the file places it.
struct PlacedCamera {
  std::string name;
  Camera camera;  // in its own frame: z along the view, x right, y down
  Pose3 X_FC;     // that frame in the frame of the file's numbers
  /// That frame in the one of its pair's rectified images, which a camera_info of ROS gives.
  std::optional<Pose3> X_PC{};
  double calibration_error_px = 0.0;  // as stated; 0: not stated
};

inline constexpr int kMostImagePixels = 16384;  // of a side

/// Every camera of a file: one, a list, or the left and right of a rig. Throws ConfigError.
std::vector<PlacedCamera> LoadCameras(const std::string& file);

/// The camera of that name; with an empty name the only one. Throws ConfigError.
PlacedCamera LoadCamera(const std::string& file, const std::string& name = {});

/// Which pixels of a rig must have a ray: all, as the renderer needs it, or the middle one. Then
/// the others are masked: no point is measured there.
enum class Rays { kEverywhere, kMasked };

/// A pair on the rover: the file's `left` and `right`, taken to the rover body by its `in_rover`;
/// or a calibration of two cameras of another program, in the left camera's own frame. `file` may
/// also be "LEFT,RIGHT", two files, or a folder with left.yaml and right.yaml. width and height 0:
/// as in the file; else that size, which must have the same shape. Throws ConfigError.
StereoRig LoadRig(const std::string& file, int width = 0, int height = 0,
                  Rays rays = Rays::kEverywhere);

/// Whether `file` is one of the two forms that name two files of a pair.
bool NamesTwoFiles(const std::string& file);

/// What the file states its calibration to err [px], 1 sigma, one axis: the key
/// `calibration_error_px` of the rig or the largest of its cameras; 0 when none states it. Throws
/// ConfigError.
double LoadCalibrationError(const std::string& file);

/// The camera for images of that size, which must have its shape; width 0: its own. Throws
/// ConfigError.
Camera Sized(const std::string& place, const Camera& camera, int width, int height);

/// Throws ConfigError unless a ray reaches every pixel of the image.
void RequireRays(const std::string& place, const Camera& camera);

/// The pixels of which no ray reaches some part.
struct RaylessPixels {
  long count = 0;
  std::optional<Eigen::Vector2d> at{};  // a place without a ray on the image's outer edge
};
RaylessPixels CountRayless(const Camera& camera);

}  // namespace dockyard
