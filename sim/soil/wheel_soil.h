// Forces of deformable soil on one rigid wheel with paddles. Independent of Bullet.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "controller/geometry/pose.h"
#include "models/rover_model.h"
#include "models/soil_model.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// Where a wheel is and how it moves, in the site frame G. The wheel frame K turns with the wheel.
struct WheelMotion {
  Pose3 X_GK;
  Eigen::Vector3d v_GK_G = Eigen::Vector3d::Zero();  // of the wheel's centre [m/s]
  Eigen::Vector3d w_GK_G = Eigen::Vector3d::Zero();  // [rad/s], spin included
};

struct WheelLoad {
  Eigen::Vector3d force_G = Eigen::Vector3d::Zero();   // on the wheel [N]
  Eigen::Vector3d torque_G = Eigen::Vector3d::Zero();  // about the wheel's centre [N m]
  double sinkage_m = 0.0;  // of the lowest element below the soil as it was
  bool in_contact = false;
};

/// One wheel's contact state (shear displacement of every element) and the soil under it. Copyable
/// state, no globals; the same calls give the same bits.
class WheelSoil {
 public:
  WheelSoil(const WheelModel& wheel, const SoilModel& soil);

  /// Advances the contact by dt and returns the load; leaves the rut in the grid.
  WheelLoad Step(HeightGrid& grid, const WheelMotion& motion, double dt_s);

  /// Hash of the contact state, for bit-exact comparison of runs.
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct State;
  WheelModel wheel_;
  SoilModel soil_;
  // Implementation's own members follow.
};

}  // namespace dockyard
