// Drives one arc: steers the wheels while the rover stands, then turns all wheels together, each by
// its own way, and brakes.
#pragma once

#include <vector>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "controller/motion/arcs.h"
#include "controller/rocky7/nominal/nominal.h"

namespace dockyard::rocky7 {

class ArcDrive {
 public:
  explicit ArcDrive(const Nominal& nominal);

  /// Begins an arc; the next call of Step reads where the wheels are.
  void Start(const Arc& arc);
  /// The motors' commands for this period. All braked once it is done.
  std::vector<MotorCommand> Step(const SensorFrame& sensed);
  /// Brakes where the rover is; done() follows when it rests.
  void Stop(const SensorFrame& sensed);
  bool done() const { return phase_ == Phase::kDone; }
  /// What the fixed wheels counted of the arc since its start: the whole of it when it was driven
  /// without slip.
  Pose2 moved() const { return moved_; }
  /// The share of its arc that it has driven, 0 to 1.
  double share() const { return share_; }
  double driven_m() const { return driven_m_; }  // of its length

 private:
  enum class Phase { kDone, kSteer, kDrive, kRest };
  void BeginSteering(const SensorFrame& sensed);
  void BeginDriving(const SensorFrame& sensed);
  bool Arrived(const SensorFrame& sensed, std::size_t first, std::size_t count) const;
  void Count(const SensorFrame& sensed);
  std::size_t wheels() const { return nominal_.plan.wheels.size(); }

  const Nominal nominal_;
  Phase phase_ = Phase::kDone;
  Arc arc_;
  Tick since_ = 0;
  std::vector<double> start_rad_;
  std::vector<MotorCommand> commands_;
  Pose2 moved_;
  double driven_m_ = 0.0, share_ = 0.0;
};

}  // namespace dockyard::rocky7
