// A robot or a dock of links (models/parts/link_tree.h) as a body of the rigid world.
#pragma once

#include <vector>

#include "models/parts/link_tree.h"
#include "sim/rigid/rigid_world.h"
#include "sim/vehicles/jointed_links.h"
#include "sim/vehicles/own_contacts.h"
#include "sim/vehicles/spring_pins.h"

namespace dockyard::custom {

/// A motor that a controller commands, on a link's joint.
struct CommandedJoint {
  int link = 0;
  double rotor_kg_m2 = 0.0;  // at the joint; of a slide [kg]
};

struct TreeInWorld {
  int body = 0;
  TreePlaces places;  // of the model's links in the tree

  int Place(int link) const { return places[static_cast<std::size_t>(link)]; }
  BodyLink At(int link) const { return {body, Place(link)}; }
  const LinkMotion& Motion(const RigidWorld& world, int link) const {
    return world.body(body).motion(Place(link));
  }
};

/// Adds the tree with its root at X_GB, its joints at their starts, and their limits.
TreeInWorld AddTree(const LinkTree& model, const std::vector<CommandedJoint>& motors,
                    const Pose3& X_GB, TreeBase base, RigidWorld& world);

/// The solids of its collisions, but for those of links in `without`.
std::vector<LinkSolid> SolidsOf(const LinkTree& model, const std::vector<int>& without = {});

}  // namespace dockyard::custom
