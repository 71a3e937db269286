// A face's point and normal as the rover believes them, from one image pair to the next.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/io/belief.h"
#include "controller/rocky7/face_tracker.h"
#include "controller/rocky7/place_plan.h"

namespace dockyard::rocky7 {

/// In E of now, by odometry since the last detection.
struct FaceBelief {
  bool begun = false;  // the target was detected
  Eigen::Vector3d p_ET{0, 0, 0};
  std::optional<Eigen::Vector3d> normal_E{};
  double normal_sigma_rad = 0.0;
  Eigen::Matrix3d bend_E = Eigen::Matrix3d::Zero();  // as FacePlane has it
  std::vector<Eigen::Vector2d> obstacles_E{};
  double turned_rad = 0.0, driven_m = 0.0, signed_m = 0.0;  // since then
  double rolled_m = 0.0;  // and the distance times the sine of the roll, right side down
  double drift_m = 0.0;   // what the drift aside on that may be off, 1 sigma

  bool IsNormalSure() const;
};

/// The rover went on by this, and drove that far, over ground that rises so along x and y.
void MoveOn(const Pose2& since, double driven_m, const Eigen::Vector2d& ground_rise,
            FaceBelief& belief);
/// How far the rover is to the left of where odometry has it, square to the line of sight, by the
/// target's place in a detection.
double FurtherLeft(const FaceBelief& belief, const Eigen::Vector3d& p_E);
/// The target was detected: it is there now, and the face's normal is known better.
void Take(const Nominal& nominal, const FaceStereo& stereo, const FaceView& view,
          const FaceSighting& sighting, FaceBelief& belief);
/// In R. Without a normal, the face leans back along the line of sight.
FaceAt FaceNow(const Nominal& nominal, const ImuSample& attitude, const FaceBelief& belief);
/// The same face, leaning back.
FaceAt LeaningBack(const FaceAt& face);

/// For the record, after that many image pairs.
std::vector<NamedValue> ValuesOf(const FaceBelief& belief, int pairs, double tool_off_rad);

}  // namespace dockyard::rocky7
