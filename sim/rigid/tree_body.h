// A robot as a tree of rigid links on hinges and slides about a base that is free or fixed in the
// ground. Only the loads given to it act on it. Its speeds follow Newton's and Euler's laws in
// Kane's form; the matrix of inertia is that of composite bodies (Featherstone, Rigid Body Dynamics
// Algorithms, 2008, chapter 6).
//
// A rotor turns many times as fast as its joint and so stands on the diagonal of that matrix alone
// (same book, section 9.6).
//
// Ties join the angles of several joints, as a differential does. They are exact: a tie leaves the
// speeds no freedom against it, so nothing is solved by sweeps and no spring is tuned.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "models/parts/link.h"
#include "sim/rigid/motion.h"
#include "sim/rigid/symmetric3.h"
#include "sim/rigid/tree_factor.h"

namespace dockyard {

enum class JointKind : std::uint8_t { kHinge, kSlide, kFixed };

/// A link and the joint that carries it: a hinge, a slide, or none. "Angle" below is a slide's
/// travel as well [m], and "torque" its force [N]. At angle 0 the link's frame L has the pose
/// (R_PL, p_PL) in its parent's, P.
struct TreeLink {
  LinkModel model{};
  int parent = -1;                        // an earlier link; -1: this is the base
  Eigen::Vector3d p_PL{0, 0, 0};          // of the hinge, L's origin [m]
  Eigen::Vector3d axis_L{0.0, 1.0, 0.0};  // unit; the angle is positive about it
  double rotor_kg_m2 = 0.0;               // of the motor, at the joint; of a slide [kg]
  JointKind joint = JointKind::kHinge;
  Eigen::Matrix3d R_PL = Eigen::Matrix3d::Identity();
  // Of the joint's damper and spring, both by the step's end, and the angle at which the spring is
  // free; of a slide [N s/m, N/m, m].
  double damping_nms_per_rad = 0.0, stiffness_nm_per_rad = 0.0, rest_rad = 0.0;

  bool IsHinge() const { return joint == JointKind::kHinge; }
  /// How the torque of spring and damper falls with the joint's rate at the step's end.
  double Resistance(double step_s) const {
    return damping_nms_per_rad + step_s * stiffness_nm_per_rad;
  }
  /// Of the joint's axis, from a force and a torque about its centre.
  double Along(const Eigen::Vector3d& axis_G, const Eigen::Vector3d& force,
               const Eigen::Vector3d& torque) const {
    return axis_G.dot(IsHinge() ? torque : force);
  }
};

/// Weights of joints, by link: the weighted sum of their angles stays as it is at the start.
using JointTie = std::vector<std::pair<int, double>>;

enum class TreeBase : std::uint8_t { kFree, kFixed };

/// At which speeds the loads count that grow with the square of speed (Coriolis, centrifugal):
/// those of the step's start, or its middle. The latter makes a step of second order (leapfrog,
/// speeds belong to the middle of steps); it costs a second sum of loads. Constraints then change
/// the speeds by mid-step as they did in the step before.
enum class VelocityTerms : std::uint8_t { kAtStart, kMidstep };

struct TreeRules {
  TreeBase base = TreeBase::kFree;
  VelocityTerms terms = VelocityTerms::kAtStart;
};

/// A body of one free link keeps its angular momentum to rounding in flight, and turns by the rate
/// at the middle of the step.
class TreeBody {
 public:
  static constexpr int kMostSpeeds = 32, kMostLinks = 32;
  /// Velocity of a free base's centre of mass in G and its turning in G, then the joints' rates in
  /// the order of the links [m/s, rad/s].
  using Speeds = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostSpeeds, 1>;
  using Inertia =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostSpeeds, kMostSpeeds>;
  using PointJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostSpeeds>;

  /// The base comes first and stands at X_GB; all angles are 0. Each link has a mass and comes
  /// after its parent. A fixed base without joints has no speeds and never moves.
  TreeBody(std::vector<TreeLink> links, std::vector<JointTie> ties, const Pose3& X_GB,
           const TreeRules& rules = {});

  int link_count() const { return static_cast<int>(links_.size()); }
  const TreeLink& link(int i) const { return links_[Place(i)]; }
  const LinkMotion& motion(int i) const { return motion_[Place(i)]; }
  double angle_rad(int i) const { return angle_rad_[Place(i)]; }
  double rate_rad_s(int i) const { return SpeedOf(i) < 0 ? 0.0 : speeds_[SpeedOf(i)]; }
  /// The place of a joint's rate among the speeds; -1: it has none.
  Eigen::Index SpeedOf(int i) const { return speed_of_[Place(i)]; }
  const Speeds& speeds() const { return speeds_; }

  /// For a start. The ties keep the sums of the angles given last.
  void SetAngle(int i, double angle_rad);

  /// Loads of the next step, in G. A torque on a joint acts on the link, its opposite on the
  /// parent.
  void AddForce(int i, const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G);
  void AddTorque(int i, const Eigen::Vector3d& torque_G);
  void AddJointTorque(int i, double torque_nm);

  /// Speeds after a step under gravity and the loads, without contacts; positions stay. Forgets the
  /// loads.
  void TakeLoads(const Eigen::Vector3d& gravity_G, double step_s);
  /// Speeds that an impulse over the speeds gives [N s, N m s]; good from TakeLoads to Move.
  Speeds Answer(Speeds impulse) const;
  /// The same for an impulse in each column: along and about three axes each.
  using LinkImpulses = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor, kMostSpeeds, 6>;
  void AnswerInPlace(LinkImpulses& impulses) const;
  void AddSpeeds(const Speeds& change);
  void Stop();
  /// A step's positions by the speeds.
  void Move(double step_s);

  /// Velocity in G of a link's material point at p_G over the speeds.
  PointJacobian JacobianOf(int i, const Eigen::Vector3d& p_G) const;
  /// How a link's turning in G, three columns, and its origin's velocity in G go with each speed.
  LinkImpulses MotionRowsOf(int i) const;
  /// Inertia of the speeds, rotors included.
  Inertia MassMatrix() const;
  /// Of all motion, rotors' own left out but for their joints' rates [J].
  double KineticEnergy() const { return 0.5 * speeds_.dot(MassMatrix() * speeds_); }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  static std::size_t Place(int i) { return static_cast<std::size_t>(i); }
  /// Of the centre that stands for a link in the sums: the base's centre of mass, else its hinge.
  const Eigen::Vector3d& Centre(int i) const {
    return i == 0 ? com_G_[0] : motion_[Place(i)].X_GL.p;
  }
  void RefreshPlaces();
  void RefreshSpeeds();
  /// Rows of the lower half, so long; numbers that are zero by the tree's shape are left out.
  void FillInertia(double* rows, Eigen::Index row_length) const;
  void FindAnswers(double step_s);
  Speeds CollectLoads(const Eigen::Vector3d& gravity_G);
  void MoveBase(double step_s);

  struct Wrench {
    Eigen::Vector3d force, torque;
  };

  std::vector<TreeLink> links_;
  TreeRules rules_;
  bool flies_alone_ = false;            // one free link
  std::vector<Eigen::Index> speed_of_;  // by link; -1: none
  std::vector<std::uint8_t> turned_;    // by link: R_PL is not the identity
  std::vector<LinkMotion> motion_;
  std::vector<Eigen::Vector3d> com_G_, axis_G_;
  std::vector<Symmetric> inertia_G_;  // about centres of mass
  std::vector<double> angle_rad_;
  std::vector<Wrench> loads_;  // about the centres
  std::vector<double> joint_loads_nm_;
  double mass_kg_ = 0.0;
  Pose3 X_GB_;
  Speeds speeds_;
  Speeds loaded_, resisted_;         // after TakeLoads; what changed from there to Move
  TreeFactor factor_;                // of the inertia, but for a body that flies alone:
  Symmetric inverse_L_, inverse_G_;  // of its moments
  Inertia ties_;                     // a row each, over the speeds
  Eigen::LLT<Inertia> held_;         // of what the inertia leaves of the ties
  Inertia tie_answers_;              // what a unit impulse on each tie gives
};

}  // namespace dockyard
