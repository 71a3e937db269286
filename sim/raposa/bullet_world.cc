#include "sim/raposa/bullet_world.h"

#include <algorithm>

#include "sim/raposa/mating_shapes.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard::raposa {
namespace {

// Of Bullet's contacts in a step; its default is 10. Assumed, 30-100.
constexpr int kSolverSweeps = 50;
// A sweep that changes no velocity at a contact by more is the last. Numerical: a nanometre in a
// step of 1 ms.
constexpr double kSettled_m_s = 1e-6;
// Balls round the bodies are so far apart that no contact can be near: 20 mm is the way at which
// Bullet drops one, 1 mm the way of a fast robot in a step.
constexpr double kApart_m = 0.05;
// Contacts that are further open do nothing in a step, unless the bodies meet at 0.5 m/s.
constexpr double kNear_m = 5e-4;
// A point that was so near in the step before is the same: it starts with the impulse of then.
// Numerical, 0.5-5 mm.
constexpr double kSame_m = 2e-3;

}  // namespace

BulletWorld::Ball BulletWorld::BallOf(const btCollisionObject& object) {
  Ball ball{.object = &object};
  object.getCollisionShape()->getBoundingSphere(ball.center, ball.radius);
  return ball;
}

void BulletWorld::SearchedWorld::performDiscreteCollisionDetection() {
  btMultiBodyDynamicsWorld::performDiscreteCollisionDetection();
  owner->MeetSocket();
}

BulletWorld::BulletWorld(RobotBody& robot, PyramidBody& pyramid, const RobotModel& robot_model,
                         const PyramidModel& pyramid_model, const Eigen::Vector3d& gravity_G,
                         bool search_always)
    : dispatcher_(&configuration_),
      solver_(kSettled_m_s),
      world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
      robot_body_(robot),
      pyramid_body_(pyramid),
      robot_(*robot.multibody()),
      pyramid_(*pyramid.body()),
      X_RC_(SocketAxis(robot_model.socket)),
      socket_friction_(robot_model.socket.friction),
      socket_(SocketContacts(robot_model, pyramid_model)),
      pyramid_ball_(BallOf(pyramid_)),
      search_always_(search_always) {
  world_.owner = this;
  world_.getSimulationIslandManager()->setSplitIslands(false);
  world_.setGravity(ToBullet(gravity_G));
  world_.getSolverInfo().m_numIterations = kSolverSweeps;
  const int robot_group = 1, pyramid_group = 2;
  world_.addMultiBody(&robot_);
  for (int i = 0; i < kRobotLinkCount; ++i) {
    btCollisionObject* link = robot.collider(static_cast<RobotLink>(i));
    world_.addCollisionObject(link, robot_group, pyramid_group);
    robot_balls_[static_cast<std::size_t>(i)] = BallOf(*link);
  }
  pyramid_.setContactProcessingThreshold(kNear_m);
  world_.addRigidBody(&pyramid_, pyramid_group, robot_group);
  // The body's ball is to hold the socket, which is none of its shapes.
  Ball& body = robot_balls_[static_cast<std::size_t>(RobotLink::kBody)];
  const Pose3 X_GC = robot.motion(RobotLink::kBody).X_GL * X_RC_;
  const btVector3 socket = body.object->getWorldTransform().inverse() * ToBullet(X_GC.p);
  body.radius = std::max(body.radius, (socket - body.center).length() + socket_.reach_m());
}

bool BulletWorld::AreApart() const {
  if (search_always_ || dispatcher_.getNumManifolds() > 0) return false;
  const auto middle = [](const Ball& ball) {
    return ball.object->getWorldTransform() * ball.center;
  };
  const btVector3 pyramid = middle(pyramid_ball_);
  for (const Ball& link : robot_balls_) {
    const btScalar least = link.radius + pyramid_ball_.radius + kApart_m;
    if (middle(link).distance2(pyramid) < least * least) return false;
  }
  return true;
}

// What Bullet does with bodies that meet nothing, in its order.
void BulletWorld::StepApart(double dt_s) {
  const btVector3 gravity = world_.getGravity();
  robot_.addBaseForce(gravity * robot_.getBaseMass());
  for (int i = 0; i < robot_.getNumLinks(); ++i) {
    robot_.addLinkForce(i, gravity * robot_.getLinkMass(i));
  }
  numbers_.resize(robot_.getNumLinks() + 1);
  vectors_.resize(robot_.getNumLinks() + 1);
  matrices_.resize(robot_.getNumLinks() + 1);
  const bool constraint_pass = false, in_world = false, in_joint = false;
  // Adds them to the speeds as well.
  robot_.computeAccelerationsArticulatedBodyAlgorithmMultiDof(dt_s, numbers_, vectors_, matrices_,
                                                              constraint_pass, in_world, in_joint);
  robot_.stepPositionsMultiDof(dt_s);
  robot_.updateCollisionObjectWorldTransforms(turns_, vectors_);
  robot_.clearForcesAndTorques();

  pyramid_.applyGravity();
  const btVector3 turn = pyramid_.computeGyroscopicImpulseImplicit_Body(dt_s);
  pyramid_.integrateVelocities(dt_s);
  pyramid_.setAngularVelocity(pyramid_.getAngularVelocity() + turn);
  btTransform next;
  pyramid_.predictIntegratedTransform(dt_s, next);
  pyramid_.proceedToTransform(next);
  pyramid_.clearForces();
}

BulletWorld::SocketPair& BulletWorld::PairOf(int pair) {
  for (SocketPair& known : pairs_) {
    if (known.pair == pair) return known;
  }
  btCollisionObject* body = robot_body_.collider(RobotLink::kBody);
  pairs_.push_back({pair, dispatcher_.getNewManifold(body, &pyramid_), false});
  return pairs_.back();
}

/// Gives Bullet the contacts of pyramid and socket.
void BulletWorld::MeetSocket() {
  const Pose3& X_GR = robot_body_.motion(RobotLink::kBody).X_GL;
  const Pose3& X_GP = pyramid_body_.motion().X_GL;
  socket_.Find(X_GR * X_RC_, X_GP, kNear_m, contacts_);
  for (SocketPair& known : pairs_) known.found = false;
  const btTransform X_AG = robot_body_.collider(RobotLink::kBody)->getWorldTransform().inverse();
  const btTransform X_BG = pyramid_.getWorldTransform().inverse();
  for (std::size_t i = 0; i < contacts_.size();) {
    SocketPair& pair = PairOf(contacts_[i].pair);
    pair.found = true;
    std::array<btManifoldPoint, MANIFOLD_CACHE_SIZE> before;
    const int known = pair.manifold->getNumContacts();
    for (int k = 0; k < known; ++k)
      before[static_cast<std::size_t>(k)] = pair.manifold->getContactPoint(k);
    pair.manifold->clearManifold();
    for (; i < contacts_.size() && contacts_[i].pair == pair.pair; ++i) {
      const BoreContact& contact = contacts_[i];
      const btVector3 on_pyramid = ToBullet(contact.p),
                      normal = ToBullet(Eigen::Vector3d(-contact.normal));
      const btVector3 on_wall = on_pyramid + contact.gap_m * normal;
      btManifoldPoint point(X_AG * on_wall, X_BG * on_pyramid, normal, contact.gap_m);
      point.m_positionWorldOnA = on_wall;
      point.m_positionWorldOnB = on_pyramid;
      point.m_combinedFriction = socket_friction_;
      double nearest_m2 = kSame_m * kSame_m;
      for (int k = 0; k < known; ++k) {
        const btManifoldPoint& old = before[static_cast<std::size_t>(k)];
        const double m2 = old.m_localPointB.distance2(point.m_localPointB);
        if (m2 >= nearest_m2) continue;
        nearest_m2 = m2;
        point.m_appliedImpulse = old.m_appliedImpulse;
      }
      pair.manifold->addManifoldPoint(point);
    }
  }
  const auto lost = std::stable_partition(pairs_.begin(), pairs_.end(),
                                          [](const SocketPair& known) { return known.found; });
  for (auto pair = lost; pair != pairs_.end(); ++pair) dispatcher_.releaseManifold(pair->manifold);
  pairs_.erase(lost, pairs_.end());
}

void BulletWorld::Step(double dt_s) {
  contact_n_ = 0.0;
  if (AreApart()) return StepApart(dt_s);
  world_.stepSimulation(dt_s, 0);
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
    for (int j = 0; j < manifold->getNumContacts(); ++j) {
      contact_n_ += manifold->getContactPoint(j).getAppliedImpulse() / dt_s;
    }
  }
}

}  // namespace dockyard::raposa
