// The fiducial board as printed: eight discs with a bar through the middle, each in one of four
// rotations (Tsai et al., III-A). The bar's shape and the layout are ours; the paper gives none.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace dockyard {

/// One fiducial: a black disc on white ground with a centred white bar.
struct Fiducial {
  Eigen::Vector2d p_BF = Eigen::Vector2d::Zero();  // its centre on the board: x right, y down [m]
  // Direction of the bar's long axis, from the board's x axis towards y *up* (counter-clockwise as
  // the beholder sees it): -pi/4, 0, pi/4 or pi/2 [rad]. The bar has a half-turn symmetry.
  double rotation = 0.0;
};

struct FiducialBoard {
  double width_m = 0.0, height_m = 0.0;  // the white plate
  double disc_diameter_m = 0.10;         // Tsai et al., III-A
  double bar_length_m = 0.0, bar_width_m = 0.0;
  std::vector<Fiducial> fiducials;  // two of each rotation
};

}  // namespace dockyard
