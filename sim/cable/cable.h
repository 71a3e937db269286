// A cable with mass: point masses on elastic segments that never push. It hangs, lies on the ground
// and over convex solids, rubs there by Coulomb's law, and is paid out and drawn in at its fed end.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "sim/cable/cable_body.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

struct CableModel {
  double axial_stiffness_n = 0.0;  // EA: tension per strain
  double damping_ns_per_m = 0.0;   // of the whole length, whatever it is
  double diameter_m = 0.0;
  double mass_kg_per_m = 0.0;
  double friction_on_ground = 0.0;
  double spacing_m = 0.08;  // of the point masses
  double inside_m = 0.0;    // length before the fed end: it stretches with the rest
};

/// What the cable's last point mass hangs on.
struct CablePull {
  Eigen::Vector3d force_G{0, 0, 0};
  // How much less of it per velocity of the mass [N s/m]: h x stiffness + damping.
  Eigen::Matrix3d resistance = Eigen::Matrix3d::Zero();
};
class CableEnd {
 public:
  virtual ~CableEnd() = default;
  /// Were the mass, at p_G now, to move with v_G for a step.
  virtual CablePull Try(const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G,
                        double step_s) const = 0;
};

/// A piece of cable straight to a point at rest.
class FixedCableEnd : public CableEnd {
 public:
  FixedCableEnd(const CableModel& cable, const Eigen::Vector3d& p_GE, double rest_m)
      : cable_(cable), p_GE_(p_GE), rest_m_(rest_m) {}
  CablePull Try(const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G,
                double step_s) const override;

 private:
  CableModel cable_;
  Eigen::Vector3d p_GE_;
  double rest_m_ = 0.0;
};

struct CableStep {
  double step_s = 1e-3;
  Eigen::Vector3d gravity_G{0, 0, 0};
  const HeightGrid* ground = nullptr;  // none: no ground
  const std::vector<CableBody>* bodies = nullptr;
  Eigen::Vector3d p_GF{0, 0, 0}, v_GF_G{0, 0, 0};  // of the fed end
  double fed_m = 0.0;                              // paid out since the last step, < 0: drawn in
  const CableEnd* end = nullptr;
  double end_rest_m = 0.0;  // unstretched length of the piece that the end stands for
};

/// A force of the cable on a body (its index; the ground has none and is left out).
struct CableLoad {
  int body = 0;
  Eigen::Vector3d p_G{0, 0, 0}, force_G{0, 0, 0};
};

class Cable {
 public:
  explicit Cable(const CableModel& model) : model_(model) {}

  /// Lays point masses on the straight line from the fed end, unstretched, at rest.
  void Clear() { nodes_.clear(); }
  void LayOut(const Eigen::Vector3d& p_GF, const Eigen::Vector3d& p_GE, int masses);

  /// One step by the implicit rule of Euler.
  void Step(const CableStep& step);
  /// Kept apart by at most this push when a mass is found deep inside a solid [m].
  double deepest_m = 1e9;

  int masses() const { return static_cast<int>(nodes_.size()); }
  const Eigen::Vector3d& p_G(int mass) const { return nodes_[mass].p_G; }
  const Eigen::Vector3d& v_G(int mass) const { return nodes_[mass].v_G; }
  double rest_m(int segment) const { return nodes_[segment].rest_m; }
  /// Unstretched length of all segments, the end's piece left out.
  double rest_m() const;
  /// Length along the cable from the fed end to the last mass.
  double length_m(const Eigen::Vector3d& p_GF) const;
  double fastest_m_s() const;
  /// Of all masses, as they were in the last step.
  Eigen::Vector3d momentum_G() const;

  /// Stops all masses: for laying out.
  void Calm();
  /// Takes the last mass away; its segment's unstretched length is returned.
  double DropLast();
  void AddLast(const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G, double rest_m);

  /// Of the last step.
  const Eigen::Vector3d& force_on_fed_end_G() const { return on_fed_end_G_; }
  double tension_at_fed_end_n() const { return on_fed_end_n_; }
  const Eigen::Vector3d& force_of_end_G() const { return of_end_G_; }
  const Eigen::Vector3d& force_of_ground_G() const { return of_ground_G_; }
  const Eigen::Vector3d& force_of_air_G() const { return of_air_G_; }
  const std::vector<CableLoad>& loads() const { return loads_; }
  double tension_n(int segment) const { return nodes_[segment].tension_n; }
  int iterations() const { return iterations_; }
  /// Motion, height and stretch of masses and segments [J], the end's piece left out.
  double Energy(const Eigen::Vector3d& gravity_G, const Eigen::Vector3d& p_GF) const;
  /// The cable as a line from the fed end to its last mass, the bends over solids included.
  std::vector<Eigen::Vector3d> Line(const Eigen::Vector3d& p_GF,
                                    const std::vector<CableBody>& bodies) const;
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  static constexpr int kGround = -1, kNone = -2;
  static constexpr int kMostGrips = 3;
  // Bristles of friction on solids and ground [N/m]: 10 N bend them by 0.2 mm (assumed, range
  // 2e4-1e6).
  static constexpr double kBristleNPerM = 5e4;
  /// Where a mass is held by friction.
  struct Grip {
    int body = kNone;
    Eigen::Vector3d bend_G{0, 0, 0};
  };
  /// A segment laid over a solid.
  struct Bend {
    int body = kNone;
    Eigen::Vector3d up_B{0, 0, 0};
    WayRound way;
    double slid_m = 0.0, swept_m = 0.0;  // bends of its friction along the cable and across it
  };
  struct Node {
    Eigen::Vector3d p_G{0, 0, 0}, v_G{0, 0, 0};
    double rest_m = 0.0;  // of the segment before it
    Bend bend;            // of that segment
    double tension_n = 0.0;
    std::array<Grip, kMostGrips> grips;
  };
  /// A mass that touches ground or body, in this step.
  struct Touch {
    int node = 0, body = kNone;
    Eigen::Vector3d normal_G{0, 0, 0}, v_body_G{0, 0, 0}, bend_G{0, 0, 0};
    double gap_m = 0.0, friction = 0.0, stiffness_n_per_m = 0.0, most_n = 0.0;
    // At the speeds tried last, and how much less force there is per velocity.
    double press_n = 0.0, held = 0.0;  // held: of the bristle's stiffness
    Eigen::Vector3d force_G{0, 0, 0};
    Eigen::Matrix3d resistance = Eigen::Matrix3d::Zero();
  };
  /// A segment between masses a and b in this step.
  struct Span {
    // Ends of its straight parts on a solid, and their velocities.
    Eigen::Vector3d first_G{0, 0, 0}, last_G{0, 0, 0}, v_first_G{0, 0, 0}, v_last_G{0, 0, 0};
    Eigen::Vector3d across_G{0, 0, 0};
    bool a_is_near = false, b_is_near = false;  // to the edge there
    Eigen::Vector3d a_straight_G{0, 0, 0}, b_straight_G{0, 0, 0};
    double most_ratio = 0.0, friction = 0.0;
    // Straight: its direction, and how much less force there is per velocity along and across.
    Eigen::Vector3d dir_G{0, 0, 0};
    double along = 0.0, across = 0.0;
    // Round a solid: the forces on both masses, and how much less of them there is per velocity.
    Eigen::Vector3d on_a_G{0, 0, 0}, on_b_G{0, 0, 0};
    Eigen::Matrix3d aa, ab, bb;
    double stiffness_n_per_m = 0.0, slack_m = 0.0;  // spring and damper in one; its free length
    double tension_n = 0.0, slid_m = 0.0, swept_m = 0.0;
  };
  struct Pulled;

  void Feed(const CableStep& step);
  void FindNearBodies(const CableStep& step);
  void FindTouches(const CableStep& step);
  void FindBends(const CableStep& step);
  void BendOver(const CableStep& step, int segment, const Bend& last);
  void TurnUp(const CableBody& body, const Eigen::Vector3d& a_B, const Eigen::Vector3d& b_B,
              Bend& bend) const;
  void Assemble(const CableStep& step);
  void LookForEdges(const CableStep& step, int segment);
  Pulled PartsOf(const CableStep& step, int segment, double ahead_s, const Eigen::Vector3d& v_a_G,
                 const Eigen::Vector3d& v_b_G) const;
  void Stiffen(const CableStep& step, int segment);
  void PullStraight(const CableStep& step, int segment);
  void PullRound(const CableStep& step, int segment);
  void AddStraight(const Span& span, double h, std::size_t segment);
  void AddRound(const Span& span, double h, std::size_t segment);
  void PullBent(const Pulled& pulled, double h, const Bend& bend, Span& span) const;
  void AssembleTouch(const CableStep& step, Touch& touch);
  double Solve();
  bool IsSettled(const CableStep& step) const;
  void ReadForces(const CableStep& step);
  void Move(const CableStep& step);

  CableModel model_;
  std::vector<Node> nodes_;
  std::vector<int> near_;  // bodies that the cable may meet in this step
  std::vector<Touch> touches_;
  std::vector<Span> spans_;
  std::vector<double> mass_kg_;
  std::vector<Eigen::Vector3d> speed_, right_, change_;
  std::vector<Eigen::Matrix3d> diagonal_, upper_, solved_;
  std::vector<char> linked_;  // whether a mass and the next pull on each other
  CablePull end_pull_;
  Eigen::Vector3d on_fed_end_G_{0, 0, 0}, of_end_G_{0, 0, 0}, of_ground_G_{0, 0, 0},
      of_air_G_{0, 0, 0};
  double on_fed_end_n_ = 0.0;
  double damping_n_s_ = 0.0;  // force per rate of strain
  std::vector<CableLoad> loads_;
  int iterations_ = 0;
};

}  // namespace dockyard
