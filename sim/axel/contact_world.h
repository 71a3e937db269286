// Moves rover and station by one step: their loads, then the contacts between them and with rocks,
// then their positions. It has no ground: soil and feet act as loads.
#pragma once

#include <optional>
#include <vector>

#include "sim/axel/mating.h"
#include "sim/axel/module_contacts.h"
#include "sim/axel/rock_contacts.h"
#include "sim/axel/rover_body.h"
#include "sim/axel/station_body.h"
#include "sim/rigid/contact_solver.h"

namespace dockyard::axel {

/// Sum of the station's contact forces on the arm, in G [N].
struct ArmContact {
  Eigen::Vector3d total_G = Eigen::Vector3d::Zero();
  Eigen::Vector3d face_G = Eigen::Vector3d::Zero();  // the part on the annular face
  int points = 0;
};

class ContactWorld {
 public:
  ContactWorld(const ConeModel& cone, const Eigen::Vector3d& gravity_G, RoverBody& rover,
               StationBody& station);

  /// Puts rocks into the rover's way; they are fixed in the ground.
  void PutRocks(const RoverModel& rover, RockBed bed);
  /// One step under the loads given to rover and station.
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
  /// A contact between a link and the station or a rock, in G, with the impulse it gave.
  struct Touch {
    RoverLink link = RoverLink::kArm;
    int pair = 0;
    Eigen::Vector3d p_G{0, 0, 0}, normal_G{0, 0, 0};
    double gap_m = 0.0, share = 1.0, friction = 0.0;
    bool on_face = false, on_rock = false;
    Eigen::Vector3d impulse_G{0, 0, 0}, bend_G{0, 0, 0};
  };
  bool MayTouch() const;
  void FindTouches(double dt_s);
  void FindRocks();
  void BearByTheDeepest();
  void GoOnFromLastStep(Touch& touch) const;
  void Resist(double dt_s);
  void ReadContacts(double dt_s);

  ConeModel cone_;
  Eigen::Vector3d gravity_G_{0, 0, 0};  // [m/s^2]
  RoverBody& rover_;
  StationBody& station_;
  Mating mating_;
  ModuleContacts module_contacts_;
  std::vector<BoreContact> matings_;
  std::vector<ModuleContact> modules_;
  std::optional<RockContacts> rock_contacts_;
  double rock_friction_ = 0.0;
  std::vector<RockContact> rocks_;
  std::vector<Touch> touches_, last_touches_;
  ContactStep step_;
  ArmContact contact_;
  double arm_force_peak_n_ = 0.0;
  Eigen::Vector3d rock_force_G_{0, 0, 0};
  double rock_force_peak_n_ = 0.0;
};

}  // namespace dockyard::axel
