// Collision of the rover's links with the station, piece by piece. Bullet's own algorithm for
// compounds calls GJK for every pair of pieces whose boxes overlap; in the socket all of them do.
// Here GJK is called for a pair only when two things hold: since its last call the link has moved
// far enough that the pieces may meet, and no face of the station's piece separates them.
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
