#include "models/parts/board_symmetry.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// Two places nearer than this count as one for the correspondence gate
// (controller/vision/board/correspond.cc: 2.5 px and 8 % of the diameter), for discs of 15 px or
// more.
constexpr double kSameInDiameters = 0.25;
constexpr double kSameBar_rad = kPi / 8.0;  // half the angle between two rotations

/// Board coordinates have y down, so a counter-clockwise turn for the viewer is a negative one.
Eigen::Vector2d Turned(double turn_rad, const Eigen::Vector2d& p) {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  return {c * p.x() + s * p.y(), c * p.y() - s * p.x()};
}

bool LooksLike(const FiducialBoard& board, const Fiducial& turned, double turn_rad,
               const Fiducial& other) {
  if (!board.HasBars()) return true;
  const double apart = turned.rotation + turn_rad - other.rotation;
  return std::abs(std::remainder(apart, kPi)) < kSameBar_rad;
}

int MarksOnMarks(const FiducialBoard& board, const BoardMotion& motion) {
  const double near_m = kSameInDiameters * board.disc_diameter_m;
  return static_cast<int>(
      std::count_if(board.fiducials.begin(), board.fiducials.end(), [&](const Fiducial& mark) {
        const Eigen::Vector2d p = Turned(motion.turn_rad, mark.p_BF) + motion.shift_m;
        return std::any_of(board.fiducials.begin(), board.fiducials.end(), [&](const auto& other) {
          return (other.p_BF - p).norm() < near_m && LooksLike(board, mark, motion.turn_rad, other);
        });
      }));
}

bool StandsStill(const FiducialBoard& board, const BoardMotion& motion) {
  const double near_m = kSameInDiameters * board.disc_diameter_m;
  return std::all_of(board.fiducials.begin(), board.fiducials.end(), [&](const Fiducial& mark) {
    return (Turned(motion.turn_rad, mark.p_BF) + motion.shift_m - mark.p_BF).norm() < near_m;
  });
}

}  // namespace

BoardMotion LargestSymmetry(const FiducialBoard& board, int least, double below_rad) {
  // Two marks and the places where they land fix a motion. Of the first n - least + 2 marks at
  // least two land.
  BoardMotion best;
  const auto& marks = board.fiducials;
  const std::size_t first = marks.size() + 1 - std::min<std::size_t>(marks.size(), least);
  const double near_m = kSameInDiameters * board.disc_diameter_m;
  for (std::size_t a = 0; a < first; ++a) {
    for (std::size_t b = a + 1; b < std::min(first + 1, marks.size()); ++b) {
      const Eigen::Vector2d from = marks[b].p_BF - marks[a].p_BF;
      for (std::size_t c = 0; c < marks.size(); ++c) {
        for (std::size_t d = 0; d < marks.size(); ++d) {
          const Eigen::Vector2d to = marks[d].p_BF - marks[c].p_BF;
          if (c == d || std::abs(to.norm() - from.norm()) > near_m) continue;
          BoardMotion motion;
          motion.turn_rad = std::remainder(
              std::atan2(-to.y(), to.x()) - std::atan2(-from.y(), from.x()), 2 * kPi);
          if (std::abs(motion.turn_rad) >= below_rad ||
              !LooksLike(board, marks[a], motion.turn_rad, marks[c]) ||
              !LooksLike(board, marks[b], motion.turn_rad, marks[d])) {
            continue;
          }
          motion.shift_m = 0.5 * (marks[c].p_BF + marks[d].p_BF) -
                           Turned(motion.turn_rad, 0.5 * (marks[a].p_BF + marks[b].p_BF));
          if (StandsStill(board, motion)) continue;
          motion.marks = MarksOnMarks(board, motion);
          const bool better = motion.marks > best.marks ||
                              (motion.marks == best.marks &&
                               std::abs(motion.turn_rad) < std::abs(best.turn_rad) - 1e-9);
          if (motion.marks >= least && better) best = motion;
        }
      }
    }
  }
  return best;
}

}  // namespace dockyard
