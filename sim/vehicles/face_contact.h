// An instrument's face at the end of a mast, against a boulder that does not move: contact switches
// and the rim of the can. The mast gives way along the tool's axis by one spring for all of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/parts/mast_model.h"
#include "sim/rigid/star_body.h"
#include "sim/rigid/tree_body.h"

namespace dockyard {

inline constexpr int kFaceSwitches = 3;

class FaceContact {
 public:
  /// `link`: of the tree, that carries the can along its x axis; the switches' tips are at face_m.
  FaceContact(const InstrumentModel& instrument, int link, double face_m);

  /// Adds the loads of a step. Points press by their springs, never pull, and are in balance with
  /// the mast's spring and damper. The face as a whole rubs by a bristle as stiff as the mast, up
  /// to Coulomb's limit.
  void Step(const StarBody& body_G, double step_s, TreeBody& tree);

  /// Of the last step: whether a switch is closed, and the sum of the points' normal forces [N].
  const std::array<bool, kFaceSwitches>& closed() const { return closed_; }
  double force_n() const { return force_n_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Point {
    Eigen::Vector3d p_L{0, 0, 0};
    double stiffness_n_per_m = 0.0;
  };
  /// A point that lies in the boulder, the mast not giving way.
  struct Pressed {
    std::size_t point = 0;
    double depth_m = 0.0;
    double along = 0.0;  // how much of the mast's giving way takes it out
    Eigen::Vector3d p_G{0, 0, 0}, normal_G{0, 0, 1};
  };
  std::vector<Pressed> FindPressed(const StarBody& body_G, const LinkMotion& motion) const;
  /// How far the mast gives way with these points pressed, at the step's end.
  double Balance(const std::vector<Pressed>& pressed, double step_s) const;

  InstrumentModel instrument_;
  int link_ = 0;
  double reach_m_ = 0.0;  // of a sphere about the face's middle that holds all points
  Eigen::Vector3d p_L_middle_{0, 0, 0};
  std::vector<Point> points_;        // the switches first
  double give_m_ = 0.0;              // of the mast
  Eigen::Vector3d bend_G_{0, 0, 0};  // of the bristle
  std::array<bool, kFaceSwitches> closed_{};
  double force_n_ = 0.0;
};

}  // namespace dockyard
