// The inertial unit without errors: attitude now, rates and specific force averaged over a reading.
#pragma once

#include "controller/io/sensors.h"
#include "sim/physics/motion.h"

namespace dockyard {

class ImuAverage {
 public:
  ImuAverage(const Eigen::Vector3d& p_RI, double gravity_m_s2)
      : p_RI_(p_RI), gravity_m_s2_(gravity_m_s2) {}

  /// Forgets all and starts at this motion.
  void Start(const LinkMotion& body);
  /// Takes in the motion at the end of a step.
  void Add(const LinkMotion& body, double dt_s);
  /// Attitude now in the frame in which X_WG is given, averages since the last call.
  ImuSample Take(const LinkMotion& body, const Pose3& X_WG);

 private:
  Eigen::Vector3d p_RI_;
  double gravity_m_s2_ = 0.0;
  Eigen::Vector3d last_v_GI_G_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d force_R_ = Eigen::Vector3d::Zero(), turn_R_ = Eigen::Vector3d::Zero();
  double time_s_ = 0.0;
};

}  // namespace dockyard
