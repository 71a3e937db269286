// Links on joints that no controller commands (models/parts/jointed_link.h), as part of a robot's
// tree in the rigid world: their stops and friction, the joints that follow others, the pins that
// close loops, and their motors.
#pragma once

#include <cstdint>
#include <vector>

#include "models/parts/jointed_link.h"
#include "sim/drives/motor_drive.h"
#include "sim/rigid/rigid_world.h"

namespace dockyard {

/// Where a robot's links are in its tree, by their numbers: its own first, then the further ones.
using TreePlaces = std::vector<int>;

/// Adds the further links to the tree's own ones. Returns the places of all; own: those before.
TreePlaces AddJointedLinks(const JointedLinks& further, TreePlaces own,
                           std::vector<TreeLink>& links);

/// Of the joints that follow others.
std::vector<JointTie> TiesOf(const JointedLinks& further, const TreePlaces& places);

/// Sets the angles of the start. The other joints have theirs.
void SetStartAngles(const JointedLinks& further, const TreePlaces& places, TreeBody& tree);

/// Stops, friction and pins. The tree has the pose of the start.
void LimitJoints(const JointedLinks& further, const TreePlaces& places, int body,
                 RigidWorld& world);

/// Of a motor's shaft at the output, with the joint's load, for MotorDrive: with all other joints
/// free as at the tree's present pose, or the joint's own link alone where that is less, as a load
/// may come nearer to its axis. travel_per_rad: of the joint.
double ShaftInertia(const JointedLink& joint, double travel_per_rad, const TreeBody& tree,
                    int link);

/// The motors of such joints. Each runs to and fro between its joint's limits or holds by its
/// brake.
class JointDrives {
 public:
  JointDrives() = default;
  JointDrives(const JointedLinks& further, const TreePlaces& places, const TreeBody& tree);

  /// Adds the motors' torques of one step. running: whether they may run; otherwise they brake.
  void Step(bool running, double step_s, TreeBody& tree);
  /// Whether any of them runs.
  bool runs() const;
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Drive {
    int link = 0;                          // in the tree
    double travel_per_rad = 1.0;           // of the joint, for a turn of the motor's output
    double rate_rad_s = 0.0;               // of the motor, in its present direction
    double low_rad = 0.0, high_rad = 0.0;  // of the motor, at which it turns back
    MotorModel model;
    MotorDrive motor;
  };
  std::vector<Drive> drives_;
};

}  // namespace dockyard
