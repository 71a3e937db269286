#include "sim/raposa/mating_contacts.h"

#include <algorithm>

#include "sim/raposa/mating_shapes.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard::raposa {
namespace {

// Balls round the bodies are so far apart that no contact can be near: 20 mm is the way at which
// Bullet drops one, 1 mm the way of a fast robot in a step.
constexpr double kApart_m = 0.05;
// Contacts that are further open do nothing in a step, unless the bodies meet at 0.5 m/s.
constexpr double kNear_m = 5e-4;
// A point that was so near in the step before is the same: it goes on with what it bore then.
// Numerical, 0.5-5 mm.
constexpr double kSame_m = 2e-3;
// Pairs of pieces have numbers from here on, edges and surfaces of the socket those below.
constexpr std::int64_t kFirstPiece = 1 << 30;
constexpr int kRobotGroup = 1, kPyramidGroup = 2;

}  // namespace

void MatingContacts::Part::Take(const std::vector<Collision>& pieces) {
  for (const Collision& piece : pieces) shape.Add(piece, Pose3{});
  object.setCollisionShape(shape.compound());
  object.setCollisionFlags(0);  // it moves
  object.setActivationState(DISABLE_DEACTIVATION);
  if (pieces.empty()) return;
  btVector3 centre;
  btScalar radius = 0.0;
  shape.compound()->getBoundingSphere(centre, radius);
  ball = {FromBullet(centre), radius};
}

MatingContacts::MatingContacts(const RobotModel& robot, const PyramidModel& pyramid,
                               bool search_always)
    : search_always_(search_always),
      X_RC_(SocketAxis(robot.socket)),
      socket_(SocketContacts(robot, pyramid)),
      dispatcher_(&configuration_),
      search_(&dispatcher_, &broadphase_, &configuration_) {
  for (const RobotLink link : {kBody, kArm, kLeftDoor, kRightDoor}) {
    Part& part = links_[link];
    part.Take(PiecesOf(robot, link));
    part.object.setUserIndex(link);
    materials_[link] = link < kLeftDoor ? robot.socket.contact : robot.doors.contact;
    search_.addCollisionObject(&part.object, kRobotGroup, kPyramidGroup);
  }
  // The body's ball is to hold the socket, which is none of its pieces.
  Ball& body = links_[kBody].ball;
  body.radius_m = std::max(body.radius_m, (X_RC_.p - body.centre).norm() + socket_.reach_m());
  std::vector<Collision> pieces = GuidePieces(pyramid);
  pieces.insert(pieces.end(), pyramid.body.collisions.begin(), pyramid.body.collisions.end());
  pyramid_.Take(pieces);
  search_.addCollisionObject(&pyramid_.object, kPyramidGroup, kRobotGroup);
}

MatingContacts::~MatingContacts() {
  for (Part& part : links_) search_.removeCollisionObject(&part.object);
  search_.removeCollisionObject(&pyramid_.object);
}

bool MatingContacts::AreApart(const RigidWorld& world) const {
  if (search_always_) return false;
  const Eigen::Vector3d pyramid_G = world.body(kPyramid).motion(0).X_GL * pyramid_.ball.centre;
  for (int i = 0; i < kRobotLinkCount; ++i) {
    const Ball& ball = links_[static_cast<std::size_t>(i)].ball;
    const Eigen::Vector3d link_G = world.body(kRobot).motion(i).X_GL * ball.centre;
    const double least_m = ball.radius_m + pyramid_.ball.radius_m + kApart_m;
    if (ball.radius_m > 0.0 && (link_G - pyramid_G).squaredNorm() < least_m * least_m) return false;
  }
  return true;
}

void MatingContacts::FindInSocket(RigidWorld& world) {
  const Pose3& X_GR = world.body(kRobot).motion(kBody).X_GL;
  socket_.Find(X_GR * X_RC_, world.body(kPyramid).motion(0).X_GL, kNear_m, in_socket_);
  for (const BoreContact& contact : in_socket_) {
    world.AddContact({.a = {kPyramid, 0},
                      .b = {kRobot, kBody},
                      .pair = contact.pair,
                      .p_G = contact.p,
                      .normal_G = contact.normal,
                      .gap_m = contact.gap_m,
                      .share = contact.share,
                      .material = materials_[kBody],
                      .same_within_m = kSame_m});
  }
}

void MatingContacts::FindPieces(RigidWorld& world) {
  for (int i = 0; i < kRobotLinkCount; ++i) {
    links_[static_cast<std::size_t>(i)].object.setWorldTransform(
        ToBullet(world.body(kRobot).motion(i).X_GL));
  }
  pyramid_.object.setWorldTransform(ToBullet(world.body(kPyramid).motion(0).X_GL));
  search_.performDiscreteCollisionDetection();
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
    const bool pyramid_first = manifold.getBody0() == &pyramid_.object;
    const int link = (pyramid_first ? manifold.getBody1() : manifold.getBody0())->getUserIndex();
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      if (point.getDistance() > kNear_m) continue;
      const Eigen::Vector3d from_second = FromBullet(point.m_normalWorldOnB);
      world.AddContact({.a = {kPyramid, 0},
                        .b = {kRobot, link},
                        .pair = kFirstPiece + (std::int64_t{point.m_index0} << 16) + point.m_index1,
                        .p_G = FromBullet(pyramid_first ? point.getPositionWorldOnA()
                                                        : point.getPositionWorldOnB()),
                        .normal_G = pyramid_first ? from_second : Eigen::Vector3d(-from_second),
                        .gap_m = point.getDistance(),
                        .material = materials_[static_cast<std::size_t>(link)],
                        .same_within_m = kSame_m});
    }
  }
}

void MatingContacts::Find(RigidWorld& world) {
  if (AreApart(world)) return;
  FindInSocket(world);
  FindPieces(world);
}

}  // namespace dockyard::raposa
