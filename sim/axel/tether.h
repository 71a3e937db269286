// The tether: elastic, never pushing, sliding with friction over the edges of lip and throat.
// Massless in its mechanics: 5 m of 0.05 kg/m sag by under 1 % of their length above 10 N.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"
#include "sim/axel/tether_path.h"

namespace dockyard::axel {

/// Forces of the tether, frame M (mouth of the cone, carried by the station).
struct TetherLoad {
  double tension_n = 0.0;  // at the tip
  Eigen::Vector3d force_on_tip_M = Eigen::Vector3d::Zero();
  // On the station at bends and anchor: p and f by node, tip's neighbour first.
  int nodes = 0;
  std::array<Eigen::Vector3d, kBendCount + 1> p_M{};
  std::array<Eigen::Vector3d, kBendCount + 1> force_on_station_M{};
};

class Tether {
 public:
  /// inside_arm_m: tether between drum and tip; it stretches with the rest and bends nowhere.
  Tether(const TetherModel& tether, const StationModel& station, double inside_arm_m);

  /// Lays free_m of unstretched tether along the path from p_MT, the same strain everywhere.
  void LayOut(const Eigen::Vector3d& p_MT, double free_m);

  /// Advances the sliding over the bends and returns the forces. free_m: unstretched length outside
  /// the arm; its rate; v_MT: velocity of the tip against the station, in M.
  TetherLoad Step(const Eigen::Vector3d& p_MT, const Eigen::Vector3d& v_MT, double free_m,
                  double free_rate_m_s);

  /// The first piece now begins elsewhere on its line, and this much shorter (< 0: longer);
  /// inside_m: what lies before it and stretches with it, damping_ns_per_m: of its length.
  void BeginAt(const Eigen::Vector3d& p_MT, double shorter_m, double inside_m,
               double damping_ns_per_m);

  double path_m() const { return path_.total_m(); }
  double free_m() const;
  double first_free_m() const { return free_[0]; }  // of the piece at the tip
  const TetherPath& path() const { return path_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  using PerPiece = std::array<double, kBendCount + 1>;
  void Rethread(const TetherPath& next);
  void SlideOverBends();
  double Inside(int piece) const { return piece == 0 ? inside_arm_m_ : 0.0; }
  /// Tension of a piece [N]; negative when the tether is longer than the piece's path.
  double Pull(int piece) const;
  PerPiece Tensions() const;

  TetherModel tether_;
  ConeModel cone_;
  double anchor_depth_m_ = 0.0;
  double inside_arm_m_ = 0.0;
  TetherPath path_;
  PerPiece free_{};  // unstretched length laid along each piece, the arm's inside not counted
};

}  // namespace dockyard::axel
