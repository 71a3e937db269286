// Convex solids with flat faces that a cable can touch, lie over and rub on.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/rigid/convex_body.h"
#include "sim/rigid/motion.h"

namespace dockyard {

/// A face: the solid lies where normal . p <= offset_m, in the solid's own frame B.
struct CableFace {
  Eigen::Vector3d normal_B{0, 0, 1};
  double offset_m = 0.0;
};

/// A convex solid. `motion` is that of B in the site frame G and is set anew for every step.
struct CableBody {
  std::vector<CableFace> faces;
  double reach_m = 0.0;   // radius about B's origin that holds the solid
  double friction = 0.0;  // Coulomb, of the cable on it
  // A round hole about B's z axis in the face towards +z: a cable inside it touches nothing; 0:
  // none.
  double hole_radius_m = 0.0;
  LinkMotion motion;
};

/// A box about B's origin.
CableBody CableBox(const Eigen::Vector3d& size_m, double friction);
/// A prism about B's z axis with this many sides, its edges on the circle of radius_m, the first of
/// them at phase_rad from x towards y. With many sides it stands for a cylinder.
CableBody CablePrism(double radius_m, double length_m, int sides, double phase_rad,
                     double friction);

/// A body at rest, such as a rock, given in the site frame G.
CableBody CableRock(const ConvexBody& rock_G, double friction);

/// The face that is nearest to a point inside, or that a point outside is furthest out of. The
/// distance is out of that face's plane, < 0 inside.
struct NearestFace {
  double gap_m = 0.0;
  int face = 0;
};
NearestFace FindNearestFace(const CableBody& body, const Eigen::Vector3d& p_B);

/// The shortest way from a to b round a solid, in the plane through both and a given direction.
struct WayRound {
  bool bends = false;                                 // false: the straight line passes clear
  Eigen::Vector3d first_B{0, 0, 0}, last_B{0, 0, 0};  // where it leaves a's and b's straight parts
  double between_m = 0.0;                             // its length from first to last
  double length_m = 0.0;                              // in all
  double turn_rad = 0.0;                              // by which it turns over the solid
};
/// The solid is grown by grow_m on all faces. up_B: roughly out of the solid where the way passes.
WayRound FindWayRound(const CableBody& body, const Eigen::Vector3d& a_B, const Eigen::Vector3d& b_B,
                      const Eigen::Vector3d& up_B, double grow_m);

/// Whether the straight line from a to b passes through the grown solid, and then the sum of the
/// normals of the faces through which it enters and leaves: a first guess of up_B.
bool PassesThrough(const CableBody& body, const Eigen::Vector3d& a_B, const Eigen::Vector3d& b_B,
                   double grow_m, Eigen::Vector3d& out_B);

}  // namespace dockyard
