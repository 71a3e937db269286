// Rocky 7 in plan, for tests: six wheels, the front ones steered; sizes of models/rovers.
#pragma once

#include "controller/geometry/pose.h"
#include "controller/geometry/rover_plan.h"

namespace dockyard {

inline RoverPlan RockySample() {
  RoverPlan rover;
  rover.name = "sample";
  rover.wheel_radius_m = 0.065;
  rover.wheel_width_m = 0.08;
  for (const double y : {0.2, -0.2}) {
    rover.wheels.push_back({"front", {0.40875, y}, Radians(70.0)});
    rover.wheels.push_back({"middle", {0.069, y}, 0.0});
    rover.wheels.push_back({"back", {-0.069, y}, 0.0});
  }
  rover.body = {{{0.43, 0.18}, {-0.07, 0.18}, {-0.07, -0.18}, {0.43, -0.18}}};
  rover.p_RP = {0.61, 0.0};
  rover.view = ViewPlan{{0.38, 0.0}, 0.0, Radians(51.5), 0.05, 3.0};
  return rover;
}

}  // namespace dockyard
