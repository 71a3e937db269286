// Rover and station in the rigid world: finds where they touch each other and rocks, and reads what
// the contacts bore. It has no ground: soil and feet act as loads.
#pragma once

#include <optional>
#include <vector>

#include "sim/axel/mating.h"
#include "sim/axel/module_contacts.h"
#include "sim/axel/rock_contacts.h"
#include "sim/axel/rover_body.h"
#include "sim/axel/station_body.h"
#include "sim/rigid/rigid_world.h"

namespace dockyard::axel {

/// Sum of the station's contact forces on the arm, in G [N].
struct ArmContact {
  Eigen::Vector3d total_G = Eigen::Vector3d::Zero();
  Eigen::Vector3d face_G = Eigen::Vector3d::Zero();  // the part on the annular face
  int points = 0;
};

class ContactWorld {
 public:
  /// All of them must outlive it.
  ContactWorld(RigidWorld& world, const RoverModel& rover_model, const StationModel& station_model,
               const RoverBody& rover, const StationBody& station);

  /// Puts rocks into the rover's way; they are fixed in the ground.
  void PutRocks(const RoverModel& rover, RockBed bed);
  /// One step of the world under the loads given to its bodies.
  void Step(double dt_s);
  const ArmContact& arm_contact() const { return contact_; }
  /// Largest sum of the station's contact forces on the arm in any step [N].
  double arm_force_peak_n() const { return arm_force_peak_n_; }
  /// Sum of the rocks' contact forces on the rover, in G [N], and its largest size in any step.
  const Eigen::Vector3d& rock_force_G() const { return rock_force_G_; }
  double rock_force_peak_n() const { return rock_force_peak_n_; }
  /// What settling at the start loaded is not the run's.
  void ForgetPeaks() { arm_force_peak_n_ = rock_force_peak_n_ = 0.0; }

 private:
  /// Which surfaces a contact is of.
  enum class Surfaces { kFunnel, kFace, kBody, kRock };
  void Add(Surfaces surfaces, RoverLink link, WorldContact contact);
  bool MayTouch() const;
  void FindTouches(double dt_s);
  void FindRocks();
  void ReadContacts(double dt_s);

  RigidWorld& world_;
  const RoverBody& rover_;
  const StationBody& station_;
  ConeModel cone_;
  ContactMaterial body_material_, rock_material_;
  Mating mating_;
  ModuleContacts module_contacts_;
  std::optional<RockContacts> rock_contacts_;
  std::optional<OwnContacts> own_contacts_;  // of further links
  std::vector<BoreContact> matings_;
  std::vector<ModuleContact> modules_;
  std::vector<RockContact> rocks_;
  std::vector<Surfaces> added_;  // of the world's contacts in this step
  ArmContact contact_;
  double arm_force_peak_n_ = 0.0;
  Eigen::Vector3d rock_force_G_{0, 0, 0};
  double rock_force_peak_n_ = 0.0;
};

}  // namespace dockyard::axel
