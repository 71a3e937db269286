// A controller. The testbed, a log and a real robot drive it through this one call.
#pragma once

#include "controller/io/belief.h"
#include "controller/io/commands.h"
#include "controller/io/sensors.h"

namespace dockyard {

class Controller {
 public:
  virtual ~Controller() = default;
  /// Called once every control period with what the sensors say; answers what to do.
  virtual Commands Step(const SensorFrame& sensed) = 0;
  /// What it thinks now.
  virtual const Belief& belief() const = 0;
};

}  // namespace dockyard
