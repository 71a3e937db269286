// What the arm carries, by the current of its pitch motor: as it rises empty and as it rises after
// a grasp, through the same angles at the same speed, so that the friction of its gears is the
// same.
#pragma once

#include "controller/rocky7/nominal/nominal.h"

namespace dockyard::rocky7 {

/// The readings of one rise.
class RisingCurrent {
 public:
  /// Counts within the span of angles only, against the level [rad].
  void Add(double pitch_rad, double current_a);
  int count() const { return count_; }
  double mean_a() const;
  double sigma_a() const;   // of the mean
  double mean_cos() const;  // of the angle: a load's lever over the arm's length

 private:
  int count_ = 0;
  double sum_a_ = 0.0, sum_cos_ = 0.0, last_a_ = 0.0, jumps_a2_ = 0.0;
};

/// From where to where the arm rises to be weighed, against the level; downwards positive.
inline constexpr double kWeighFrom_rad = 0.25, kWeighTo_rad = -0.2;

enum class Load { kUnknown, kNone, kStone };

/// Unknown where the noise hides a small stone, or where the motor tells of no current at all.
Load LoadOf(const RisingCurrent& empty, const RisingCurrent& now, const NominalArm& arm,
            const NominalMotor& pitch);

}  // namespace dockyard::rocky7
