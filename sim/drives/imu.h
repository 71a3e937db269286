// The inertial unit without errors: attitude now, rates and specific force averaged over a reading.
#pragma once

#include "controller/io/sensors.h"
#include "sim/rigid/motion.h"

namespace dockyard {

class ImuAverage {
 public:
  ImuAverage(const Eigen::Vector3d& p_RI, const Eigen::Vector3d& gravity_G)
      : p_RI_(p_RI), gravity_G_(gravity_G) {}

  /// Forgets all and starts at this motion.
  void Start(const LinkMotion& body);
  /// Takes in the motion at the end of a step.
  void Add(const LinkMotion& body, double dt_s);
  /// Attitude now in the frame in which X_WG is given, averages since the last call. Its z axis is
  /// up, so that roll and pitch are against gravity.
  ImuSample Take(const LinkMotion& body, const Pose3& X_WG);

 private:
  Eigen::Vector3d p_RI_;
  Eigen::Vector3d gravity_G_ = Eigen::Vector3d::Zero();  // [m/s^2]
  Eigen::Vector3d last_v_GI_G_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d force_R_ = Eigen::Vector3d::Zero(), turn_R_ = Eigen::Vector3d::Zero();
  double time_s_ = 0.0;
};

}  // namespace dockyard
