// A stone that nothing holds: a rigid convex body that flies freely between contacts.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sim/rigid/convex_body.h"
#include "sim/rigid/tree_body.h"

namespace dockyard {

/// Basalt and its like; assumed, 2 500-3 000 kg/m^3.
inline constexpr double kStoneDensity_kg_m3 = 2700.0;

/// The hull of points on an ellipsoid with axes 1 : 0.8 : 0.65 along x, y, z and noise along their
/// radius, scaled to this length along x. Centred on its centre of mass. Same key, same shape.
ConvexBody LooseStoneShape(double length_m, std::uint64_t key);

/// The attitude in which a shape comes to rest on level ground: it is put down in one that is even
/// over all attitudes, and rolls over edges until its centre of mass, its origin, is over the face
/// that it lies on. Same key, same attitude.
Eigen::Matrix3d RestingTurn(const ConvexBody& shape, std::uint64_t key);

/// The pose of a shape in this attitude on level ground at this height: its lowest corner is on it,
/// or below it by a share of the shape's height.
Pose3 StandingAt(const ConvexBody& shape, const Eigen::Matrix3d& R_GS, const Eigen::Vector2d& p_G,
                 double ground_m, double buried = 0.0);

/// Frame S: the centre of mass of the stone, axes of its shape.
struct LooseStone {
  ConvexBody shape_S;
  LinkModel model{};  // of its mass
  Pose3 X_GS;         // at the start, at rest
};

/// Moves the shape so that its centre of mass is S.
LooseStone MakeLooseStone(const ConvexBody& shape, double density_kg_m3, const Pose3& X_GS);
/// A stone that lies where this body is.
LooseStone MakeLooseStone(const ConvexBody& body_G, double density_kg_m3);

TreeBody BodyOf(const LooseStone& stone);

}  // namespace dockyard
