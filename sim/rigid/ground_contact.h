// A point that may touch the ground: unilateral spring and damper along the ground's normal,
// bristle friction in its plane. For a station's feet, an arm's tip and a robot's body. A foot with
// a plate sinks into the soil instead of pressing a spring.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sim/soil/height_grid.h"
#include "sim/soil/sinking_plate.h"

namespace dockyard {

struct GroundMaterial {
  double stiffness_n_per_m = 0.0;  // normal, and tangential of the bristle
  double damping_ns_per_m = 0.0;   // of both; normal force never pulls
  double friction = 0.0;           // Coulomb
  SinkingPlate plate{};            // stands for the normal stiffness where it sinks
};

struct GroundPoint {
  Eigen::Vector3d bend_G = Eigen::Vector3d::Zero();  // of the bristle, in the ground's plane [m]
  double sunk_m = 0.0;                               // of the plate: depth that stays
};

/// Force of the ground on a point at p_G that moves with v_G; advances the bristle by one step.
Eigen::Vector3d GroundForce(const HeightGrid& ground, const GroundMaterial& material,
                            const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G, double dt_s,
                            GroundPoint& point);

std::uint64_t HashPoint(std::uint64_t hash, const GroundPoint& point);

}  // namespace dockyard
