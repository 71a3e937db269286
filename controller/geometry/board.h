// The fiducial board as printed. The station's has eight discs with a bar through the middle, each
// in one of four rotations (Tsai et al., III-A); the bar's shape and the layout are ours, the paper
// gives none. Other boards have another number of marks, or plain discs without bars.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace dockyard {

/// One fiducial: a black disc on white ground with a centred white bar.
struct Fiducial {
  Eigen::Vector2d p_BF = Eigen::Vector2d::Zero();  // its centre on the board: x right, y down [m]
  // Direction of the bar's long axis, from the board's x axis towards y *up* (counter-clockwise as
  // the viewer sees it): -pi/4, 0, pi/4 or pi/2 [rad]. The bar has a half-turn symmetry.
  double rotation = 0.0;
};

/// The squares of a printed tag, row by row from its top left.
struct TagCells {
  int across = 0;     // a side, all that is printed
  int at_border = 0;  // a side of the square between the detector's corners, centred
  int margin = 0;     // outermost rings that are white in every tag of the family
  std::vector<std::uint8_t> black{};  // across * across: 1 black, 0 white

  bool IsBlack(int column, int row) const {
    return black[static_cast<std::size_t>(row * across + column)] != 0;
  }
};

/// One square tag. Frame T: the tag's centre, x right and y down as it is printed.
struct SquareTag {
  std::string family{};  // a name of controller/vision/tags/tag_code.h
  int id = 0;
  Eigen::Vector2d p_BT = Eigen::Vector2d::Zero();  // [m]
  double size_m = 0.0;                             // side of the square between its corners
  double rotation = 0.0;  // of T, counter-clockwise as the viewer sees it [rad]
  TagCells cells{};

  double cell_m() const { return size_m / cells.at_border; }
  double printed_m() const { return cells.across * cell_m(); }
};

/// A point of the tag on its board.
Eigen::Vector2d OnBoard(const SquareTag& tag, const Eigen::Vector2d& p_TQ);
/// The tag's corners between which size_m lies, on its board: top left, top right, bottom right,
/// bottom left as it is printed.
std::array<Eigen::Vector2d, 4> CornersOf(const SquareTag& tag);

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
  std::vector<SquareTag> tags{};  // in place of discs: a board has one or the other

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
