#include "sim/axel/rover_body.h"
#include "sim/axel/cone_shapes.h"

#include <algorithm>

#include "controller/io/sensors.h"
#include "sim/base/hash.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard::axel {
namespace {

double RotorInertia(const RoverModel& rover, Motor motor) {
  return rover.motors[static_cast<int>(motor)].reflected_inertia_kg_m2;
}

// Half the diagonal of the box round a shape, from its compound's origin.
double Reach(btCompoundShape* shape) {
  if (shape->getNumChildShapes() == 0) return 0.0;
  btVector3 low, high;
  shape->getAabb(btTransform::getIdentity(), low, high);
  return std::max(low.length(), high.length());
}

}  // namespace

const LinkModel& LinkOf(const RoverModel& rover, RoverLink link) {
  switch (link) {
    case RoverLink::kBody:
      return rover.body;
    case RoverLink::kLeftWheel:
      return rover.left_wheel;
    case RoverLink::kRightWheel:
      return rover.right_wheel;
    case RoverLink::kArm:
      return rover.arm;
  }
  return rover.body;
}

RoverBody::RoverBody(const RoverModel& rover, const Pose3& X_GR, double arm_rad, bool right_first) {
  bullet_index_ = {-1, right_first ? 1 : 0, right_first ? 0 : 1, 2};
  p_R_hinge_ = {Eigen::Vector3d::Zero(), rover.p_R_left_wheel, rover.p_R_right_wheel,
                Eigen::Vector3d::Zero()};
  for (int i = 0; i < kRoverLinkCount; ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    inertia_[i] = FindPrincipalInertia(LinkOf(rover, link));
    mass_kg_[i] = LinkOf(rover, link).mass_kg;
  }
  rotor_kg_m2_[Index(RoverLink::kLeftWheel)] = RotorInertia(rover, Motor::kLeftWheel);
  rotor_kg_m2_[Index(RoverLink::kRightWheel)] = RotorInertia(rover, Motor::kRightWheel);
  rotor_kg_m2_[Index(RoverLink::kArm)] = RotorInertia(rover, Motor::kArm);
  const bool fixed_base = false, can_sleep = false;
  multibody_ = std::make_unique<btMultiBody>(kRoverLinkCount - 1, rover.body.mass_kg,
                                             ToBullet(inertia_[0].moments), fixed_base, can_sleep);
  const RoverLink first = right_first ? RoverLink::kRightWheel : RoverLink::kLeftWheel;
  const RoverLink second = right_first ? RoverLink::kLeftWheel : RoverLink::kRightWheel;
  AddHinge(rover, first);
  AddHinge(rover, second);
  AddHinge(rover, RoverLink::kArm);
  multibody_->finalizeMultiDof();
  // Nothing but the loads given acts: Bullet's own damping and limits are taken away.
  multibody_->setLinearDamping(0.0);
  multibody_->setAngularDamping(0.0);
  multibody_->setMaxAppliedImpulse(1e18);
  multibody_->setMaxCoordinateVelocity(1e9);
  multibody_->setHasSelfCollision(false);
  multibody_->useRK4Integration(false);
  const Pose3 X_GP = X_GR * inertia_[0].X_LP;
  multibody_->setBasePos(ToBullet(X_GP.p));
  multibody_->setWorldToBaseRot(ToQuaternion(X_GP.R.transpose()));
  multibody_->setJointPos(BulletIndex(RoverLink::kArm), arm_rad);

  AddCollider(RoverLink::kBody, rover.body.collisions);
  AddCollider(first, LinkOf(rover, first).collisions);
  AddCollider(second, LinkOf(rover, second).collisions);
  arm_parts_ = ArmCollisions(rover);
  AddCollider(RoverLink::kArm, arm_parts_);
  for (int i = 0; i < kRoverLinkCount; ++i) {
    reach_m_ = std::max(
        reach_m_, p_R_hinge_[i].norm() + inertia_[i].X_LP.p.norm() + Reach(shapes_[i].compound()));
  }
  Refresh();
}

void RoverBody::AddHinge(const RoverModel& rover, RoverLink link) {
  const PrincipalInertia& parent = inertia_[0];
  const PrincipalInertia& own = inertia_[Index(link)];
  const Eigen::Matrix3d R_own_parent = own.X_LP.R.transpose() * parent.X_LP.R;
  const Eigen::Vector3d axis = own.X_LP.R.transpose() * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d to_hinge =
      parent.X_LP.R.transpose() * (p_R_hinge_[Index(link)] - parent.X_LP.p);
  const Eigen::Vector3d to_com = own.X_LP.R.transpose() * own.X_LP.p;
  multibody_->setupRevolute(BulletIndex(link), LinkOf(rover, link).mass_kg, ToBullet(own.moments),
                            -1, ToQuaternion(R_own_parent), ToBullet(axis), ToBullet(to_hinge),
                            ToBullet(to_com), true);
}

void RoverBody::AddCollider(RoverLink link, const std::vector<Collision>& collisions) {
  const int i = Index(link);
  for (const Collision& collision : collisions) {
    shapes_[i].Add(collision, Inverse(inertia_[i].X_LP));
  }
  colliders_[i] = std::make_unique<btMultiBodyLinkCollider>(multibody_.get(), BulletIndex(link));
  colliders_[i]->setCollisionShape(shapes_[i].compound());
  if (link == RoverLink::kBody) {
    multibody_->setBaseCollider(colliders_[i].get());
  } else {
    multibody_->getLink(BulletIndex(link)).m_collider = colliders_[i].get();
  }
}

void RoverBody::AddForce(RoverLink link, const Eigen::Vector3d& force_G,
                         const Eigen::Vector3d& p_G) {
  loads_.head<3>() += force_G;
  loads_.segment<3>(3) += (p_G - motion_[0].X_GL.p).cross(force_G);
  if (link == RoverLink::kBody) return;
  const Eigen::Vector3d y_G = motion_[0].X_GL.R.col(1);
  loads_[5 + Index(link)] += y_G.dot((p_G - motion_[Index(link)].X_GL.p).cross(force_G));
}

void RoverBody::AddTorque(RoverLink link, const Eigen::Vector3d& torque_G) {
  loads_.segment<3>(3) += torque_G;
  if (link != RoverLink::kBody) loads_[5 + Index(link)] += motion_[0].X_GL.R.col(1).dot(torque_G);
}

void RoverBody::AddJointTorque(RoverLink link, double torque_nm) {
  loads_[5 + Index(link)] += torque_nm;
}

RoverBody::LinkInertias RoverBody::InertiasInG() const {
  LinkInertias all;
  for (int i = 0; i < kRoverLinkCount; ++i) {
    const Eigen::Matrix3d R_GP = motion_[i].X_GL.R * inertia_[i].X_LP.R;
    all[i] = R_GP * inertia_[i].moments.asDiagonal() * R_GP.transpose();
  }
  return all;
}

// Newton's and Euler's laws for each link, projected on the speeds (Kane): M dv/dt = loads - what
// the links' accelerations take that come of the speeds alone.
void RoverBody::TakeLoads(const Eigen::Vector3d& gravity_G, double step_s) {
  const Eigen::Vector3d w_GR = motion_[0].w_GL_G, y_G = motion_[0].X_GL.R.col(1);
  const LinkInertias inertias = InertiasInG();
  for (int i = 0; i < kRoverLinkCount; ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    const Eigen::Vector3d w = motion_[i].w_GL_G, com_G = CentreOfMass(link);
    const Eigen::Vector3d to_hinge = motion_[i].X_GL.p - motion_[0].X_GL.p;
    const Eigen::Vector3d to_com = com_G - motion_[i].X_GL.p;
    const Eigen::Vector3d turn =
        i == 0 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(joint_rad_s(link) * w_GR.cross(y_G));
    const Eigen::Vector3d acceleration =
        w_GR.cross(w_GR.cross(to_hinge)) + turn.cross(to_com) + w.cross(w.cross(to_com));
    const Eigen::Matrix3d& I_G = inertias[i];
    AddForce(link, mass_kg_[i] * (gravity_G - acceleration), com_G);
    AddTorque(link, -(I_G * turn + w.cross(I_G * w)));
  }
  mass_.compute(MassMatrix(inertias));
  AddSpeeds(step_s * mass_.solve(loads_));
  loads_.setZero();
  // Bullet's speed is that of the body's centre of mass, which goes round the axle's middle.
  const Eigen::Vector3d to_com = CentreOfMass(RoverLink::kBody) - motion_[0].X_GL.p;
  multibody_->setBaseVel(multibody_->getBaseVel() +
                         ToBullet(Eigen::Vector3d(step_s * w_GR.cross(w_GR.cross(to_com)))));
}

void RoverBody::Move(double step_s) { multibody_->stepPositionsMultiDof(step_s); }

RoverBody::Inertia RoverBody::MassMatrix(const LinkInertias& inertias) const {
  Inertia M = Inertia::Zero();
  const Eigen::Vector3d y_G = motion_[0].X_GL.R.col(1);
  for (int i = 0; i < kRoverLinkCount; ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    const double m = mass_kg_[i];
    const Eigen::Vector3d com_G = CentreOfMass(link), r = com_G - motion_[0].X_GL.p;
    const Eigen::Matrix3d& I_G = inertias[i];
    const Eigen::Matrix3d r_cross = CrossMatrix(r);
    M.topLeftCorner<3, 3>().diagonal().array() += m;
    M.block<3, 3>(0, 3) -= m * r_cross;
    M.block<3, 3>(3, 3) += I_G - m * r_cross * r_cross;
    if (i == 0) continue;
    const int joint = 5 + i;  // left wheel, right wheel, arm
    const Eigen::Vector3d v = y_G.cross(com_G - motion_[i].X_GL.p), L = I_G * y_G;
    M.block<3, 1>(0, joint) = m * v;
    M.block<3, 1>(3, joint) = L + m * r.cross(v);
    M(joint, joint) = y_G.dot(L) + m * v.squaredNorm() + rotor_kg_m2_[i];
  }
  M.triangularView<Eigen::StrictlyLower>() = M.transpose();
  return M;
}

Eigen::Matrix<double, 3, RoverBody::kSpeeds> RoverBody::PointJacobian(
    RoverLink link, const Eigen::Vector3d& p_G) const {
  Eigen::Matrix<double, 3, kSpeeds> J = Eigen::Matrix<double, 3, kSpeeds>::Zero();
  J.leftCols<3>().setIdentity();
  J.block<3, 3>(0, 3) = -CrossMatrix(p_G - motion_[0].X_GL.p);
  if (link != RoverLink::kBody) {
    const Eigen::Vector3d y_G = motion_[0].X_GL.R.col(1);
    J.col(5 + Index(link)) = y_G.cross(p_G - motion_[Index(link)].X_GL.p);
  }
  return J;
}

void RoverBody::AddSpeeds(const Speeds& change) {
  const Eigen::Vector3d w = change.segment<3>(3);
  const Eigen::Vector3d v_com =
      change.head<3>() + w.cross(CentreOfMass(RoverLink::kBody) - motion_[0].X_GL.p);
  multibody_->setBaseVel(multibody_->getBaseVel() + ToBullet(v_com));
  multibody_->setBaseOmega(multibody_->getBaseOmega() + ToBullet(w));
  for (int i = 1; i < kRoverLinkCount; ++i) {
    const int link = bullet_index_[i];
    multibody_->setJointVel(link, multibody_->getJointVel(link) + change[5 + i]);
  }
}

void RoverBody::Refresh() {
  const Pose3 X_GP = {FromBullet(btMatrix3x3(multibody_->getWorldToBaseRot().inverse())),
                      FromBullet(multibody_->getBasePos())};
  LinkMotion& body = motion_[0];
  body.X_GL.R = X_GP.R * inertia_[0].X_LP.R.transpose();
  body.X_GL.p = X_GP.p - body.X_GL.R * inertia_[0].X_LP.p;
  body.w_GL_G = FromBullet(multibody_->getBaseOmega());
  body.v_GL_G = FromBullet(multibody_->getBaseVel()) + body.w_GL_G.cross(body.X_GL.p - X_GP.p);
  const Eigen::Vector3d y_G = body.X_GL.R.col(1);
  for (int i = 1; i < kRoverLinkCount; ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    LinkMotion& own = motion_[i];
    own.X_GL.R = body.X_GL.R * RotY(joint_rad(link));
    own.X_GL.p = body.X_GL * p_R_hinge_[i];
    own.w_GL_G = body.w_GL_G + joint_rad_s(link) * y_G;
    own.v_GL_G = body.VelocityAt(own.X_GL.p);
  }
  for (int i = 0; i < kRoverLinkCount; ++i) {
    com_G_[i] = motion_[i].X_GL.R * inertia_[i].X_LP.p + motion_[i].X_GL.p;
  }
}

std::uint64_t RoverBody::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  const btQuaternion q = multibody_->getWorldToBaseRot();
  for (double value : {q.x(), q.y(), q.z(), q.w()}) hash = HashDouble(hash, value);
  const btVector3 p = multibody_->getBasePos(), v = multibody_->getBaseVel(),
                  w = multibody_->getBaseOmega();
  for (int i = 0; i < 3; ++i) {
    for (double value : {p[i], v[i], w[i]}) hash = HashDouble(hash, value);
  }
  for (RoverLink link : {RoverLink::kLeftWheel, RoverLink::kRightWheel, RoverLink::kArm}) {
    hash = HashDouble(HashDouble(hash, joint_rad(link)), joint_rad_s(link));
  }
  return hash;
}

}  // namespace dockyard::axel
