// From a pair of pictures to the heights of the ground ahead.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/io/sensors.h"
#include "controller/rocky7/nominal/nominal.h"
#include "controller/stereo/elevation.h"
#include "controller/stereo/ground_motion.h"
#include "controller/stereo/match.h"
#include "controller/stereo/rectify.h"

namespace dockyard::rocky7 {

/// What one pair of pictures shows. Frame E: the rover's R brought down on the ground, level, x
/// ahead.
struct GroundScan {
  Plane ground_R;  // level, at the height of the wheels' lowest points
  Pose3 X_RE;
  Disparities disparities;
};

/// Heights about a place: in fine cells, far away with gaps; and in cells as large as a pixel's
/// footprint, small gaps closed.
struct GroundMaps {
  ElevationMap fine, closed;
  Eigen::Vector3d p_EC{0, 0, 0.3};    // the cameras
  double focal_baseline_px_m = 25.0;  // of the rectified pair
};

/// What the user clicked on.
struct Clicked {
  Eigen::Vector2d p_E{0, 0};       // by the range data there
  Eigen::Vector3d ray_E{0, 0, 0};  // from the cameras; its length has no meaning
  double sigma_rad = 0.0;          // of the ray along each side of the picture
};

class GroundStereo {
 public:
  explicit GroundStereo(const Nominal& nominal, FrontEnd front_end = FrontEnd::kSandAndStones);

  /// The pictures were taken at the attitude of this sample.
  GroundScan Look(const StereoImages& images, const ImuSample& attitude) const;

  /// The place of the ground, in E, that a pixel of the left camera shows; none without range data
  /// about it.
  std::optional<Eigen::Vector2d> PlaceOf(const GroundScan& scan,
                                         const Eigen::Vector2d& pixel) const;

  /// The click with the place that it shows; none as above. By our own matcher a range that is far
  /// off the ground's plane, as the same images show it, gives way to the ray's place on that.
  std::optional<Clicked> ClickOf(const GroundScan& scan, const Eigen::Vector2d& pixel) const;

  /// Heights about a place of E.
  GroundMaps MapsAbout(const GroundScan& scan, const Eigen::Vector2d& p_E) const;

  /// Heights in a window of E.
  ElevationMap Heights(const GroundScan& scan, const ElevationSettings& window) const;

  /// The ground ahead from above, of the pictures that Look() got.
  GroundImage ImageAhead(const GroundScan& scan, const StereoImages& images) const;

 private:
  Nominal nominal_;
  /// Where a ray from the cameras meets the plane of the ground ahead; none where images show too
  /// little of it.
  std::optional<Eigen::Vector2d> OnGround(const GroundScan& scan,
                                          const Eigen::Vector3d& ray_E) const;

  FrontEnd front_end_;
  Rectifier rectifier_;
};

/// A pair of a frame; none unless it has both images.
std::optional<StereoImages> FrontPair(const SensorFrame& frame);
std::optional<StereoImages> BackPair(const SensorFrame& frame);

/// When that pair was exposed; the frame's own time without one.
Tick ExposureOfFront(const SensorFrame& frame);

}  // namespace dockyard::rocky7
