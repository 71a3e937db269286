// Rover and station without ground, for tests of their dynamics.
#pragma once

#include <array>

#include "axel/sim/product.h"
#include "sim/axel/contact_world.h"

namespace dockyard::axel {

inline const Eigen::Vector3d kWeightless = Eigen::Vector3d::Zero();

struct Afloat {
  /// Rover far from the station.
  explicit Afloat(double gravity, double x = 50.0)
      : Afloat(Axel(), Station(), {0.0, 0.0, -gravity}, Pose3::Translation(x, 0.0, 0.0), 0.3) {}
  Afloat(const RoverModel& rover_model, const StationModel& station_model,
         const Eigen::Vector3d& gravity_G, const Pose3& X_GR, double arm_rad,
         const Pose3& X_GS = {}, bool right_first = false)
      : model(rover_model),
        world(gravity_G),
        rover(world, model, X_GR, arm_rad, right_first),
        station(world, station_model, X_GS),
        contacts(world, model, station_model, rover, station) {}
  Afloat(const Afloat&) = delete;
  Afloat& operator=(const Afloat&) = delete;

  RoverModel model;
  RigidWorld world;
  RoverBody rover;
  StationBody station;
  ContactWorld contacts;
};

inline constexpr std::array<RoverLink, 4> kAllLinks = {RoverLink::kBody, RoverLink::kLeftWheel,
                                                       RoverLink::kRightWheel, RoverLink::kArm};

}  // namespace dockyard::axel
