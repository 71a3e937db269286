// Where robot, dock and ground touch.
#pragma once

#include <optional>

#include "sim/custom/tree_in_world.h"
#include "sim/custom/world_setup.h"
#include "sim/vehicles/floor_contacts.h"
#include "sim/vehicles/own_contacts.h"
#include "sim/vehicles/part_contacts.h"
#include "sim/vehicles/spring_pins.h"

namespace dockyard::custom {

struct WorldContacts {
  /// All of them must outlive this.
  WorldContacts(const WorldSetup& setup, RigidWorld& world, const TreeInWorld& robot,
                const TreeInWorld& dock);

  /// Adds the contacts of the next step to the world.
  void AddAll(double step_s);
  /// After the world's step: the sum of the forces between robot and dock, pins included [N].
  double TakeForces(double step_s);

  RigidWorld& world;
  PartContacts parts;  // of robot with dock
  FloorContacts robot_floor, dock_floor;
  std::optional<OwnContacts> robot_own, dock_own;
  SpringPins pins;
  int dock_body = 0;
};

}  // namespace dockyard::custom
