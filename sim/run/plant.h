// The physical side of one run: the robot, its target and its surroundings, with the sensors. A
// plant is made fresh for each run and is repeatable bit for bit.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/geometry/robot_pose.h"
#include "controller/io/belief.h"
#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "sim/log/stage.h"

namespace dockyard {

class Plant {
 public:
  virtual ~Plant() = default;

  virtual Tick tick() const = 0;
  /// The readings of all sensors but the cameras now, without the delay and the noise of those
  /// with a name. Called once every control period.
  virtual SensorFrame Sense() = 0;
  /// The images of these cameras now; a camera that gives none is left out.
  /// @param exposure_stops  off the cameras' own exposure, as Commands has it
  virtual std::vector<CameraImage> TakeImages(const std::vector<int>& cameras,
                                              double exposure_stops) = 0;
  /// One control period under these commands.
  virtual void Advance(const Commands& commands) = 0;

  /// Truth, for the record: the robot in its target's frame D.
  virtual RobotPose X_DR() const = 0;
  /// Truth, for the history: appends the system's channels, in their order.
  virtual void AppendChannels(std::vector<double>& values) const = 0;
  /// Truth, for the log and for images from outside: where everything is now.
  virtual Stage Look() const { return {}; }
  /// The robot's pose by an accepted sighting of its target.
  virtual RobotPose MeasuredPose(const SightingReport& report) const = 0;

  /// Bit-exact fingerprint of the moving state, on top of `seed`.
  virtual std::uint64_t StateHash(std::uint64_t seed) const = 0;
  /// The same at the end of a run, with all that changes slowly, such as the ground.
  virtual std::uint64_t FinalHash(std::uint64_t seed) const { return StateHash(seed); }
};

}  // namespace dockyard
