#include "sim/axel/contact_world.h"

#include "sim/physics/bullet_math.h"

namespace dockyard::axel {
namespace {

constexpr int kRoverGroup = 1, kStationGroup = 2;
// Wheels and body against the station: painted metal on rubber or metal (assumed, range 0.3-0.6).
constexpr double kBodyFriction = 0.4;
// Collision is tested when the rover's sphere comes this near the station's [m].
constexpr double kNearM = 0.1;
// Against 300 iterations to rounding, a docking's peak force on the cone changes by 0.1 N of 349
// and its pose by less than 0.01 mm.
constexpr int kSolverIterations = 30;
// The solver stops early when a sweep changes no impulse by more than the root of this [(N s)^2]:
// 3 mN at a step of 1 ms.
constexpr double kSolvedResidual = 1e-11;
// A contact belongs to the annular face when it is this near the mouth plane and faces outwards.
constexpr double kFaceDepthM = 4e-3;
constexpr double kFaceNormal = 0.9;

bool IsOnFace(const btManifoldPoint& point, bool station_is_b, const Pose3& X_GM) {
  const Eigen::Vector3d axis_G = X_GM.R.col(0);
  const Eigen::Vector3d at_G =
      FromBullet(station_is_b ? point.getPositionWorldOnB() : point.getPositionWorldOnA());
  const double out = (station_is_b ? 1.0 : -1.0) * axis_G.dot(FromBullet(point.m_normalWorldOnB));
  return axis_G.dot(at_G - X_GM.p) > -kFaceDepthM && out > kFaceNormal;
}

}  // namespace

class ContactWorld::BulletWorld : public btMultiBodyDynamicsWorld {
 public:
  explicit BulletWorld(ContactWorld& owner)
      : btMultiBodyDynamicsWorld(&owner.dispatcher_, &owner.broadphase_, &owner.solver_,
                                 &owner.configuration_),
        owner_(owner) {}

  void performDiscreteCollisionDetection() override {
    btMultiBodyDynamicsWorld::performDiscreteCollisionDetection();
    owner_.GiveContactsTheirMaterials();
  }

 protected:
  void internalSingleStepSimulation(btScalar dt) override {
    if (owner_.MayTouch()) {
      owner_.rover_.multibody()->forwardKinematics(m_scratch_world_to_local,
                                                   m_scratch_local_origin);
      owner_.rover_.multibody()->updateCollisionObjectWorldTransforms(m_scratch_world_to_local,
                                                                      m_scratch_local_origin);
      btMultiBodyDynamicsWorld::internalSingleStepSimulation(dt);
    } else {
      IntegrateFreely(dt);
    }
  }

  void solveExternalForces(btContactSolverInfo& info) override {
    owner_.rover_.rotors().RememberSpeeds();
    btMultiBodyDynamicsWorld::solveExternalForces(info);
    owner_.rover_.rotors().TakeTheirShare();
  }

 private:
  // Bullet's step for a world without contacts.
  void IntegrateFreely(btScalar dt) {
    btMultiBody* rover = owner_.rover_.multibody();
    m_scratch_r.resize(rover->getNumLinks() + 1);
    m_scratch_v.resize(rover->getNumLinks() + 1);
    m_scratch_m.resize(rover->getNumLinks() + 1);
    owner_.rover_.rotors().RememberSpeeds();
    rover->computeAccelerationsArticulatedBodyAlgorithmMultiDof(dt, m_scratch_r, m_scratch_v,
                                                                m_scratch_m, false, false, false);
    owner_.rover_.rotors().TakeTheirShare();
    rover->stepPositionsMultiDof(dt);
    btRigidBody* station = owner_.station_.body();
    station->setLinearVelocity(station->getLinearVelocity() +
                               station->getTotalForce() * (station->getInvMass() * dt));
    station->setAngularVelocity(station->getAngularVelocity() +
                                station->getInvInertiaTensorWorld() * station->getTotalTorque() *
                                    dt +
                                station->computeGyroscopicImpulseImplicit_Body(dt));
    btTransform next;
    station->predictIntegratedTransform(dt, next);
    station->proceedToTransform(next);
  }

  ContactWorld& owner_;
};

ContactWorld::ContactWorld(const ConeModel& cone, double gravity_m_s2, RoverBody& rover,
                           StationBody& station)
    : cone_(cone),
      rover_(rover),
      station_(station),
      wedge_pairs_(station),
      dispatcher_(&configuration_) {
  dispatcher_.registerCollisionCreateFunc(COMPOUND_SHAPE_PROXYTYPE, COMPOUND_SHAPE_PROXYTYPE,
                                          &wedge_pairs_);
  world_ = std::make_unique<BulletWorld>(*this);
  world_->setGravity(btVector3(0.0, 0.0, -gravity_m_s2));
  world_->getDispatchInfo().m_deterministicOverlappingPairs = true;
  btContactSolverInfo& info = world_->getSolverInfo();
  info.m_numIterations = kSolverIterations;
  info.m_leastSquaresResidualThreshold = kSolvedResidual;
  info.m_solverMode = SOLVER_USE_WARMSTARTING | SOLVER_USE_2_FRICTION_DIRECTIONS;
  info.m_splitImpulse = false;
  info.m_restitution = 0.0;

  world_->addMultiBody(rover.multibody());
  for (int i = 0; i < kRoverLinkCount; ++i) {
    btMultiBodyLinkCollider* collider = rover.collider(static_cast<RoverLink>(i));
    collider->setActivationState(DISABLE_DEACTIVATION);
    world_->addCollisionObject(collider, kRoverGroup, kStationGroup);
  }
  for (const auto& row : rover.rotors().rows()) world_->addMultiBodyConstraint(row.get());
  world_->addRigidBody(station.body(), kStationGroup, kRoverGroup);
}

ContactWorld::~ContactWorld() {
  world_->removeRigidBody(station_.body());
  for (const auto& row : rover_.rotors().rows()) world_->removeMultiBodyConstraint(row.get());
  for (int i = 0; i < kRoverLinkCount; ++i) {
    world_->removeCollisionObject(rover_.collider(static_cast<RoverLink>(i)));
  }
  world_->removeMultiBody(rover_.multibody());
}

void ContactWorld::Step(double dt_s) {
  contact_ = ArmContact{};
  world_->stepSimulation(dt_s, 0);
  rover_.Refresh();
  station_.Refresh();
  ReadContacts(dt_s);
}

bool ContactWorld::MayTouch() const {
  const Eigen::Vector3d apart = rover_.motion(RoverLink::kBody).X_GL.p - station_.X_GM().p;
  return apart.norm() < rover_.reach_m() + station_.reach_m() + kNearM;
}

void ContactWorld::GiveContactsTheirMaterials() {
  const Pose3 X_GM = station_.X_GM();
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
    const bool station_is_b = manifold->getBody1() == station_.body();
    const void* other = station_is_b ? manifold->getBody0() : manifold->getBody1();
    const bool arm = other == rover_.collider(RoverLink::kArm);
    for (int j = manifold->getNumContacts() - 1; j >= 0; --j) {
      btManifoldPoint& point = manifold->getContactPoint(j);
      const int piece = station_is_b ? point.m_index1 : point.m_index0;
      if (arm && station_.FillsSocket(piece)) {
        manifold->removeContactPoint(j);
        continue;
      }
      if (!arm || !station_.IsWedge(piece)) {
        point.m_combinedFriction = kBodyFriction;
        continue;
      }
      const bool face = IsOnFace(point, station_is_b, X_GM);
      point.m_combinedFriction = face ? cone_.face_friction : cone_.funnel_friction;
    }
  }
}

void ContactWorld::ReadContacts(double dt_s) {
  const Pose3 X_GM = station_.X_GM();
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
    const bool arm_is_a = manifold->getBody0() == rover_.collider(RoverLink::kArm);
    const bool arm_is_b = manifold->getBody1() == rover_.collider(RoverLink::kArm);
    if (!arm_is_a && !arm_is_b) continue;
    for (int j = 0; j < manifold->getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold->getContactPoint(j);
      if (point.m_appliedImpulse == 0.0) continue;
      const btVector3 on_a = (point.m_normalWorldOnB * point.m_appliedImpulse +
                              point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1 +
                              point.m_lateralFrictionDir2 * point.m_appliedImpulseLateral2) /
                             dt_s;
      const Eigen::Vector3d force_G = (arm_is_a ? 1.0 : -1.0) * FromBullet(on_a);
      contact_.total_G += force_G;
      ++contact_.points;
      if (IsOnFace(point, arm_is_a, X_GM)) contact_.face_G += force_G;
    }
  }
}

}  // namespace dockyard::axel
