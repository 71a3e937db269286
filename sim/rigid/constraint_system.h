// Constraints on the speeds of several bodies, solved together: contacts that rub and roll, points
// tied together, stops and friction of joints.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "sim/rigid/contact_law.h"
#include "sim/rigid/link_rows.h"
#include "sim/rigid/tree_body.h"

namespace dockyard {

using ConstraintEnds = std::array<ConstraintEnd, 2>;

/// A constraint on the rate of one joint, or on its rate less that of another joint of the same
/// body; `sign` makes the rate positive where it opens a gap.
struct JointRow {
  Eigen::Index speed = 0, first = 0;  // of the joint, of its body's first, among all
  Eigen::Index other = -1;            // of the other joint; -1: none
  double sign = 1.0;
  double low = 0.0, high = 0.0;             // of the impulse [N m s]
  double softness = 0.0, bias_rad_s = 0.0;  // as of a contact's normal
  double impulse = 0.0;                     // first guess, then solved
  std::size_t owner = 0;                    // whose it is; the solver leaves it alone
};

/// Springs and dampers act at the step's end: contact_law.h.
class ConstraintSystem {
 public:
  /// Forgets all constraints. `speeds` is the number of places of all bodies' speeds. Sweeps end
  /// once none changes an impulse by more than the share `solved` of the largest.
  void Start(Eigen::Index speeds, double step_s, double solved = kSolved);
  /// Of all bodies, without constraints; Solve changes them.
  Eigen::VectorXd& speeds() { return speeds_; }

  /// Rows: along the normal, along two directions across it. impulse: a first guess [N s].
  void AddContact(const ContactLaw& law, const Eigen::Vector3d& impulse,
                  const ConstraintEnds& ends);
  /// Of the given number of contacts that were added last. Rows: turning about the two directions
  /// across, and none.
  void AddRolling(double resistance_m, const Eigen::Vector3d& impulse, const ConstraintEnds& ends,
                  std::size_t contacts = 1);
  /// Two points that a spring and a damper hold together. Rows: along three axes; gap_m: along
  /// them, of the first point from the second.
  void AddTie(double stiffness_n_per_m, double damping_ns_per_m, const Eigen::Vector3d& gap_m,
              const Eigen::Vector3d& impulse, const ConstraintEnds& ends);
  /// answer: the body's speeds that a unit impulse on the joint gives, with its opposite on the
  /// other joint.
  void AddJoint(const JointRow& row, const TreeBody::Speeds& answer);
  bool empty() const { return contacts_.empty() && ties_.empty() && joints_.empty(); }

  /// Projected Gauss-Seidel for each island, that is bodies that constraints join, until no impulse
  /// changes by more than that share of the island's largest of its kind. An island that takes more
  /// than ten sweeps goes on by the nonsmooth conjugate gradient of Silcowitz-Hansen, Niebe and
  /// Erleben (The Visual Computer 26, 2010): its steps are such sweeps, and it ends at the same
  /// impulses. Returns the most sweeps of an island, at most 500. Advances the contacts' bends.
  int Solve();

  /// In the order in which they were added.
  const Eigen::Vector3d& contact_impulse(std::size_t i) const { return contacts_[i].rows.impulse; }
  const Eigen::Vector2d& contact_bend_m(std::size_t i) const { return contacts_[i].law.bend_m; }
  const Eigen::Vector3d& rolling_impulse(std::size_t i) const { return rollings_[i].rows.impulse; }
  const Eigen::Vector3d& tie_impulse(std::size_t i) const { return ties_[i].rows.impulse; }
  std::size_t joint_count() const { return joints_.size(); }
  const JointRow& joint_row(std::size_t i) const { return joints_[i].row; }

 private:
  /// Three rows over the speeds of two bodies. The answers lie in numbers_: of each body a row
  /// after the other. The Jacobian lies in terms_, for those speeds alone that it is not zero of.
  struct Rows {
    std::array<Eigen::Index, 2> first{}, places{};
    std::size_t numbers = 0, terms = 0, term_count = 0;
    Eigen::Matrix3d own;  // velocity of each row for a unit impulse on another
    Eigen::Vector3d impulse;
  };
  struct Term {
    Eigen::Index speed = 0;
    double x = 0.0, y = 0.0, z = 0.0;
  };
  struct Contact {
    Rows rows;
    ContactLaw law;
    double softness = 0.0, bias_m_s = 0.0, along = 0.0, across = 0.0;
    Eigen::Vector2d unbend_m_s{0.0, 0.0};
    Eigen::Vector3d change{0, 0, 0}, direction{0, 0, 0};  // of the impulse, in the sweeps
  };
  struct Rolling {
    Rows rows;
    std::size_t contact = 0, end = 0;  // from the first to before the last
    double resistance_m = 0.0, across = 0.0;
  };
  struct Tie {
    Rows rows;
    double softness = 0.0;
    Eigen::Vector3d bias_m_s;
    Eigen::Matrix3d inverse;  // of the answer with the softness
  };
  struct Joint {
    JointRow row;
    Eigen::Index count = 0;
    std::size_t numbers = 0;  // of the answer
    double own = 0.0;
  };
  /// Constraints by their numbers.
  struct Island {
    std::vector<std::size_t> ties, joints, contacts, rollings;
  };
  /// The largest change of a sweep and the largest impulse, of forces and of torques.
  struct Sweep {
    double force = 0.0, largest_force = 0.0, torque = 0.0, largest_torque = 0.0;
    bool IsLast(double solved) const;
  };

  Rows AddRows(const Eigen::Vector3d& impulse, const ConstraintEnds& ends);
  Eigen::Vector3d VelocityOf(const Rows& rows) const;
  /// Adds an impulse on the rows to the speeds.
  void Push(const Rows& rows, const Eigen::Vector3d& more);
  void PushJoint(Joint& joint, double more);
  void PushFirstGuesses();
  /// The first speed of the lowest body that is known to be joined with this one.
  Eigen::Index LowestOf(Eigen::Index first) const;
  Island& IslandOf(Eigen::Index first);
  Island& IslandOf(const Rows& rows) { return IslandOf(rows.first[rows.places[0] > 0 ? 0 : 1]); }
  void FindIslands();
  int SolveIsland(const Island& island);
  double RateOf(const JointRow& row) const;
  void SolveTie(Tie& tie, Sweep& sweep);
  void SolveJoint(Joint& joint, Sweep& sweep);
  void SolveContact(Contact& contact, Sweep& sweep);
  void SolveRolling(Rolling& rolling, Sweep& sweep);
  void Bend();

  double step_s_ = 0.0, solved_ = kSolved;
  Eigen::VectorXd speeds_;
  std::vector<double> numbers_;
  std::vector<Term> terms_;
  std::vector<Contact> contacts_;
  std::vector<Rolling> rollings_;
  std::vector<Tie> ties_;
  std::vector<Joint> joints_;
  std::vector<Eigen::Index> joined_;  // by a body's first speed: one that it is joined with
  std::vector<int> island_of_;        // by the lowest body's first speed; -1: none yet
  std::vector<Island> islands_;       // the first island_count_ count
  int island_count_ = 0;
};

}  // namespace dockyard
