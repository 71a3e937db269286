// The fiducial board as printed. The station's has eight discs with a bar through the middle, each
// in one of four rotations (Tsai et al., III-A); the bar's shape and the layout are ours, the paper
// gives none. Other boards have another number of marks, or plain discs without bars.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace dockyard {

/// One fiducial: a black disc on white ground with a centred white bar.
struct Fiducial {
  Eigen::Vector2d p_BF = Eigen::Vector2d::Zero();  // its centre on the board: x right, y down [m]
  // Direction of the bar's long axis, from the board's x axis towards y *up* (counter-clockwise as
  // the viewer sees it): -pi/4, 0, pi/4 or pi/2 [rad]. The bar has a half-turn symmetry.
  double rotation = 0.0;
};

/// Which poses of a board are accepted. Any other pose is refused, and so is a naming of the marks
/// that needs one.
struct Upright {
  enum class Against {
    kPlumb,    // gravity: the board's x axis level to 15 deg, its plane upright to 30 deg
    kGravity,  // a roll about the line of sight, from gravity's up
    kImage,    // the same, from the image's up (-y of the camera)
  };
  Against against = Against::kPlumb;
  double within_rad = 0.0;  // the largest roll either way; unused by kPlumb
};

struct FiducialBoard {
  double width_m = 0.0, height_m = 0.0;          // the white plate
  double disc_diameter_m = 0.10;                 // Tsai et al., III-A
  double bar_length_m = 0.0, bar_width_m = 0.0;  // zero: plain discs
  std::vector<Fiducial> fiducials;
  Upright upright{};

  bool HasBars() const { return bar_length_m > 0.0; }
};

/// How many named marks one image must show for a pose. With bars: five, four of which fix a
/// homography and the fifth can vote a false one out (Tsai et al., V-D); a board of four needs all.
/// Plain discs: half of them, and five at least, because a plain disc is weaker evidence than a
/// bar.
int MarksNeeded(const FiducialBoard& board);

/// Whether it has bars, two of each rotation, as the pipeline tsai2013 needs them.
bool HasTwoOfEachRotation(const FiducialBoard& board);

}  // namespace dockyard
