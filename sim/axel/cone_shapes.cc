#include "sim/axel/cone_shapes.h"

#include "models/parts/collision_reach.h"

namespace dockyard::axel {

Collision ConeBlock(const ConeModel& cone) {
  return {"cone",
          CylinderShape{cone.face_outer_radius_m, cone.socket_end_m},
          {RotY(0.5 * kPi), Eigen::Vector3d(-0.5 * cone.socket_end_m, 0.0, 0.0)}};
}

std::vector<Collision> ArmCollisions(const RoverModel& rover) {
  const double tip_middle = rover.arm_length_m - 0.5 * rover.tip.length_m;
  const CollarModel& collar = rover.collar;
  const bool has_collar = collar.radius_m > 0.0;
  std::vector<Collision> collisions;
  for (const Collision& collision : rover.arm.collisions) {
    if (has_collar && collision.name == "collar") continue;
    if (ReachAlongX(collision) <= tip_middle) collisions.push_back(collision);
  }
  if (has_collar) {
    const double shoulder = collar.front_m - collar.lead_in_m;
    collisions.push_back({"collar",
                          TurnedShape{{{shoulder - collar.length_m, collar.radius_m},
                                       {shoulder, collar.radius_m},
                                       {collar.front_m, collar.front_radius_m}}},
                          Pose3{RotY(0.5 * kPi), Eigen::Vector3d::Zero()}});
  }
  Pose3 X_AG;
  X_AG.R = RotY(0.5 * kPi);
  X_AG.p.x() = tip_middle;
  collisions.push_back({"tip", CylinderShape{rover.tip.radius_m, rover.tip.length_m}, X_AG});
  return collisions;
}

}  // namespace dockyard::axel
