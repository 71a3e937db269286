// Corners of convex solids on a firm floor: a chassis that touches the ground, a robot that has
// tipped over, a dock on feet that may be pushed.
#pragma once

#include <vector>

#include "sim/rigid/convex_body.h"
#include "sim/rigid/rigid_world.h"
#include "sim/vehicles/firm_ground.h"

namespace dockyard {

/// A solid of a link, such as SolidOf (own_contacts.h) makes of a collision.
struct FloorPart {
  BodyLink at{};
  ConvexBody body_L{};
  // Of one corner on a rigid floor. Hard plastic or metal: assumed, 1e4-1e6 and 10-1000.
  double stiffness_n_per_m = 1e5, damping_ns_per_m = 200.0;
  double grip = 1.0;  // its friction over that of rubber on the same floor
};

class FloorContacts {
 public:
  /// World and ground must outlive this; the floors stay as they are.
  FloorContacts(RigidWorld& world, const FirmGround& ground) : world_(world), ground_(ground) {}
  void Add(FloorPart part);
  /// Adds the contacts of the next step to the world: all corners that may touch within it.
  void AddContacts(double step_s);
  /// Of a part in the last step, and on it [N], in G.
  Eigen::Vector3d Force(int part, double step_s) const;

 private:
  struct Part {
    FloorPart part;
    std::vector<ContactMaterial> on;  // by floor
    std::int64_t pair = 0;            // of its first corner
    int first = 0, contacts = 0;      // in the world's step
  };
  RigidWorld& world_;
  const FirmGround& ground_;
  std::vector<Part> parts_;
  std::int64_t corners_ = 0;
  double highest_m_ = 0.0;  // of the ground
};

}  // namespace dockyard
