// What a cable is made of, and what acts on it in a step.
#pragma once

#include <Eigen/Core>
#include <array>
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

inline constexpr int kCableOnGround = -1, kCableFree = -2;  // in place of a body's index
inline constexpr int kMostCableGrips = 3;
// Bristles of friction on solids and ground [N/m]: 10 N bend them by 0.2 mm (assumed, range
// 2e4-1e6).
inline constexpr double kCableBristle_n_per_m = 5e4;
/// Where a mass is held by friction.
struct CableGrip {
  int body = kCableFree;
  Eigen::Vector3d bend_G{0, 0, 0};
};
/// A segment laid over a solid.
struct CableBend {
  int body = kCableFree;
  Eigen::Vector3d up_B{0, 0, 0};
  WayRound way;
  double slid_m = 0.0, swept_m = 0.0;  // bends of its friction along the cable and across it
};
struct CableNode {
  Eigen::Vector3d p_G{0, 0, 0}, v_G{0, 0, 0};
  double rest_m = 0.0;  // of the segment before it
  CableBend bend;       // of that segment
  double tension_n = 0.0;
  std::array<CableGrip, kMostCableGrips> grips;
};
/// A mass that touches ground or body, in this step.
struct CableTouch {
  int node = 0, body = kCableFree;
  Eigen::Vector3d normal_G{0, 0, 0}, v_body_G{0, 0, 0}, bend_G{0, 0, 0};
  double gap_m = 0.0, friction = 0.0, stiffness_n_per_m = 0.0, most_n = 0.0;
  // At the speeds tried last, and how much less force there is per velocity.
  double press_n = 0.0, held = 0.0;  // held: of the bristle's stiffness
  Eigen::Vector3d force_G{0, 0, 0};
  Eigen::Matrix3d resistance = Eigen::Matrix3d::Zero();
};
/// A segment between masses a and b in this step.
struct CableSpan {
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
/// The step's equations: symmetric, with a block of three for each mass and one for each pair of
/// neighbours.
struct CableEquations {
  std::vector<double> mass_kg;
  std::vector<Eigen::Vector3d> speed, right, change;
  std::vector<Eigen::Matrix3d> diagonal, upper, solved;
  std::vector<char> linked;  // whether a mass and the next pull on each other
};

}  // namespace dockyard
