#include "sim/axel/contact_world.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

namespace dockyard::axel {
namespace {

// Wheels and body against the station: painted metal on rubber or metal (assumed, range 0.3-0.6).
constexpr double kBodyFriction = 0.4;
// A line of contact of the rover with rock: under half of its 40 kg it gives way by 0.4 mm, with a
// fifth of critical damping. Assumed, ranges 0.2-2 MN/m and 0.5-4 kN s/m.
constexpr double kRockStiffness_n_per_m = 5e5, kRockDamping_ns_per_m = 1.3e3;
// Contacts are looked for when the rover's sphere comes this near the station's [m].
constexpr double kNear_m = 0.1;
// Surfaces this far apart count as contacts that may close within the step: at 0.1 m/s over 5 ms.
constexpr double kWithin_m = 0.5e-3;
// A contact goes on from the last step's impulse and bend when that was this near: further than one
// slides in a step, nearer than the next contact of the same pair. Assumed, range 1-10 mm.
constexpr double kSamePlace_m = 5e-3;

// Two directions across a unit vector.
std::pair<Eigen::Vector3d, Eigen::Vector3d> Across(const Eigen::Vector3d& normal) {
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d a = normal.cross(Eigen::Vector3d::Unit(least)).normalized();
  return {a, normal.cross(a)};
}

}  // namespace

ContactWorld::ContactWorld(const ConeModel& cone, const Eigen::Vector3d& gravity_G,
                           RoverBody& rover, StationBody& station)
    : cone_(cone),
      gravity_G_(gravity_G),
      rover_(rover),
      station_(station),
      mating_(cone, rover.arm_parts()),
      module_contacts_(rover, station) {}

void ContactWorld::PutRocks(const RoverModel& rover, RockBed bed) {
  if (bed.rocks.empty()) return;
  rock_friction_ = bed.friction;
  rock_contacts_.emplace(rover, rover_.arm_parts(), std::move(bed.rocks));
}

void ContactWorld::Step(double dt_s) {
  touches_.clear();
  if (MayTouch()) FindTouches(dt_s);
  if (rock_contacts_) FindRocks();
  rover_.TakeLoads(gravity_G_, dt_s);
  station_.TakeLoads(gravity_G_, dt_s);
  if (!touches_.empty()) Resist(dt_s);
  rover_.Move(dt_s);
  station_.Move(dt_s);
  rover_.Refresh();
  station_.Refresh();
  ReadContacts(dt_s);
  std::swap(touches_, last_touches_);
}

bool ContactWorld::MayTouch() const {
  const Eigen::Vector3d apart = rover_.motion(RoverLink::kBody).X_GL.p - station_.X_GM().p;
  return apart.norm() < rover_.reach_m() + station_.reach_m() + kNear_m;
}

void ContactWorld::FindTouches(double dt_s) {
  const Pose3 X_GM = station_.X_GM();
  mating_.Find(Inverse(X_GM) * rover_.motion(RoverLink::kArm).X_GL, kWithin_m, matings_);
  for (const BoreContact& contact : matings_) {
    const bool on_face = IsOnFace(contact);
    touches_.push_back({.link = RoverLink::kArm,
                        .pair = contact.pair,
                        .p_G = X_GM * contact.p,
                        .normal_G = X_GM.R * contact.normal,
                        .gap_m = contact.gap_m,
                        .share = contact.share,
                        .friction = on_face ? cone_.face_friction : cone_.funnel_friction,
                        .on_face = on_face});
  }
  module_contacts_.Find(dt_s, modules_);
  for (const ModuleContact& contact : modules_) {
    touches_.push_back({.link = contact.link,
                        .pair = -1 - contact.pair,
                        .p_G = contact.p_G,
                        .normal_G = contact.normal_G,
                        .gap_m = contact.gap_m,
                        .friction = kBodyFriction});
  }
  BearByTheDeepest();
}

void ContactWorld::FindRocks() {
  rock_contacts_->Find(rover_, rocks_);
  for (const RockContact& contact : rocks_) {
    touches_.push_back({.link = contact.link,
                        .pair = contact.pair,
                        .p_G = contact.at.p,
                        .normal_G = contact.at.normal,
                        .gap_m = -contact.at.depth_m,
                        .share = contact.at.share,
                        .friction = rock_friction_,
                        .on_rock = true});
  }
  BearByTheDeepest();
}

// More do not occur; were there more, the deepest bear.
void ContactWorld::BearByTheDeepest() {
  if (touches_.size() <= kMostContacts) return;
  std::stable_sort(touches_.begin(), touches_.end(),
                   [](const Touch& a, const Touch& b) { return a.gap_m < b.gap_m; });
  touches_.resize(kMostContacts);
}

void ContactWorld::GoOnFromLastStep(Touch& touch) const {
  const Touch* nearest = nullptr;
  double least = kSamePlace_m;
  for (const Touch& last : last_touches_) {
    if (last.pair != touch.pair || last.on_rock != touch.on_rock) continue;
    const double apart = (last.p_G - touch.p_G).norm();
    if (apart < least) {
      least = apart;
      nearest = &last;
    }
  }
  if (nearest == nullptr) return;
  touch.impulse_G = nearest->impulse_G;
  touch.bend_G = nearest->bend_G;
}

void ContactWorld::Resist(double dt_s) {
  constexpr int kRover = RoverBody::kSpeeds;
  constexpr int kMostRows = ContactStep::kMostRows;
  const int count = static_cast<int>(touches_.size()), rows = 3 * count;
  rover_.Refresh();
  station_.Refresh();
  // Rows of the Jacobians, scaled so that the answer is their product: by the mass matrix's factor
  // and by the station's inverse mass and inertia.
  Eigen::Matrix<double, kRover, Eigen::Dynamic, 0, kRover, kMostRows> rover_rows(kRover, rows);
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostRows> directions(3, rows), arms(3, rows);
  step_.count = count;
  step_.velocity.resize(rows);
  step_.impulse.resize(rows);
  for (int i = 0; i < count; ++i) {
    Touch& touch = touches_[i];
    GoOnFromLastStep(touch);
    const auto [a, b] = Across(touch.normal_G);
    Eigen::Matrix3d axes;
    axes << touch.normal_G, a, b;
    directions.middleCols<3>(3 * i) = axes;
    rover_rows.middleCols<3>(3 * i) =
        rover_.PointJacobian(touch.link, touch.p_G).transpose() * axes;
    const Eigen::Vector3d from_com = touch.p_G - station_.CentreOfMass();
    for (int k = 0; k < 3; ++k) arms.col(3 * i + k) = from_com.cross(axes.col(k));
    Eigen::Vector3d apart_G = rover_.motion(touch.link).VelocityAt(touch.p_G);
    if (touch.on_rock) {  // which does not give way
      directions.middleCols<3>(3 * i).setZero();
      arms.middleCols<3>(3 * i).setZero();
    } else {
      apart_G -= station_.motion().VelocityAt(touch.p_G);
    }
    step_.velocity.segment<3>(3 * i) = axes.transpose() * apart_G;
    step_.impulse.segment<3>(3 * i) = axes.transpose() * touch.impulse_G;
    const double stiffness =
        touch.on_rock ? kRockStiffness_n_per_m : cone_.contact_stiffness_n_per_m;
    const double damping = touch.on_rock ? kRockDamping_ns_per_m : cone_.contact_damping_ns_per_m;
    step_.laws[i] = {touch.gap_m, touch.friction, touch.share * stiffness, touch.share * damping,
                     axes.rightCols<2>().transpose() * touch.bend_G};
  }
  const Eigen::LLT<RoverBody::Inertia>& factor = rover_.MassFactor();
  const auto half = factor.matrixL().solve(rover_rows).eval();
  step_.answer.noalias() = half.transpose() * half;
  step_.answer.noalias() += station_.inverse_mass_per_kg() * (directions.transpose() * directions);
  step_.answer.noalias() += arms.transpose() * (station_.InverseInertia() * arms).eval();

  SolveContacts(dt_s, step_);

  rover_.AddSpeeds(factor.solve(rover_rows * step_.impulse));
  for (int i = 0; i < count; ++i) {
    Touch& touch = touches_[i];
    const auto [a, b] = Across(touch.normal_G);
    Eigen::Matrix3d axes;
    axes << touch.normal_G, a, b;
    touch.impulse_G = axes * step_.impulse.segment<3>(3 * i);
    touch.bend_G = axes.rightCols<2>() * step_.laws[i].bend_m;
    if (!touch.on_rock) station_.AddImpulse(-touch.impulse_G, touch.p_G);
  }
}

void ContactWorld::ReadContacts(double dt_s) {
  contact_ = ArmContact{};
  rock_force_G_.setZero();
  for (const Touch& touch : touches_) {
    if (touch.on_rock) {
      rock_force_G_ += touch.impulse_G / dt_s;
      continue;
    }
    if (touch.link != RoverLink::kArm || touch.impulse_G.isZero(0.0)) continue;
    const Eigen::Vector3d force_G = touch.impulse_G / dt_s;
    contact_.total_G += force_G;
    ++contact_.points;
    if (touch.on_face) contact_.face_G += force_G;
  }
  arm_force_peak_n_ = std::max(arm_force_peak_n_, contact_.total_G.norm());
  rock_force_peak_n_ = std::max(rock_force_peak_n_, rock_force_G_.norm());
}

}  // namespace dockyard::axel
