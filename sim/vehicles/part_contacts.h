// Convex parts of robots, stones and other bodies, and where they press on each other. All pairs
// that may meet are searched (near_parts.h); contacts of near ones are found exactly, those with a
// body that has dents at points of the other part.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "models/parts/contact_material.h"
#include "models/parts/wheel.h"
#include "sim/rigid/body_contact.h"
#include "sim/rigid/near_parts.h"
#include "sim/rigid/rigid_world.h"
#include "sim/rigid/star_body.h"

namespace dockyard {

/// A convex part of a link.
struct SolidPart {
  BodyLink at{};  // body -1: what does not move; its link's frame is Place's
  ConvexBody body_L{};
  std::optional<WheelModel> wheel{};  // then the part is a wheel about y of the link, in body_L
  // Then the part is this body, which may have dents; body_L has its vertices.
  std::shared_ptr<const StarBody> star{};
  // A bar or a box. Two of them meet by edges anywhere on both; a plate or a stone meets others by
  // the plate's edges and the stone's corners.
  bool is_bar = false;
  // Of contacts with parts that were added later.
  ContactMaterial material{};
  PartGroups groups{};
};

class PartContacts {
 public:
  /// The world must outlive this.
  explicit PartContacts(RigidWorld& world);

  /// Returns the number. A wheel meets only parts that were added later and are no wheels; a body
  /// with dents only those that were added before.
  int Add(const SolidPart& part);
  const SolidPart& part(int i) const { return parts_[static_cast<std::size_t>(i)]; }
  int count() const { return static_cast<int>(parts_.size()); }
  /// Where a part is that does not move of itself.
  void Place(int part, const Pose3& X_GL);

  /// Adds all contacts of the next step to the world. A body that moves wakes one that sleeps.
  void AddContacts();

  /// A contact of the last step by its number in the world; on part a, by part b.
  struct Met {
    int contact = 0, a = 0, b = 0;
  };
  const std::vector<Met>& met() const { return met_; }

 private:
  bool Moves(const SolidPart& part) const {
    return part.at.body >= 0 && !world_.asleep(part.at.body);
  }
  void AddPair(const NearPair& pair);
  void FindOnStar(const NearPair& pair, const Pose3& X_BA);

  RigidWorld& world_;
  NearParts near_;
  std::vector<SolidPart> parts_;
  std::vector<Pose3> X_GL_;
  std::vector<std::vector<Eigen::Vector3d>>
      points_L_;  // of parts that came near to a body with dents
  std::vector<BodyContact> found_;
  std::vector<Met> met_;
};

/// The hull that holds a wheel with its paddles.
ConvexBody WheelHull(const WheelModel& wheel);
/// A boulder as a part that does not move, in G.
SolidPart BoulderPart(const StarBody& boulder_G, const PartGroups& groups);

}  // namespace dockyard
