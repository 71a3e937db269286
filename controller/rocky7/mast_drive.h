// Turns the mast's joints: all of them together to given angles, or along with a line that is given
// point by point.
#pragma once

#include <vector>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "controller/rocky7/mast.h"

namespace dockyard::rocky7 {

class MastDrive {
 public:
  explicit MastDrive(const Nominal& nominal);

  MastAngles Angles(const SensorFrame& sensed) const;
  /// Begins a move at a share of the joints' speeds; all joints arrive together.
  void Begin(const MastAngles& goal, double speed_share, const SensorFrame& sensed);
  /// The next point of a line, a control period further.
  void Follow(const MastAngles& goal);
  /// Whether the move is over and the mast at rest. A joint that load holds back is left after a
  /// while: see Missed.
  bool Rests(const SensorFrame& sensed);
  /// Whether a joint is not where it was sent.
  bool Missed(const SensorFrame& sensed) const;
  /// Commands of the mast's motors, in their order: braked before the first move.
  const std::vector<MotorCommand>& commands() const { return commands_; }

 private:
  const Nominal nominal_;
  std::size_t first_ = 0;  // of the mast's motors
  MastAngles goal_{};
  std::vector<MotorCommand> commands_;
  Tick since_ = 0, arrived_ = 0;
  double takes_s_ = 0.0;
  bool there_ = false;
};

}  // namespace dockyard::rocky7
