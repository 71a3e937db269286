// Three rows of a constraint over the speeds of one body: from how its links move, and from what
// impulses on them do.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/rigid/tree_body.h"

namespace dockyard {

/// The places of a body's speeds among all: zeros fill them up to a multiple of four.
inline constexpr Eigen::Index PlacesFor(Eigen::Index speeds) { return (speeds + 3) / 4 * 4; }
static_assert(PlacesFor(TreeBody::kMostSpeeds) == TreeBody::kMostSpeeds);

/// What a link's turning in G and its origin's velocity in G go with, and the speeds that a unit
/// impulse on each of these six gives: its contacts share them.
struct LinkRows {
  Eigen::Vector3d p_G{0, 0, 0};
  TreeBody::LinkImpulses rows;  // over the speeds
  std::vector<int> moved;       // speeds whose rows are not zero
  Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::ColMajor, TreeBody::kMostSpeeds, 6> answers;

  void Fill(const TreeBody& tree, int link);
};

/// A body in a constraint of three rows: how the rows' velocities go with its speeds, and the
/// speeds that a unit impulse on each row gives.
struct ConstraintEnd {
  Eigen::Index first = 0;   // of the body's speeds among all
  Eigen::Index places = 0;  // for them; 0: the body does not move
  std::vector<int> moved;   // the speeds that the rows' velocities go with, in order
  // Of each of these speeds the three rows' numbers and one that does not count.
  std::array<double, 4 * TreeBody::kMostSpeeds> jacobian;
  std::array<double, 3 * TreeBody::kMostSpeeds> answer;  // row by row, each in its places

  void Clear();
  /// Of a body with its speeds at `first`; does nothing where it was called before.
  void Start(Eigen::Index first_speed, Eigen::Index speeds);
  /// Adds the velocity of a link's point at p_G along the axes, which are columns.
  void AddPoint(const LinkRows& link, const Eigen::Vector3d& p_G, const Eigen::Matrix3d& axes);
  /// Adds the link's turning about the axes.
  void AddTurning(const LinkRows& link, const Eigen::Matrix3d& axes);
};

}  // namespace dockyard
