#include "sim/rigid/tree_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <stdexcept>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// R turned about the axes that it turns to.
Matrix3d Turned(const Matrix3d& R, const Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return R;
  const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, turn / angle) * Eigen::Quaterniond(R));
  return q.normalized().toRotationMatrix();
}

// Of each speed the next joint's inwards; -1: none.
std::vector<int> JointsInwards(const std::vector<TreeLink>& links,
                               const std::vector<Eigen::Index>& speed_of, Eigen::Index speeds) {
  std::vector<int> inwards(static_cast<std::size_t>(speeds), -1);
  for (std::size_t i = 1; i < links.size(); ++i) {
    if (speed_of[i] < 0) continue;
    auto at = static_cast<std::size_t>(links[i].parent);
    while (at > 0 && speed_of[at] < 0) at = static_cast<std::size_t>(links[at].parent);
    inwards[static_cast<std::size_t>(speed_of[i])] = static_cast<int>(speed_of[at]);
  }
  return inwards;
}

}  // namespace

TreeBody::TreeBody(std::vector<TreeLink> links, std::vector<JointTie> ties, const Pose3& X_GB,
                   const TreeRules& rules)
    : links_(std::move(links)), rules_(rules), X_GB_(X_GB), factor_(0, {}) {
  flies_alone_ = links_.size() == 1 && rules.base == TreeBase::kFree;
  const std::size_t count = links_.size();
  DOCKYARD_CHECK(count > 0 && links_[0].parent == -1);
  Eigen::Index speeds = rules.base == TreeBase::kFree ? 6 : 0;
  for (std::size_t i = 0; i < count; ++i) {
    DOCKYARD_CHECK(links_[i].model.mass_kg > 0.0);
    DOCKYARD_CHECK(i == 0 || (links_[i].parent >= 0 && Place(links_[i].parent) < i));
    mass_kg_ += links_[i].model.mass_kg;
    const bool moves = i > 0 && links_[i].joint != JointKind::kFixed;
    speed_of_.push_back(moves ? speeds++ : -1);
    turned_.push_back(!links_[i].R_PL.isIdentity(0.0));
  }
  if (speeds > kMostSpeeds || count > kMostLinks) {
    throw std::invalid_argument("a tree has too many links");
  }
  motion_.resize(count);
  com_G_.resize(count);
  axis_G_.resize(count);
  inertia_G_.resize(count);
  angle_rad_.assign(count, 0.0);
  loads_.assign(count, {Vector3d::Zero(), Vector3d::Zero()});
  joint_loads_nm_.assign(count, 0.0);
  speeds_.setZero(speeds);
  loaded_ = resisted_ = speeds_;
  ties_.setZero(static_cast<Eigen::Index>(ties.size()), speeds);
  for (std::size_t row = 0; row < ties.size(); ++row) {
    for (const auto& [link, weight] : ties[row]) {
      DOCKYARD_CHECK(link > 0 && Place(link) < count && SpeedOf(link) >= 0);
      ties_(static_cast<Eigen::Index>(row), SpeedOf(link)) = weight;
    }
  }
  factor_ =
      TreeFactor(rules.base == TreeBase::kFree ? 6 : 0, JointsInwards(links_, speed_of_, speeds));
  inverse_L_ = InverseOf(SymmetricOf(links_[0].model.I_LCom_L));
  RefreshPlaces();
  RefreshSpeeds();
}

void TreeBody::SetAngle(int i, double angle_rad) {
  angle_rad_[Place(i)] = angle_rad;
  RefreshPlaces();
  RefreshSpeeds();
}

// Places and inertias of all links, from the base outwards.
void TreeBody::RefreshPlaces() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TreeLink& link = links_[i];
    Pose3& own = motion_[i].X_GL;
    if (i == 0) {
      own = X_GB_;
    } else {
      const Pose3& parent = motion_[Place(link.parent)].X_GL;
      own.R = parent.R;
      if (turned_[i]) own.R = parent.R * link.R_PL;
      axis_G_[i] = own.R.lazyProduct(link.axis_L);
      own.p = parent.R.lazyProduct(link.p_PL) + parent.p;
      if (link.joint == JointKind::kSlide) own.p += angle_rad_[i] * axis_G_[i];
      if (link.joint == JointKind::kHinge) {
        own.R *= Eigen::AngleAxisd(angle_rad_[i], link.axis_L).toRotationMatrix();
      }
    }
    com_G_[i] = own.R.lazyProduct(link.model.p_LoCom_L) + own.p;
    inertia_G_[i] = TurnedTensor(own.R, link.model.I_LCom_L);
  }
}

void TreeBody::RefreshSpeeds() {
  if (rules_.base == TreeBase::kFree) {
    LinkMotion& base = motion_[0];
    base.w_GL_G = speeds_.segment<3>(3);
    base.v_GL_G = speeds_.head<3>() + base.w_GL_G.cross(base.X_GL.p - com_G_[0]);
  }
  for (std::size_t i = 1; i < links_.size(); ++i) {
    const TreeLink& link = links_[i];
    const LinkMotion& parent = motion_[Place(link.parent)];
    LinkMotion& own = motion_[i];
    own.w_GL_G = parent.w_GL_G;
    own.v_GL_G = parent.VelocityAt(own.X_GL.p);
    if (link.joint == JointKind::kHinge) own.w_GL_G += speeds_[speed_of_[i]] * axis_G_[i];
    if (link.joint == JointKind::kSlide) own.v_GL_G += speeds_[speed_of_[i]] * axis_G_[i];
  }
}

void TreeBody::AddForce(int i, const Vector3d& force_G, const Vector3d& p_G) {
  loads_[Place(i)].force += force_G;
  loads_[Place(i)].torque += (p_G - Centre(i)).cross(force_G);
}

void TreeBody::AddTorque(int i, const Vector3d& torque_G) { loads_[Place(i)].torque += torque_G; }

void TreeBody::AddJointTorque(int i, double torque_nm) { joint_loads_nm_[Place(i)] += torque_nm; }

// Loads less what the links' accelerations take that come of the speeds alone, over the speeds.
TreeBody::Speeds TreeBody::CollectLoads(const Vector3d& gravity_G) {
  std::array<Wrench, kMostLinks> all;
  std::array<Vector3d, kMostLinks> turning, going;
  turning[0] = going[0] = Vector3d::Zero();
  for (std::size_t i = 0; i < links_.size(); ++i) {
    all[i] = loads_[i];
    const LinkMotion& own = motion_[i];
    const Vector3d to_com = com_G_[i] - Centre(static_cast<int>(i));
    if (i > 0) {
      const std::size_t parent = Place(links_[i].parent);
      const Vector3d r = own.X_GL.p - Centre(links_[i].parent), w = motion_[parent].w_GL_G;
      going[i] = going[parent] + turning[parent].cross(r) + w.cross(w.cross(r));
      turning[i] = turning[parent];
      if (links_[i].joint != JointKind::kFixed) {
        const Vector3d turned = w.cross(axis_G_[i]) * rate_rad_s(static_cast<int>(i));
        if (links_[i].IsHinge()) turning[i] += turned;
        if (!links_[i].IsHinge()) going[i] += 2.0 * turned;
      }
    }
    const Vector3d& w = own.w_GL_G;
    const Vector3d acceleration = going[i] + turning[i].cross(to_com) + w.cross(w.cross(to_com));
    const Vector3d force = links_[i].model.mass_kg * (gravity_G - acceleration);
    all[i].force += force;
    if (flies_alone_) continue;  // what its turning takes is in MoveBase
    all[i].torque += to_com.cross(force) - Product(inertia_G_[i], turning[i]) -
                     w.cross(Product(inertia_G_[i], w));
  }
  Speeds over_speeds = Speeds::Zero(speeds_.size());
  for (std::size_t i = links_.size() - 1; i > 0; --i) {
    if (speed_of_[i] >= 0) {
      over_speeds[speed_of_[i]] =
          links_[i].Along(axis_G_[i], all[i].force, all[i].torque) + joint_loads_nm_[i];
    }
    const std::size_t parent = Place(links_[i].parent);
    const Vector3d r = motion_[i].X_GL.p - Centre(links_[i].parent);
    all[parent].force += all[i].force;
    all[parent].torque += all[i].torque + r.cross(all[i].force);
  }
  if (rules_.base == TreeBase::kFixed) return over_speeds;
  over_speeds.head<3>() = all[0].force;
  over_speeds.segment<3>(3) = all[0].torque;
  return over_speeds;
}

void TreeBody::TakeLoads(const Vector3d& gravity_G, double step_s) {
  FindAnswers(step_s);
  const Speeds before = speeds_;
  // With those of the joints' springs and dampers, which count with the inertia, too.
  const auto Loads = [&] {
    Speeds loads = CollectLoads(gravity_G);
    for (std::size_t i = 1; i < links_.size(); ++i) {
      const double resistance = links_[i].Resistance(step_s);
      if (speed_of_[i] < 0 || resistance <= 0.0) continue;
      loads[speed_of_[i]] -= links_[i].stiffness_nm_per_rad * (angle_rad_[i] - links_[i].rest_rad) +
                             resistance * before[speed_of_[i]];
    }
    return loads;
  };
  if (rules_.terms == VelocityTerms::kMidstep) {
    AddSpeeds(0.5 * (Answer(step_s * Loads()) + resisted_));
  }
  const Speeds change = Answer(step_s * Loads());
  speeds_ = before;
  AddSpeeds(change);
  if (rules_.terms == VelocityTerms::kMidstep) loaded_ = speeds_;
  for (Wrench& load : loads_) load = {Vector3d::Zero(), Vector3d::Zero()};
  std::fill(joint_loads_nm_.begin(), joint_loads_nm_.end(), 0.0);
}

void TreeBody::Stop() {
  speeds_.setZero();
  resisted_.setZero();
  RefreshSpeeds();
}

void TreeBody::AddSpeeds(const Speeds& change) {
  speeds_ += change;
  RefreshSpeeds();
}

void TreeBody::MoveBase(double step_s) {
  const Vector3d com_G = com_G_[0] + step_s * speeds_.head<3>();
  Vector3d w_G = speeds_.segment<3>(3);
  if (flies_alone_) {
    const Vector3d spin_G = Product(inertia_G_[0], w_G);
    const auto RateAt = [&](const Matrix3d& R) {
      const Vector3d spin_L = R.transpose() * spin_G;
      return Vector3d(R * Product(inverse_L_, spin_L));
    };
    w_G = RateAt(Turned(X_GB_.R, 0.5 * step_s * w_G));
    X_GB_.R = Turned(X_GB_.R, step_s * w_G);
    speeds_.segment<3>(3) = RateAt(X_GB_.R);
  } else {
    X_GB_.R = Turned(X_GB_.R, step_s * w_G);
  }
  X_GB_.p = com_G - X_GB_.R * links_[0].model.p_LoCom_L;
}

void TreeBody::Move(double step_s) {
  if (rules_.terms == VelocityTerms::kMidstep) resisted_ = speeds_ - loaded_;
  if (rules_.base == TreeBase::kFree) MoveBase(step_s);
  for (std::size_t i = 1; i < links_.size(); ++i) {
    if (speed_of_[i] >= 0) angle_rad_[i] += step_s * speeds_[speed_of_[i]];
  }
  RefreshPlaces();
  RefreshSpeeds();
}

std::uint64_t TreeBody::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (int i = 0; i < 9; ++i) hash = HashDouble(hash, X_GB_.R(i));
  for (int i = 0; i < 3; ++i) hash = HashDouble(hash, X_GB_.p[i]);
  for (const double angle : angle_rad_) hash = HashDouble(hash, angle);
  for (const double speed : speeds_) hash = HashDouble(hash, speed);
  return hash;
}

}  // namespace dockyard
