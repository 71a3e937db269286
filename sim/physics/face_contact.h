// An instrument's face against a boulder that does not move: contact switches and the rim of the
// can, each a point that gives way along its own spring.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/parts/mast_model.h"
#include "sim/physics/star_body.h"
#include "sim/physics/tree_body.h"

namespace dockyard {

inline constexpr int kFaceSwitches = 3;

class FaceContact {
 public:
  /// `link`: of the tree, that carries the can along its x axis; the switches' tips are at face_m.
  FaceContact(const InstrumentModel& instrument, int link, double face_m);

  /// Adds the loads of a step. A point presses with k d + c v where it is deeper than it was, never
  /// pulls, and rubs up to Coulomb's limit by a bristle as stiff as itself.
  void Step(const StarBody& body_G, double step_s, TreeBody& tree);

  /// Of the last step: whether a switch is closed, and the sum of the points' normal forces [N].
  const std::array<bool, kFaceSwitches>& closed() const { return closed_; }
  double force_n() const { return force_n_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Point {
    Eigen::Vector3d p_L{0, 0, 0};
    Eigen::Vector3d bend_G{0, 0, 0};  // of its bristle; 0: does not touch
  };
  InstrumentModel instrument_;
  int link_ = 0;
  double reach_m_ = 0.0;  // of a sphere about the face's middle that holds all points
  Eigen::Vector3d p_L_middle_{0, 0, 0};
  std::vector<Point> points_;  // the switches first
  std::array<bool, kFaceSwitches> closed_{};
  double force_n_ = 0.0;
};

}  // namespace dockyard
