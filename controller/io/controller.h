// A robot's controller. The testbed, a log and a real robot all run it through this one call.
#pragma once

#include "controller/io/belief.h"
#include "controller/io/commands.h"
#include "controller/io/sensors.h"

namespace dockyard {

class Controller {
 public:
  virtual ~Controller() = default;
  /// Called once every control period with the sensors' readings; returns the commands.
  virtual Commands Step(const SensorFrame& sensed) = 0;
  /// Its present belief.
  virtual const Belief& belief() const = 0;
};

}  // namespace dockyard
