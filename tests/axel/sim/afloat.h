// A rover without ground, for tests of its dynamics.
#pragma once

#include <array>

#include "axel/sim/product.h"
#include "sim/axel/contact_world.h"

namespace dockyard::axel {

inline const Eigen::Vector3d kWeightless = Eigen::Vector3d::Zero();

/// Rover far from the station, without ground.
struct Afloat {
  explicit Afloat(double gravity, double x = 50.0)
      : rover(model, Pose3::Translation(x, 0.0, 0.0), 0.3, false),
        station(Station(), Pose3{}),
        bullet(Station().cone, {0.0, 0.0, -gravity}, rover, station) {}

  RoverModel model = Axel();
  RoverBody rover;
  StationBody station;
  ContactWorld bullet;
};

inline constexpr std::array<RoverLink, 4> kAllLinks = {RoverLink::kBody, RoverLink::kLeftWheel,
                                                       RoverLink::kRightWheel, RoverLink::kArm};

}  // namespace dockyard::axel
