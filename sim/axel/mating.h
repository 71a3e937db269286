// Where the arm touches the cone, both turned parts.
#pragma once

#include <vector>

#include "models/axel/station_model.h"
#include "models/parts/link.h"
#include "sim/rigid/bore_contacts.h"

namespace dockyard::axel {

class Mating {
 public:
  Mating(const ConeModel& cone, const std::vector<Collision>& arm_parts);

  /// Contacts with gaps below within_m, in the mouth's frame M. X_MA: the arm.
  void Find(const Pose3& X_MA, double within_m, std::vector<BoreContact>& contacts) const;

 private:
  BoreContacts bore_;
};

/// Whether it is on the flat annulus round the mouth; the contact is in the mouth's frame.
bool IsOnFace(const BoreContact& contact);

}  // namespace dockyard::axel
