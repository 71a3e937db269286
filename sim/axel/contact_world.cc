#include "sim/axel/contact_world.h"

#include <algorithm>
#include <utility>

#include "sim/axel/cone_shapes.h"

namespace dockyard::axel {
namespace {

// Contacts are searched when the rover's sphere comes this near the station's [m].
constexpr double kNear_m = 0.1;
// Surfaces this far apart count as contacts that may close within the step: at 0.1 m/s over 5 ms.
constexpr double kWithin_m = 0.5e-3;
// A contact goes on from the last step's impulse and bend when that was this near: further than one
// slides in a step, nearer than the next contact of the same pair. Assumed, range 1-10 mm.
constexpr double kSamePlace_m = 5e-3;

}  // namespace

ContactWorld::ContactWorld(RigidWorld& world, const RoverModel& rover_model,
                           const StationModel& station_model, const RoverBody& rover,
                           const StationBody& station)
    : world_(world),
      rover_(rover),
      station_(station),
      cone_(station_model.cone),
      body_material_(station_model.body_contact),
      rock_material_(rover_model.rock_contact),
      mating_(station_model.cone, ArmCollisions(rover_model)),
      module_contacts_(rover_model, station_model) {
  if (rover_model.further.empty()) return;
  own_contacts_.emplace(world, rover.Place(RoverLink::kBody).body, rover_model.further,
                        rover.places(), PartsOf(rover_model));
}

void ContactWorld::PutRocks(const RoverModel& rover, RockBed bed) {
  if (bed.rocks.empty()) return;
  rock_material_.friction = bed.friction;
  rock_contacts_.emplace(rover, ArmCollisions(rover), std::move(bed.rocks));
}

void ContactWorld::Step(double dt_s) {
  added_.clear();
  if (MayTouch()) FindTouches(dt_s);
  if (rock_contacts_) FindRocks();
  if (own_contacts_) own_contacts_->AddContacts();
  world_.Step(dt_s);
  ReadContacts(dt_s);
}

bool ContactWorld::MayTouch() const {
  const Eigen::Vector3d apart = rover_.motion(RoverLink::kBody).X_GL.p - station_.X_GM().p;
  return apart.norm() < module_contacts_.reach_m() + kNear_m;
}

void ContactWorld::Add(Surfaces surfaces, RoverLink link, WorldContact contact) {
  contact.a = rover_.Place(link);
  if (surfaces != Surfaces::kRock) contact.b = station_.place();
  contact.same_within_m = kSamePlace_m;
  world_.AddContact(contact);
  added_.push_back(surfaces);
}

void ContactWorld::FindTouches(double dt_s) {
  const Pose3 X_GM = station_.X_GM();
  mating_.Find(Inverse(X_GM) * rover_.motion(RoverLink::kArm).X_GL, kWithin_m, matings_);
  for (const BoreContact& contact : matings_) {
    const bool on_face = IsOnFace(contact);
    Add(on_face ? Surfaces::kFace : Surfaces::kFunnel, RoverLink::kArm,
        {.pair = contact.pair,
         .p_G = X_GM * contact.p,
         .normal_G = X_GM.R * contact.normal,
         .gap_m = contact.gap_m,
         .share = contact.share,
         .material = {cone_.contact_stiffness_n_per_m, cone_.contact_damping_ns_per_m,
                      on_face ? cone_.face_friction : cone_.funnel_friction}});
  }
  module_contacts_.Find(rover_, station_, dt_s, modules_);
  for (const ModuleContact& contact : modules_) {
    Add(Surfaces::kBody, contact.link,
        {.pair = -1 - contact.pair,
         .p_G = contact.p_G,
         .normal_G = contact.normal_G,
         .gap_m = contact.gap_m,
         .material = body_material_});
  }
}

void ContactWorld::FindRocks() {
  rock_contacts_->Find(rover_, rocks_);
  for (const RockContact& contact : rocks_) {
    Add(Surfaces::kRock, contact.link,
        {.pair = contact.pair,
         .p_G = contact.at.p,
         .normal_G = contact.at.normal,
         .gap_m = -contact.at.depth_m,
         .share = contact.at.share,
         .material = rock_material_});
  }
}

void ContactWorld::ReadContacts(double dt_s) {
  contact_ = ArmContact{};
  rock_force_G_.setZero();
  const int arm = rover_.Place(RoverLink::kArm).link;
  for (std::size_t i = 0; i < added_.size(); ++i) {
    const WorldContact& touch = world_.contacts()[i];
    if (touch.impulse_G.isZero(0.0)) continue;
    const Eigen::Vector3d force_G = touch.impulse_G / dt_s;
    if (added_[i] == Surfaces::kRock) {
      rock_force_G_ += force_G;
    } else if (touch.a.link == arm) {
      contact_.total_G += force_G;
      ++contact_.points;
      if (added_[i] == Surfaces::kFace) contact_.face_G += force_G;
    }
  }
  arm_force_peak_n_ = std::max(arm_force_peak_n_, contact_.total_G.norm());
  rock_force_peak_n_ = std::max(rock_force_peak_n_, rock_force_G_.norm());
}

}  // namespace dockyard::axel
