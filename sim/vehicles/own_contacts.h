// Where a robot's further links (models/parts/jointed_link.h) touch other links of the same robot.
// Two links do not meet that a joint or a pin joins, or joints with links without a shape between.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/parts/jointed_link.h"
#include "models/parts/wheel.h"
#include "sim/vehicles/jointed_links.h"
#include "sim/vehicles/part_contacts.h"

namespace dockyard {

/// What one link of a robot shows to others.
struct LinkParts {
  std::vector<Collision> collisions;  // in the link's frame
  std::optional<WheelModel> wheel;    // then the link is a wheel about its y
};

/// The solid of a collision in the link's frame, as a convex polyhedron. A round part becomes one
/// of 16 sides that holds it, at most 2 % wider; a ball one that is at most 6 % wider; a mesh the
/// hull of at most 50 of its points.
ConvexBody SolidOf(const Collision& collision);

class OwnContacts {
 public:
  /// parts: of all links, by their numbers, the further ones last. The world must outlive this.
  OwnContacts(RigidWorld& world, int body, const JointedLinks& further, const TreePlaces& places,
              const std::vector<LinkParts>& parts);

  /// Adds the contacts of the next step to the world.
  void AddContacts() { contacts_.AddContacts(); }
  /// Two links that reach into each other by more than this as they are; none: empty. For a start.
  std::optional<std::pair<int, int>> FindOverlap(double depth_m);

 private:
  RigidWorld& world_;
  PartContacts contacts_;
  std::vector<int> link_of_;  // by part
};

}  // namespace dockyard
