// Bullet's shapes of the rover's links and of the station, which its narrow phase tests.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <deque>
#include <vector>

#include "sim/axel/rover_body.h"
#include "sim/axel/station_body.h"
#include "sim/rigid/collision_shapes.h"

namespace dockyard::axel {

/// The shapes of one body, each in the frame of the body's object.
class ShapedObject {
 public:
  ShapedObject() { object_.setCollisionShape(shape_.compound()); }
  ShapedObject(const ShapedObject&) = delete;
  ShapedObject& operator=(const ShapedObject&) = delete;

  void Add(const Collision& part, const Pose3& X_BL) { shape_.Add(part, X_BL); }
  int pieces() const { return shape_.pieces(); }
  const btConvexShape& piece(int i) const;
  /// A piece in the object's frame.
  const btTransform& X_BP(int i) const { return shape_.compound()->getChildTransform(i); }
  const btTransform& X_GB() const { return object_.getWorldTransform(); }
  const btCollisionObject* object() const { return &object_; }
  void MoveTo(const Pose3& X_GB);
  /// Radius about the object's origin that holds it [m].
  double reach_m() const;

 private:
  LinkShape shape_;
  btCollisionObject object_;
};

/// A plane that bounds a piece of the station, in M: the piece lies where normal . p <= offset_m.
struct StationFace {
  btVector3 normal{0, 0, 0};
  double offset_m = 0.0;
};

class ContactShapes {
 public:
  ContactShapes(const RoverModel& rover, const StationModel& station);

  /// A link, in its frame; the station, in M.
  const ShapedObject& link(RoverLink link) const { return links_[Place(link)]; }
  const ShapedObject& station() const { return station_; }
  void MoveTo(const RoverBody& rover, const StationBody& station);
  /// Boxes about the station's pieces.
  const std::vector<StationFace>& Faces(int piece) const {
    return faces_[static_cast<std::size_t>(piece)];
  }
  /// Whether the arm meets a piece of the station elsewhere than in the mating: all but the one for
  /// the cone and those that fill its hole.
  bool MeetsArm(int piece) const { return meets_arm_[static_cast<std::size_t>(piece)]; }
  /// Distance of the axle's middle from the mouth beyond which rover and station cannot touch [m].
  double reach_m() const { return reach_m_; }

 private:
  static std::size_t Place(RoverLink link) { return static_cast<std::size_t>(link); }
  void AddFaces();

  std::deque<ShapedObject> links_;  // by RoverLink; a shape stays where it is
  ShapedObject station_;
  std::vector<bool> meets_arm_;                  // by piece
  std::vector<std::vector<StationFace>> faces_;  // by piece
  double reach_m_ = 0.0;
};

}  // namespace dockyard::axel
