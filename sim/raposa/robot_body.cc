#include "sim/raposa/robot_body.h"

#include "sim/base/hash.h"
#include "sim/raposa/mating_shapes.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard::raposa {
namespace {

const LinkModel& ModelOf(const RobotModel& robot, RobotLink link) {
  switch (link) {
    case RobotLink::kArm:
      return robot.arm;
    case RobotLink::kLeftDoor:
      return robot.left_door;
    case RobotLink::kRightDoor:
      return robot.right_door;
    case RobotLink::kBody:
      break;
  }
  return robot.body;
}

std::vector<Collision> PiecesOf(const RobotModel& robot, RobotLink link) {
  if (link == RobotLink::kLeftDoor) return DoorPieces(robot.doors, true);
  if (link == RobotLink::kRightDoor) return DoorPieces(robot.doors, false);
  return ModelOf(robot, link).collisions;
}

}  // namespace

RobotBody::RobotBody(const RobotModel& robot, const Pose3& X_GR, double arm_rad) {
  p_R_joint_ = {Eigen::Vector3d::Zero(), robot.p_R_arm, robot.p_R_doors, robot.p_R_doors};
  for (int i = 0; i < kRobotLinkCount; ++i) {
    inertia_[i] = FindPrincipalInertia(ModelOf(robot, static_cast<RobotLink>(i)));
  }
  const bool fixed_base = false, can_sleep = false;
  multibody_ = std::make_unique<btMultiBody>(kRobotLinkCount - 1, robot.body.mass_kg,
                                             ToBullet(inertia_[0].moments), fixed_base, can_sleep);
  for (int i = 1; i < kRobotLinkCount; ++i) AddJoint(robot, static_cast<RobotLink>(i));
  multibody_->finalizeMultiDof();
  multibody_->setLinearDamping(0.0);
  multibody_->setAngularDamping(0.0);
  multibody_->setMaxAppliedImpulse(1e18);
  multibody_->setMaxCoordinateVelocity(1e9);
  multibody_->setHasSelfCollision(false);
  multibody_->useRK4Integration(false);
  const Pose3 X_GP = X_GR * inertia_[0].X_LP;
  multibody_->setBasePos(ToBullet(X_GP.p));
  multibody_->setWorldToBaseRot(ToQuaternion(X_GP.R.transpose()));
  multibody_->setJointPos(Index(RobotLink::kArm) - 1, arm_rad);
  multibody_->setJointPos(Index(RobotLink::kLeftDoor) - 1, robot.doors.travel_m);
  multibody_->setJointPos(Index(RobotLink::kRightDoor) - 1, -robot.doors.travel_m);
  for (int i = 0; i < kRobotLinkCount; ++i) AddCollider(robot, static_cast<RobotLink>(i));
  btAlignedObjectArray<btQuaternion> turns;
  btAlignedObjectArray<btVector3> places;
  multibody_->forwardKinematics(turns, places);
  multibody_->updateCollisionObjectWorldTransforms(turns, places);
  Refresh();
}

void RobotBody::AddJoint(const RobotModel& robot, RobotLink link) {
  const PrincipalInertia &body = inertia_[0], &own = inertia_[Index(link)];
  const Eigen::Matrix3d R_own_body = own.X_LP.R.transpose() * body.X_LP.R;
  const Eigen::Vector3d axis = own.X_LP.R.transpose() * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d to_joint =
      body.X_LP.R.transpose() * (p_R_joint_[Index(link)] - body.X_LP.p);
  const Eigen::Vector3d to_com = own.X_LP.R.transpose() * own.X_LP.p;
  const double mass = ModelOf(robot, link).mass_kg;
  const int i = Index(link) - 1;
  const bool apart = true;  // no contact with the body
  if (link == RobotLink::kArm) {
    multibody_->setupRevolute(i, mass, ToBullet(own.moments), -1, ToQuaternion(R_own_body),
                              ToBullet(axis), ToBullet(to_joint), ToBullet(to_com), apart);
  } else {
    multibody_->setupPrismatic(i, mass, ToBullet(own.moments), -1, ToQuaternion(R_own_body),
                               ToBullet(axis), ToBullet(to_joint), ToBullet(to_com), apart);
  }
}

void RobotBody::AddCollider(const RobotModel& robot, RobotLink link) {
  const int i = Index(link);
  for (const Collision& piece : PiecesOf(robot, link)) {
    shapes_[i].Add(piece, Inverse(inertia_[i].X_LP));
  }
  colliders_[i] = std::make_unique<btMultiBodyLinkCollider>(multibody_.get(), i - 1);
  colliders_[i]->setCollisionShape(shapes_[i].compound());
  const bool door = link == RobotLink::kLeftDoor || link == RobotLink::kRightDoor;
  colliders_[i]->setFriction(door ? robot.doors.friction : robot.socket.friction);
  if (link == RobotLink::kBody) {
    multibody_->setBaseCollider(colliders_[i].get());
  } else {
    multibody_->getLink(i - 1).m_collider = colliders_[i].get();
  }
}

void RobotBody::AddLoad(RobotLink link, const Eigen::Vector3d& force_G,
                        const Eigen::Vector3d& torque_G) {
  const LinkMotion& motion = motion_[Index(link)];
  // Bullet takes loads about the centre of mass.
  const Eigen::Vector3d to_com = motion.X_GL.R * inertia_[Index(link)].X_LP.p;
  const btVector3 force = ToBullet(force_G),
                  torque = ToBullet(Eigen::Vector3d(torque_G - to_com.cross(force_G)));
  if (link == RobotLink::kBody) {
    multibody_->addBaseForce(force);
    multibody_->addBaseTorque(torque);
  } else {
    multibody_->addLinkForce(Index(link) - 1, force);
    multibody_->addLinkTorque(Index(link) - 1, torque);
  }
}

void RobotBody::AddJointLoad(RobotLink link, double load) {
  multibody_->addJointTorque(Index(link) - 1, load);
}

void RobotBody::Refresh() {
  const Pose3 X_GP = {FromBullet(btMatrix3x3(multibody_->getWorldToBaseRot().inverse())),
                      FromBullet(multibody_->getBasePos())};
  LinkMotion& body = motion_[0];
  body.X_GL.R = X_GP.R * inertia_[0].X_LP.R.transpose();
  body.X_GL.p = X_GP.p - body.X_GL.R * inertia_[0].X_LP.p;
  body.w_GL_G = FromBullet(multibody_->getBaseOmega());
  body.v_GL_G = FromBullet(multibody_->getBaseVel()) + body.w_GL_G.cross(body.X_GL.p - X_GP.p);
  const Eigen::Vector3d y_G = body.X_GL.R.col(1);
  LinkMotion& arm = motion_[Index(RobotLink::kArm)];
  arm.X_GL.R = body.X_GL.R * RotY(joint(RobotLink::kArm));
  arm.X_GL.p = body.X_GL * p_R_joint_[Index(RobotLink::kArm)];
  arm.w_GL_G = body.w_GL_G + joint_rate(RobotLink::kArm) * y_G;
  arm.v_GL_G = body.VelocityAt(arm.X_GL.p);
  for (const RobotLink door : {RobotLink::kLeftDoor, RobotLink::kRightDoor}) {
    LinkMotion& own = motion_[Index(door)];
    own.X_GL.R = body.X_GL.R;
    own.X_GL.p = body.X_GL * p_R_joint_[Index(door)] + joint(door) * y_G;
    own.w_GL_G = body.w_GL_G;
    own.v_GL_G = body.VelocityAt(own.X_GL.p) + joint_rate(door) * y_G;
  }
}

std::uint64_t RobotBody::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  const btQuaternion q = multibody_->getWorldToBaseRot();
  for (const double value : {q.x(), q.y(), q.z(), q.w()}) hash = HashDouble(hash, value);
  const btVector3 p = multibody_->getBasePos(), v = multibody_->getBaseVel(),
                  w = multibody_->getBaseOmega();
  for (int i = 0; i < 3; ++i) {
    for (const double value : {p[i], v[i], w[i]}) hash = HashDouble(hash, value);
  }
  for (int i = 1; i < kRobotLinkCount; ++i) {
    const RobotLink link = static_cast<RobotLink>(i);
    hash = HashDouble(HashDouble(hash, joint(link)), joint_rate(link));
  }
  return hash;
}

}  // namespace dockyard::raposa
