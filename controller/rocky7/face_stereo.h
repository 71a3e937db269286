// From a pair of the mast's pictures to a face: range, plane and view about a place.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/io/sensors.h"
#include "controller/rocky7/mast.h"
#include "controller/stereo/elevation.h"
#include "controller/stereo/face_plane.h"
#include "controller/stereo/match.h"
#include "controller/stereo/rectify.h"

namespace dockyard::rocky7 {

/// X_ER. Frame E: the rover's R brought down on the ground, level, x ahead; as GroundStereo has it.
Pose3 LevelFrame(const Nominal& nominal, const ImuSample& attitude);

/// What one pair of pictures shows.
struct FaceView {
  RectifiedPair pair;   // with X_EC for X_RC: the mast as it stood
  StereoImages images;  // rectified
  Disparities disparities;
  Pose3 X_ER, X_EK;
  Eigen::Vector2d ground_rise{0, 0};  // of the ground's plane along x and y of E
};

class FaceStereo {
 public:
  explicit FaceStereo(const Nominal& nominal, FrontEnd front_end = FrontEnd::kSandAndStones);

  /// @param angles  of the mast when the pictures were taken, at the attitude of the sample
  /// @param p_ET    where the target is expected; none: anywhere from 1.8 m on
  FaceView Look(const StereoImages& images, const MastAngles& angles, const ImuSample& attitude,
                const std::optional<Eigen::Vector3d>& p_ET) const;

  /// Pixel of the rectified left picture that shows what the camera's pixel shows.
  Eigen::Vector2d Rectified(const Eigen::Vector2d& pixel) const;
  /// Pixels of the left and right camera that show a place of E; none beyond their borders.
  std::optional<Eigen::Vector2d> Pixel(const FaceView& view, const Eigen::Vector3d& p_E,
                                       bool right) const;
  /// Plane about a rectified pixel, in E; the farther, the larger. Near by it is matched again with
  /// its own slope taken out of the search: blocks shorten slopes. Not by the paper's front end.
  std::optional<FacePlane> PlaneAt(const FaceView& view, const Eigen::Vector2d& pixel) const;
  /// Heights over level ground about a place of E.
  ElevationMap HeightsAbout(const FaceView& view, const Eigen::Vector2d& p_E, double half_m) const;

 private:
  Nominal nominal_;
  FrontEnd front_end_;
  Rectifier rectifier_;
};

/// The mast's pair of a frame; none unless it has both pictures, not taken before that tick.
std::optional<StereoImages> MastPair(const SensorFrame& frame, Tick not_before);

/// One sigma of a range by the pair, along the ray.
double RangeSigma(const RectifiedPair& pair, double range_m);

}  // namespace dockyard::rocky7
