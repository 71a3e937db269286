// Rocky 7 in plan, for tests: six wheels, the front ones steered; sizes of models/rovers.
#pragma once

#include <cmath>

#include "controller/geometry/pose.h"
#include "controller/geometry/rover_plan.h"
#include "controller/motion/free_path.h"
#include "sim/base/random.h"

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

// Discs or pentagons about the way, none at its ends.
inline PathDemands SampleDemands(RandomStream& random, const Pose2& goal, int obstacles,
                                 bool cornered) {
  PathDemands demands;
  demands.margin_m = 0.02;
  for (int placed = 0; placed < obstacles;) {
    const Disc disc{{random.Uniform(-1, 4), random.Uniform(-2, 2)}, random.Uniform(0.03, 0.15)};
    if (disc.centre.norm() < 0.8 || (Inverse(goal) * disc.centre).norm() < 0.8) continue;
    ++placed;
    if (!cornered) {
      demands.obstacles.discs.push_back(disc);
      continue;
    }
    Polygon polygon;
    for (int k = 0; k < 5; ++k) {
      const double angle = 0.4 * kPi * k;
      polygon.push_back(disc.centre +
                        disc.radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    demands.obstacles.polygons.push_back(polygon);
  }
  return demands;
}

}  // namespace dockyard
