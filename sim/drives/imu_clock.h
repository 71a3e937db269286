// The inertial unit's clock behind the controller's: a frame has readings of a time before it.
#pragma once

#include <deque>
#include <utility>

#include "models/parts/imu.h"
#include "sim/drives/imu.h"

namespace dockyard {

class ImuClock {
 public:
  explicit ImuClock(const ImuModel& imu)
      : offset_s_(imu.clock_offset_s), drift_(1e-6 * imu.clock_drift_ppm) {}

  /// Takes in what is true until a frame at now_s, the time since the first frame, and returns what
  /// the frame holds of it. Between two frames attitude, rate and force are interpolated; a unit's
  /// own readings wait until they are old enough. Before the first frame the body was at rest.
  TrueImu Pass(const TrueImu& now, double now_s);
  double age_s(double now_s) const;

 private:
  ImuSample At(double time_s) const;

  double offset_s_ = 0.0, drift_ = 0.0;
  std::deque<std::pair<double, ImuSample>> past_;        // time of the frame, ascending
  std::deque<std::pair<double, InertialMean>> waiting_;  // the reading's end
  double read_s_ = 0.0;                                  // end of the last reading taken in
};

}  // namespace dockyard
