// Bodies that move under loads and touch each other and the ground. Each body is a tree of links; a
// free body is a tree of one. All contacts, ties, stops and joints' friction are solved at once,
// with the trees' own ties (tree_body.h), which are exact.
//
// A step: loads on the bodies (TreeBody::AddForce ...), the step's contacts (AddContact), then
// Step. Who finds contacts is outside: exact pairs of shapes, a ground of soil, or Bullet.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "models/parts/contact_material.h"
#include "models/parts/joint_stop.h"
#include "sim/rigid/constraint_system.h"
#include "sim/rigid/tree_body.h"

namespace dockyard {

/// A link of a body, by their numbers; body -1: the ground, or anything that never moves.
struct BodyLink {
  int body = -1, link = 0;
};

/// One point where two links may press on each other within the step.
struct WorldContact {
  BodyLink a{}, b{};
  std::int64_t pair = 0;  // of the two surfaces; the same from step to step
  Eigen::Vector3d p_G{0, 0, 0}, normal_G{0, 0, 1};  // from b to a
  double gap_m = 0.0;                               // < 0: pressed in
  double share = 1.0;      // of the material's stiffness and damping: a line counts by two points
  double bend_kept = 1.0;  // share of the last step's bend that goes on (contact_law.h)
  ContactMaterial material{};
  // The number of contacts, this one and those before it, whose load gives its rolling resistance.
  int rolling_contacts = 1;
  // A contact goes on from the nearest one of its pair in the last step, no further away than this.
  double same_within_m = std::numeric_limits<double>::infinity();
  // Solved: on a [N s, N m s], and how far the surfaces are bent across.
  Eigen::Vector3d impulse_G{0, 0, 0}, rolling_G{0, 0, 0}, bend_G{0, 0, 0};
};

/// What limits a joint; torques at its shaft, of a slide forces.
struct JointLaw {
  double low_rad = -std::numeric_limits<double>::infinity();
  double high_rad = std::numeric_limits<double>::infinity();
  double stop_nm_per_rad = 0.0, stop_nms_per_rad = 0.0;  // of a stop's spring, > 0, and damper
  double friction_nm = 0.0;                              // Coulomb's; holds a joint that rests
};

/// Stops at both ends of a joint's turn.
inline JointLaw StopsAt(const JointStop& stop, double low_rad, double high_rad) {
  return {.low_rad = low_rad,
          .high_rad = high_rad,
          .stop_nm_per_rad = stop.stiffness_nm_per_rad,
          .stop_nms_per_rad = stop.damping_nms_per_rad};
}

/// Two points that a stiff spring holds together: a ball joint that closes a loop of links.
struct PointTie {
  BodyLink a{}, b{};
  Eigen::Vector3d p_A{0, 0, 0}, p_B{0, 0, 0};  // in the links' frames; of the ground in G
  double stiffness_n_per_m = 0.0, damping_ns_per_m = 0.0;
};

class RigidWorld {
 public:
  explicit RigidWorld(const Eigen::Vector3d& gravity_G) : gravity_G_(gravity_G) {}

  /// Returns the number. A reference to a body is good until the next Add.
  int Add(TreeBody body);
  TreeBody& body(int i) { return bodies_[Place(i)]; }
  const TreeBody& body(int i) const { return bodies_[Place(i)]; }
  void Limit(const BodyLink& joint, const JointLaw& law);
  /// Limits the joint's angle less that of another link's joint of the same body.
  void LimitBetween(const BodyLink& joint, int other_link, const JointLaw& law);
  int Add(const PointTie& tie);
  /// As of ConstraintSystem::Start.
  void SetSolved(double share) { solved_ = share; }
  void SetGravity(const Eigen::Vector3d& gravity_G) { gravity_G_ = gravity_G; }

  /// A body that sleeps rests where it is and is as the ground for others: to move again it is to
  /// be woken. Meanwhile its contacts stay as they are.
  void SetAsleep(int body, bool asleep);
  bool asleep(int body) const { return asleep_[Place(body)]; }

  /// For the next step; places as they are now. Returns its number among the step's contacts.
  int AddContact(const WorldContact& contact) {
    next_contacts_.push_back(contact);
    return static_cast<int>(next_contacts_.size()) - 1;
  }

  /// TakeLoads, Resist and Move, between which others may change the speeds.
  void Step(double step_s);
  /// Speeds by gravity and loads, without what is solved.
  void TakeLoads(double step_s);
  /// Changes them by contacts, ties and joints.
  void Resist(double step_s);
  void Move(double step_s);

  /// Of the last step, in the order in which they were added; then those of sleepers.
  const std::vector<WorldContact>& contacts() const { return contacts_; }
  /// On the first point of a tie in the last step [N s].
  const Eigen::Vector3d& tie_impulse_G(int tie) const { return ties_[Place(tie)].impulse_G; }
  int sweeps() const { return sweeps_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Joint {
    BodyLink at;
    int other_link = -1;
    JointLaw law;
    double rub = 0.0, from_low = 0.0, from_high = 0.0;  // impulses of the last step
  };
  struct Tie {
    PointTie points;
    Eigen::Vector3d impulse_G{0, 0, 0};
  };
  struct LinkAnswers {
    BodyLink at;
    LinkRows rows;
  };
  static std::size_t Place(int i) { return static_cast<std::size_t>(i); }
  LinkMotion MotionOf(const BodyLink& at) const;
  bool Moves(int body) const { return body >= 0 && !asleep(body); }
  void AddJointRows(std::size_t joint, double step_s);
  void GoOnFromLastStep(WorldContact& contact, double step_s) const;
  const LinkRows& RowsOf(const BodyLink& at);
  void FillEnds(const BodyLink& a, const BodyLink& b, const Eigen::Vector3d& p_G,
                const Eigen::Matrix3d& axes, bool turning);
  void AddTieRows();
  void AddContactRows(double step_s);
  void TakeJointImpulses();
  void TakeContactImpulses();

  Eigen::Vector3d gravity_G_;
  std::vector<TreeBody> bodies_;
  std::vector<Eigen::Index> first_;  // of each body's speeds among all
  std::vector<bool> asleep_;
  Eigen::Index speeds_ = 0;
  std::vector<Joint> joints_;
  std::vector<Tie> ties_;
  std::vector<WorldContact> contacts_, next_contacts_;
  std::vector<Eigen::Matrix3d> axes_;  // of the next ones
  double solved_ = kSolved;
  ConstraintSystem system_;
  ConstraintEnds ends_;
  std::vector<LinkAnswers> answers_;  // of this step; the first answers_count_ count
  std::size_t answers_count_ = 0;
  int sweeps_ = 0;
};

/// A unit vector and two directions across it, as columns.
Eigen::Matrix3d AxesAlong(const Eigen::Vector3d& normal);

}  // namespace dockyard
