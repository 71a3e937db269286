// Wheels with tyres on a firm floor, driven or free, and ball casters: of a tree of links in the
// rigid world. Each wheel of some width touches by the two points of Gauss's rule along its axle, a
// narrow one or a ball by one, at the lowest points of their circles. So a wheel that turns on the
// spot scrubs: mu N w / sqrt(12), where a line of even pressure has mu N w / 4.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/parts/tyre.h"
#include "sim/rigid/rigid_world.h"
#include "sim/vehicles/firm_ground.h"

namespace dockyard {

/// A tyre on a link. The link turns with the wheel about the axle; a ball's link need not turn.
struct Tyre {
  int link = 0;
  TyreModel model{};
  Eigen::Vector3d axle_L{0, 1, 0};  // unit, to the left of a wheel that rolls forward when it turns
                                    // positively about it
  Eigen::Vector3d p_LK{0, 0, 0};    // centre
};

/// A tyre on the floor in the last step.
struct TyreTruth {
  double load_n = 0.0;
  double along_n = 0.0, across_n = 0.0;  // of the floor on it: forward, and to the left
  // Velocity of its surface on the floor in the same directions, the mean of its contacts.
  double along_m_s = 0.0, across_m_s = 0.0;
  double rolling_m_s = 0.0;  // forward speed of the axle if it did not slip
  bool slides = false;       // one of its contacts is at Coulomb's limit

  /// Forward; 1 of a wheel that spins on the spot, negative of one that is braked. 0 at rest.
  double slip() const;
};

class Tyres {
 public:
  /// On the links of one body. World and ground must outlive this; the floors stay as they are.
  Tyres(RigidWorld& world, const FirmGround& ground, int body, std::vector<Tyre> tyres);

  /// Adds the contacts of the next step to the world.
  void AddContacts(double step_s);
  int count() const { return static_cast<int>(wheels_.size()); }
  const Tyre& tyre(int i) const { return wheels_[static_cast<std::size_t>(i)].tyre; }
  /// After the world's step, whose length it was.
  TyreTruth truth(int i, double step_s) const;

 private:
  struct Wheel {
    Tyre tyre;
    std::vector<ContactMaterial> on;  // by floor
    int first = 0, contacts = 0;      // in the world's step
  };
  void AddContactsOf(Wheel& wheel, std::size_t number, double step_s);

  RigidWorld& world_;
  const FirmGround& ground_;
  int body_ = 0;
  std::vector<Wheel> wheels_;
};

}  // namespace dockyard
