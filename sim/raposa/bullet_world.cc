#include "sim/raposa/bullet_world.h"

#include "sim/physics/bullet_math.h"

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

}  // namespace

BulletWorld::Ball BulletWorld::BallOf(const btCollisionObject& object) {
  Ball ball{.object = &object};
  object.getCollisionShape()->getBoundingSphere(ball.center, ball.radius);
  return ball;
}

BulletWorld::BulletWorld(RobotBody& robot, PyramidBody& pyramid, const Eigen::Vector3d& gravity_G,
                         bool search_always)
    : dispatcher_(&configuration_),
      solver_(kSettled_m_s),
      world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
      robot_(*robot.multibody()),
      pyramid_(*pyramid.body()),
      pyramid_ball_(BallOf(pyramid_)),
      search_always_(search_always) {
  world_.setGravity(ToBullet(gravity_G));
  world_.getSolverInfo().m_numIterations = kSolverSweeps;
  const int robot_group = 1, pyramid_group = 2;
  world_.addMultiBody(&robot_);
  for (int i = 0; i < kRobotLinkCount; ++i) {
    btCollisionObject* link = robot.collider(static_cast<RobotLink>(i));
    world_.addCollisionObject(link, robot_group, pyramid_group);
    robot_balls_[static_cast<std::size_t>(i)] = BallOf(*link);
  }
  world_.addRigidBody(&pyramid_, pyramid_group, robot_group);
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
