// Collision of the rover's links with the station, piece by piece. Bullet's own algorithm for
// compounds asks GJK about every pair of pieces whose boxes overlap, and in the socket that is all
// of them; here a pair is asked about only when, after what the link has moved since it was last
// asked about, it may be near enough to meet and no face of the station's piece parts it from the
// rover's piece.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include "sim/axel/station_body.h"

namespace dockyard::axel {

/// Makes the algorithm for a pair of compounds, one of which is the station. Register for compound
/// against compound.
class WedgePairsCreator : public btCollisionAlgorithmCreateFunc {
 public:
  explicit WedgePairsCreator(const StationBody& station) : station_(station) {}
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* body0,
                                                 const btCollisionObjectWrapper* body1) override;

 private:
  const StationBody& station_;
};

}  // namespace dockyard::axel
