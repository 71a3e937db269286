// A robot as a tree of rigid links on hinges about a free base. Only the loads given to it act on
// it. Its speeds follow Newton's and Euler's laws in Kane's form; the matrix of inertia is that of
// composite bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 6).
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

namespace dockyard {

/// A link and the hinge that carries it. At angle 0 its frame L is parallel to its parent's, P.
struct TreeLink {
  LinkModel model{};
  int parent = -1;                        // an earlier link; -1: this is the base
  Eigen::Vector3d p_PL{0, 0, 0};          // of the hinge, L's origin [m]
  Eigen::Vector3d axis_L{0.0, 1.0, 0.0};  // unit; the angle is positive about it
  double rotor_kg_m2 = 0.0;               // of the motor, at the joint
};

/// Weights of joints, by link: the weighted sum of their angles stays as it is at the start.
using JointTie = std::vector<std::pair<int, double>>;

class TreeBody {
 public:
  static constexpr int kMostSpeeds = 32;
  /// Velocity of the base's centre of mass in G, the base's turning in G, then the joints' rates in
  /// the order of the links [m/s, rad/s].
  using Speeds = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostSpeeds, 1>;
  using Inertia =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostSpeeds, kMostSpeeds>;
  using PointJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostSpeeds>;

  /// The base comes first and stands at X_GB; all angles are 0. Each link has a mass and comes
  /// after its parent.
  TreeBody(std::vector<TreeLink> links, std::vector<JointTie> ties, const Pose3& X_GB);

  int link_count() const { return static_cast<int>(links_.size()); }
  const TreeLink& link(int i) const { return links_[Place(i)]; }
  const LinkMotion& motion(int i) const { return motion_[Place(i)]; }
  double angle_rad(int i) const { return angle_rad_[Place(i)]; }
  double rate_rad_s(int i) const { return i == 0 ? 0.0 : speeds_[5 + i]; }
  const Speeds& speeds() const { return speeds_; }
  double mass_kg() const { return mass_kg_; }

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
  Speeds Answer(const Speeds& impulse) const;
  /// The same for an impulse in each column.
  Eigen::MatrixXd Answers(const Eigen::MatrixXd& impulses) const;
  void AddSpeeds(const Speeds& change);
  /// A step's positions by the speeds.
  void Move(double step_s);

  /// Velocity in G of a link's material point at p_G over the speeds.
  PointJacobian JacobianOf(int i, const Eigen::Vector3d& p_G) const;
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
  void Refresh();
  void FindAnswers();
  Speeds CollectLoads(const Eigen::Vector3d& gravity_G);

  struct Wrench {
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
  };

  std::vector<TreeLink> links_;
  std::vector<LinkMotion> motion_;
  std::vector<Eigen::Vector3d> com_G_, axis_G_;
  std::vector<Eigen::Matrix3d> inertia_G_;  // about centres of mass
  std::vector<double> angle_rad_;
  std::vector<Wrench> loads_;  // about the centres
  std::vector<double> joint_loads_nm_;
  double mass_kg_ = 0.0;
  Pose3 X_GB_;
  Speeds speeds_;
  Inertia ties_;                     // a row each, over the speeds
  Eigen::LLT<Inertia> mass_, held_;  // of the inertia; of what it leaves of the ties
  Inertia tie_answers_;              // what a unit impulse on each tie gives
};

}  // namespace dockyard
