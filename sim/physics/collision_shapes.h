// Bullet's shapes from the models' collision geometry, and the docking cone as convex wedges.
#pragma once

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <memory>
#include <vector>

#include "models/rover_model.h"
#include "models/station_model.h"

namespace dockyard {

/// Bullet's collision margin on all pieces [m]. Shapes are shrunk by it, so that their surfaces are
/// where the models say; it is also the radius of their edges, the arm tip's rim included.
inline constexpr double kCollisionMarginM = 1e-3;

/// Shapes of one link, in the link's principal frame P; owns the pieces.
class LinkShape {
 public:
  LinkShape();
  void Add(const Collision& collision, const Pose3& X_PL);
  void AddHull(const std::vector<Eigen::Vector3d>& points, const Pose3& X_PL);
  btCompoundShape* compound() { return &compound_; }
  int pieces() const { return compound_.getNumChildShapes(); }

 private:
  std::vector<std::unique_ptr<btCollisionShape>> pieces_;
  btCompoundShape compound_;
};

/// Corners of the cone's wedges in the mouth frame M. Each wedge is one convex sector of face,
/// funnel and socket: the material outside funnel and socket is convex in every axial cut, so no
/// inner edge lies across the arm's way. Wedges reach a little under their neighbours for the same
/// reason. Corners are placed so that the polygon's mean radius is the model's.
std::vector<std::vector<Eigen::Vector3d>> ConeWedges(const ConeModel& cone);

/// The plate that seats the tip, in the mouth frame M; its front is at stop_depth_m (> 0).
Collision SocketStop(const ConeModel& cone);

/// The arm's shapes: its tip cylinder after ArmTipModel, flat-nosed, its collar after CollarModel,
/// and the collisions of its link but for those that model the same tip and collar.
std::vector<Collision> ArmCollisions(const RoverModel& rover);

}  // namespace dockyard
