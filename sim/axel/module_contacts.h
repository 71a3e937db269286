// Where the rover's links touch the station's module, and where wheels and body touch the cone's
// outside: Bullet's narrow phase (GJK), piece by piece. It is asked for a pair only when two things
// hold: since its last answer the link has moved far enough that the pieces may meet, and no face
// of the station's piece separates them.
#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

#include <vector>

#include "sim/axel/contact_shapes.h"

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
  ModuleContacts(const RoverModel& rover, const StationModel& station);
  ~ModuleContacts();
  ModuleContacts(const ModuleContacts&) = delete;
  ModuleContacts& operator=(const ModuleContacts&) = delete;

  /// Distance of the axle's middle from the mouth beyond which rover and station cannot touch [m].
  double reach_m() const { return shapes_.reach_m(); }
  /// Contacts of the bodies as they stand, for a step of this length.
  void Find(const RoverBody& rover, const StationBody& station, double step_s,
            std::vector<ModuleContact>& contacts);

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
  double MovedSinceLastStep(RoverLink link, const btTransform& X_ML);
  double Separation(const btConvexShape& rover_piece, const btTransform& X_MR, int station_piece,
                    double gap_m) const;
  void Test(Pair& pair);
  void Read(const Pair& pair, std::vector<ModuleContact>& contacts) const;

  ContactShapes shapes_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDispatcherInfo info_;
  std::vector<Pair> pairs_;             // by link
  std::vector<btTransform> last_X_ML_;  // by RoverLink
};

}  // namespace dockyard::axel
