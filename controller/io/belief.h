// The controller's belief, for the log and the plots. Nothing acts on it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/geometry/robot_pose.h"

namespace dockyard {

/// One sighting of the target, accepted or refused.
struct SightingReport {
  bool accepted = false;
  std::string reason;         // why not; empty when accepted
  std::string method;         // by which camera or cameras: "stereo", "left", "back"; or empty
  std::vector<int> detected;  // marks measured, not predicted, by camera
  int DetectedBy(int camera) const {
    return camera < static_cast<int>(detected.size()) ? detected[static_cast<std::size_t>(camera)]
                                                      : 0;
  }
  // Index of the mark for each measured pixel, for scoring the correspondence.
  struct Mark {
    int id = -1;
    int camera = 0;
    double u_px = 0.0, v_px = 0.0;
  };
  std::vector<Mark> marks;
  std::vector<Mark> predicted;   // where the others should be, by the pose or the homography
  double reprojection_px = 0.0;  // RMS over the measured marks; NaN where none is reckoned
  Pose3 X_RB;                    // the target in the body of the robot
  // Of p_RB [m], then of a small turn about R's axes [rad]; zero when the pipeline gives none.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  // Right camera against the left beyond the calibration, after this sighting, and 1 sigma [rad].
  Eigen::Vector3d camera_turn_rad = Eigen::Vector3d::Zero();
  Eigen::Vector3d camera_turn_sigma_rad = Eigen::Vector3d::Zero();
};

/// A planned arc in the plane of the dock frame: from start, length along the way (negative
/// backwards), turn.
struct PlannedArc {
  Pose2 X_DR_start;
  double length_m = 0.0;  // signed
  double turn_rad = 0.0;
};

/// A number with its name; the name ends in its unit.
struct NamedValue {
  std::string name;
  double value = 0.0;
};

struct Belief {
  std::string phase;       // a name of the state machine's state
  bool located = false;    // whether X_DR means anything yet
  RobotPose X_DR;          // estimated pose of the robot
  std::string note;        // reason of the last decision, in a few words
  int sighting_count = 0;  // sightings so far; last_sighting is the newest
  std::optional<SightingReport> last_sighting;
  std::vector<PlannedArc> plan;    // of the newest plan
  int plan_count = 0;              // plans so far
  std::vector<NamedValue> values;  // further values for the log, such as "recoveries"
};

/// The belief's value of that name, or the fallback.
double ValueOf(const Belief& belief, std::string_view name, double fallback);

}  // namespace dockyard
