// Where round and flat-sided parts of a robot press into a convex body, such as a rock.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/rigid/convex_body.h"

namespace dockyard {

/// One point of contact, in the frame of the body.
struct BodyContact {
  int feature = 0;                  // of the part; the same from step to step
  Eigen::Vector3d p{0, 0, 0};       // on the part's surface, within the body
  Eigen::Vector3d normal{0, 0, 1};  // out of the body, to the part
  double depth_m = 0.0;             // > 0
  double share = 1.0;               // of the contact's stiffness: a line counts by two points
};

/// A cylinder in the body's frame.
struct Cylinder {
  Eigen::Vector3d centre{0, 0, 0}, axis{0, 0, 1};  // the axis is a unit vector
  double radius_m = 0.0, half_m = 0.0;             // half of its length
};

/// Adds the contacts of a cylinder's side and ends, features `feature` and the next one.
///
/// The depth under the side, radius less the distance from the axis to the body, is a concave
/// function along the axis. Its part above 0 carries at the two points of Gauss's rule, which give
/// a force and a moment without a jump between a line and a point. Each is pushed towards the axis;
/// where it is deepest at an end of the cylinder, the edge there meets a sloping side of the body
/// and is pushed square to that side. A cylinder that has entered the body by an end less than by
/// its side is pushed out along its axis.
void AddCylinderContacts(const ConvexBody& body, const Cylinder& cylinder, int feature,
                         std::vector<BodyContact>& contacts);

/// Adds the contacts of another convex body, given in the frame of the first: the deepest point of
/// each edge of one in the other. Neither leaves the other by its far side: a corner that is
/// pressed beyond the middle of a plate is still pushed back. Features from `feature` on, one for
/// each edge of both.
void AddHullContacts(const ConvexBody& body, const ConvexBody& part, int feature,
                     std::vector<BodyContact>& contacts);

/// Adds a straight edge of a part: the two points of Gauss's rule on the length that is pressed in.
/// Features `feature` and the next one.
void AddEdgeContacts(const ConvexBody& body, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     int feature, std::vector<BodyContact>& contacts);

}  // namespace dockyard
