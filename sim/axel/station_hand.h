// Somebody moves the docking station while the rover is under way: takes hold of it, carries it
// aside in its plane and turns it, and lets go.
#pragma once

#include <limits>

#include "controller/geometry/pose.h"
#include "sim/axel/station_body.h"

namespace dockyard::axel {

/// By how much, in the dock frame as it stood before; about the vertical through its mouth.
struct StationMove {
  double at_s = std::numeric_limits<double>::infinity();  // infinite: never
  double forward_m = 0.0, left_m = 0.0, turn_rad = 0.0;
};

class StationHand {
 public:
  explicit StationHand(const StationMove& move) : move_(move) {}

  bool Holds(double time_s) const;
  /// Adds the hand's force and torque of this step. Level only: feet and ground bear the weight.
  void Hold(double time_s, StationBody& station);
  /// How far the mouth should have been carried by now, in G [m].
  const Eigen::Vector3d& carried_G() const { return carried_G_; }

 private:
  StationMove move_;
  bool begun_ = false;
  Eigen::Vector3d p_GM_ = Eigen::Vector3d::Zero();  // mouth as it was taken up
  Eigen::Vector3d p_MC_G_ = Eigen::Vector3d::Zero();
  double heading_rad_ = 0.0;
  Eigen::Vector3d carried_G_ = Eigen::Vector3d::Zero();
};

}  // namespace dockyard::axel
