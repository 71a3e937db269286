// A single camera's mapping in a robot's file.
#pragma once

#include <string>

#include "models/parts/camera_model.h"
#include "models/read/keys.h"

namespace dockyard {

/// A pinhole without distortion spreads at most this over the image's width; a wider field belongs
/// to the equidistant lens.
inline constexpr double kWidestPinhole_rad = Radians(100.0);

/// How the link's axes lie to a camera without a turn: x along the view, y left, z up, as links of
/// ROS have them; or z along the view, x right, y down, as ROS's *_optical_frame.
enum class LinkAxes { kForward, kOptical };

/// The mapping: the lens's file, or else field of view and size.
struct CameraFile {
  CameraFile();

  CameraModel camera;     // without its nominal camera and place
  std::string lens;       // empty: none. Of its cameras' places nothing is used
  std::string lens_name;  // which of the file's cameras; empty: the only one
  double field_of_view_rad = 0.0;
  int width_px = 0, height_px = 0;  // 0: as in the file
  Eigen::Vector3d p_LC{0, 0, 0};
  RollPitchYaw turn;  // in the link's axes
  LinkAxes axes = LinkAxes::kForward;
  double rate_hz = 10.0;
};

/// Names the keys of the mapping. `sensor` and `as_built` may be left out, wholly or in part.
void VisitCamera(Keys& keys, CameraFile& file);
/// Throws ConfigError.
CameraModel CameraOf(const CameraFile& file);

}  // namespace dockyard
