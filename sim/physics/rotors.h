// Rotor inertia of the geared joints, which Bullet's articulated body does not model. A rotor on
// the body turns N times as fast as its joint, so its inertia N^2 J resists the joint's own
// acceleration alone, not the turning of body and link together: it stands on the diagonal of the
// joint-space inertia (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 9.6). The terms
// left out are smaller by 1 / N, some per mille here.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <vector>

namespace dockyard {

class Rotors {
 public:
  /// inertia_kg_m2 by Bullet's index of the link, reflected to the joint; > 0.
  Rotors(btMultiBody& body, std::vector<double> inertia_kg_m2);

  /// Call it before a step's loads act on the body's speeds.
  void RememberSpeeds();
  /// Call it after the loads. It takes from the joints' speeds the share that
  /// turns the rotors. With H the body's inertia without rotors and E its joints' axes, by the
  /// matrix inversion lemma (H + E J E^T)^-1 = H^-1 - H^-1 E (J^-1 + E^T H^-1 E)^-1 E^T H^-1.
  void TakeTheirShare();

 private:
  btMultiBody& body_;
  std::vector<double> inertia_kg_m2_, speeds_rad_s_;
  btAlignedObjectArray<btScalar> scratch_r_;
  btAlignedObjectArray<btVector3> scratch_v_;
};

}  // namespace dockyard
