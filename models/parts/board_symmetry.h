// Whether layout and bars alone identify the marks of a board.
#pragma once

#include "controller/geometry/board.h"

namespace dockyard {

/// A rigid motion of the board in its plane that puts marks upon marks.
struct BoardMotion {
  double turn_rad = 0.0;                              // counter-clockwise for the viewer
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();  // of the board's origin
  int marks = 0;                                      // how many land on an equal mark
};

/// Of the motions that put at least `least` marks upon equal marks (within a quarter of a disc,
/// bars within 22.5 deg), the one that puts the most, then turns the least; `marks` is zero when
/// there is none. Motions that turn by `below_rad` or more do not count, nor does standing still.
BoardMotion LargestSymmetry(const FiducialBoard& board, int least, double below_rad);

}  // namespace dockyard
