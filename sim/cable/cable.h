// A cable with mass: point masses on elastic segments that never push. It hangs, lies on the ground
// and over convex solids, rubs there by Coulomb's law, and is paid out and drawn in at its fed end.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/cable/cable_parts.h"

namespace dockyard {

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
  const Eigen::Vector3d& force_on_fed_end_G() const { return forces_.on_fed_end_G; }
  double tension_at_fed_end_n() const { return forces_.on_fed_end_n; }
  const Eigen::Vector3d& force_of_end_G() const { return forces_.of_end_G; }
  const Eigen::Vector3d& force_of_ground_G() const { return forces_.of_ground_G; }
  const Eigen::Vector3d& force_of_air_G() const { return forces_.of_air_G; }
  const std::vector<CableLoad>& loads() const { return forces_.loads; }
  double tension_n(int segment) const { return nodes_[segment].tension_n; }
  /// Motion, height and stretch of masses and segments [J], the end's piece left out.
  double Energy(const Eigen::Vector3d& gravity_G, const Eigen::Vector3d& p_GF) const;
  /// The cable as a line from the fed end to its last mass, the bends over solids included.
  std::vector<Eigen::Vector3d> Line(const Eigen::Vector3d& p_GF,
                                    const std::vector<CableBody>& bodies) const;
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  /// Of the last step.
  struct Forces {
    Eigen::Vector3d on_fed_end_G{0, 0, 0}, of_end_G{0, 0, 0}, of_ground_G{0, 0, 0},
        of_air_G{0, 0, 0};
    double on_fed_end_n = 0.0;
    std::vector<CableLoad> loads;
  };

  void Feed(const CableStep& step);
  void Assemble(const CableStep& step);
  bool IsSettled(const CableStep& step) const;
  void ReadForces(const CableStep& step);
  void Move(const CableStep& step);

  CableModel model_;
  std::vector<CableNode> nodes_;
  std::vector<int> near_;  // bodies that the cable may meet in this step
  std::vector<CableTouch> touches_;
  std::vector<CableSpan> spans_;
  CableEquations equations_;
  CablePull end_pull_;
  Forces forces_;
};

}  // namespace dockyard
