// Bullet's shapes from the models' collision geometry.
#pragma once

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <memory>
#include <vector>

#include "models/parts/link.h"

namespace dockyard {

/// Bullet's collision margin on all pieces [m]. Shapes are shrunk by it, so that their surfaces are
/// where the models say; it is also the radius of their edges, the arm tip's rim included.
inline constexpr double kCollisionMargin_m = 1e-3;

/// Shapes of one link, in the link's principal frame P; owns the pieces.
class LinkShape {
 public:
  LinkShape();
  void Add(const Collision& collision, const Pose3& X_PL);
  btCompoundShape* compound() { return &compound_; }
  const btCompoundShape* compound() const { return &compound_; }
  int pieces() const { return compound_.getNumChildShapes(); }

 private:
  std::vector<std::unique_ptr<btCollisionShape>> pieces_;
  btCompoundShape compound_;
};

}  // namespace dockyard
