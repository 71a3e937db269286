#include "sim/rigid/rigid_world.h"

#include <cmath>
#include <utility>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

}  // namespace

Matrix3d AxesAlong(const Vector3d& normal) {
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Vector3d a = normal.cross(Vector3d::Unit(least)).normalized();
  Matrix3d axes;
  axes << normal, a, normal.cross(a);
  return axes;
}

int RigidWorld::Add(TreeBody body) {
  first_.push_back(speeds_);
  speeds_ += PlacesFor(body.speeds().size());
  bodies_.push_back(std::move(body));
  asleep_.push_back(false);
  return static_cast<int>(bodies_.size()) - 1;
}

void RigidWorld::Limit(const BodyLink& joint, const JointLaw& law) { LimitBetween(joint, -1, law); }

void RigidWorld::LimitBetween(const BodyLink& joint, int other_link, const JointLaw& law) {
  DOCKYARD_CHECK(body(joint.body).SpeedOf(joint.link) >= 0);
  DOCKYARD_CHECK(other_link < 0 || body(joint.body).SpeedOf(other_link) >= 0);
  const bool stops = std::isfinite(law.low_rad) || std::isfinite(law.high_rad);
  DOCKYARD_CHECK(!stops || law.stop_nm_per_rad > 0.0);
  joints_.push_back({joint, other_link, law});
}

int RigidWorld::Add(const PointTie& tie) {
  ties_.push_back({tie});
  return static_cast<int>(ties_.size()) - 1;
}

void RigidWorld::SetAsleep(int body, bool asleep) {
  asleep_[Place(body)] = asleep;
  if (asleep) bodies_[Place(body)].Stop();
}

void RigidWorld::Step(double step_s) {
  TakeLoads(step_s);
  Resist(step_s);
  Move(step_s);
}

void RigidWorld::TakeLoads(double step_s) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!asleep_[i]) bodies_[i].TakeLoads(gravity_G_, step_s);
  }
}

void RigidWorld::Move(double step_s) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!asleep_[i]) bodies_[i].Move(step_s);
  }
}

void RigidWorld::Resist(double step_s) {
  sweeps_ = 0;
  answers_count_ = 0;
  system_.Start(speeds_, step_s, solved_);
  AddTieRows();
  for (std::size_t i = 0; i < joints_.size(); ++i) AddJointRows(i, step_s);
  AddContactRows(step_s);
  if (!system_.empty()) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      system_.speeds().segment(first_[i], bodies_[i].speeds().size()) = bodies_[i].speeds();
    }
    sweeps_ = system_.Solve();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      TreeBody& body = bodies_[i];
      const TreeBody::Speeds change =
          system_.speeds().segment(first_[i], body.speeds().size()) - body.speeds();
      if (!change.isZero(0.0)) body.AddSpeeds(change);
    }
  }
  TakeJointImpulses();
  TakeContactImpulses();
  for (const WorldContact& last : contacts_) {  // of sleepers
    if (!Moves(last.a.body) && !Moves(last.b.body)) next_contacts_.push_back(last);
  }
  std::swap(contacts_, next_contacts_);
  next_contacts_.clear();
}

std::uint64_t RigidWorld::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  const auto Add = [&](const Vector3d& v) {
    for (int i = 0; i < 3; ++i) hash = HashDouble(hash, v[i]);
  };
  for (const TreeBody& body : bodies_) hash = body.StateHash(hash);
  for (const Joint& joint : joints_) {
    for (const double impulse : {joint.rub, joint.from_low, joint.from_high}) {
      hash = HashDouble(hash, impulse);
    }
  }
  for (const Tie& tie : ties_) Add(tie.impulse_G);
  for (const WorldContact& contact : contacts_) {
    Add(contact.impulse_G);
    Add(contact.rolling_G);
    Add(contact.bend_G);
  }
  return hash;
}

}  // namespace dockyard
