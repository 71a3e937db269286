// The inertial unit without errors: attitude now, rates and specific force averaged over a reading.
#pragma once

#include <utility>
#include <vector>

#include "controller/io/sensors.h"
#include "models/parts/imu.h"
#include "sim/rigid/motion.h"

namespace dockyard {

/// Averages over a span of time.
struct InertialMean {
  double span_s = 0.0;
  Eigen::Vector3d rate_R{0, 0, 0}, specific_force_R{0, 0, 0};
};

/// What is true of a control period; `readings` where the unit reads more often than it is asked.
struct TrueImu {
  TrueImu(const ImuSample& sample, std::vector<InertialMean> readings = {})
      : sample(sample), readings(std::move(readings)) {}

  ImuSample sample;
  std::vector<InertialMean> readings;
};

class ImuAverage {
 public:
  ImuAverage(const ImuModel& imu, const Eigen::Vector3d& gravity_G)
      : p_RI_(imu.p_RI), gravity_G_(gravity_G), period_s_(imu.unit ? imu.unit->period_s : 0.0) {}

  /// Forgets all and starts at this motion.
  void Start(const LinkMotion& body);
  /// Takes in the motion at the end of a step.
  void Add(const LinkMotion& body, double dt_s);
  /// Attitude now in the frame in which X_WG is given, averages since the last call. Its z axis is
  /// up, so that roll and pitch are against gravity.
  TrueImu Take(const LinkMotion& body, const Pose3& X_WG);

 private:
  /// A sum over steps: of rate and specific force times time.
  struct Sum {
    void Add(const Eigen::Vector3d& step_turn_R, const Eigen::Vector3d& step_push_R, double dt_s);
    InertialMean Mean() const { return {time_s, turn_R / time_s, push_R / time_s}; }

    double time_s = 0.0;
    Eigen::Vector3d turn_R{0, 0, 0}, push_R{0, 0, 0};
  };

  Eigen::Vector3d p_RI_;
  Eigen::Vector3d gravity_G_ = Eigen::Vector3d::Zero();  // [m/s^2]
  double period_s_ = 0.0;  // of the unit's own readings; 0: it has none
  Eigen::Vector3d last_v_GI_G_ = Eigen::Vector3d::Zero();
  Sum sum_, reading_;
  double due_s_ = 0.0;  // until the next reading's end
  std::vector<InertialMean> readings_;
};

}  // namespace dockyard
