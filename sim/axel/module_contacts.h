// Where the rover's links touch the station's module, and where wheels and body touch the cone's
// outside: Bullet's narrow phase (GJK), piece by piece. It is asked for a pair only when two things
// hold: since its last answer the link has moved far enough that the pieces may meet, and no face
// of the station's piece separates them.
#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <array>
#include <vector>

#include "sim/axel/rover_body.h"
#include "sim/axel/station_body.h"

namespace dockyard::axel {

struct ModuleContact {
  RoverLink link = RoverLink::kBody;
  int pair = 0;  // of pieces; the same from step to step
  Eigen::Vector3d p_G{0, 0, 0};
  Eigen::Vector3d normal_G{0, 0, 0};  // from the station to the rover
  double gap_m = 0.0;
};

class ModuleContacts {
 public:
  ModuleContacts(RoverBody& rover, StationBody& station);
  ~ModuleContacts();
  ModuleContacts(const ModuleContacts&) = delete;
  ModuleContacts& operator=(const ModuleContacts&) = delete;

  /// Contacts of the bodies as they stand, for a step of this length.
  void Find(double step_s, std::vector<ModuleContact>& contacts);

 private:
  struct Pair {
    RoverLink link = RoverLink::kBody;
    int rover_piece = 0, station_piece = 0;
    btCollisionAlgorithm* algorithm = nullptr;
    // The pieces are at least this far apart: the distance at the last test, less the motion of the
    // link since. While it exceeds the gap nothing needs a test.
    double clear_m = 0.0;
  };
  void Part(Pair& pair);
  void PlaceColliders();
  double MovedSinceLastStep(RoverLink link, const btTransform& X_SL);
  double Separation(const btConvexShape& rover_piece, const btTransform& X_SR, int station_piece,
                    double gap_m) const;
  void Test(Pair& pair);
  void Read(const Pair& pair, std::vector<ModuleContact>& contacts) const;

  RoverBody& rover_;
  StationBody& station_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDispatcherInfo info_;
  std::vector<Pair> pairs_;  // by link
  std::array<double, kRoverLinkCount> reach_m_{};
  std::array<btTransform, kRoverLinkCount> last_X_SL_;
};

}  // namespace dockyard::axel
