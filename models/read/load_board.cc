#include "models/read/load_board.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/geometry/pose.h"
#include "controller/vision/tags/tag_code.h"
#include "models/parts/board_symmetry.h"
#include "models/read/config_error.h"
#include "models/read/load_tags.h"

namespace dockyard {
namespace {

constexpr int kMostBars = 32, kMostDiscs = 100;  // of one board; naming slows steeply
// White between two plain discs, in diameters: detection compares the print with a ring of 0.175
// diameters about the disc (controller/vision/board/bar.cc).
constexpr double kPlainGap = 0.2;

/// The four rotations of Tsai et al., III-A, exactly as written.
void VisitRotation(Keys& keys, double& rotation_rad) {
  constexpr std::array kRotations{-kPi / 4, 0.0, kPi / 4, kPi / 2};
  const auto at = std::find(kRotations.begin(), kRotations.end(), rotation_rad);
  auto index = static_cast<std::size_t>(at - kRotations.begin());
  keys.Choice("rotation_deg", index, {"-45", "0", "45", "90"});
  rotation_rad = kRotations[index];
}

/// A grid of discs in place of a list.
struct DiscGrid {
  int columns = 2, rows = 2;
  double pitch_m = 0.0, row_pitch_m = 0.0;
  bool staggered = false;
};

void VisitGrid(Keys& keys, DiscGrid& grid) {
  keys.Integer("columns", grid.columns, 2, 50);
  keys.Integer("rows", grid.rows, 2, 50);
  keys.Number("pitch_m", grid.pitch_m, Positive(2.0));
  grid.row_pitch_m = grid.pitch_m;
  keys.Number(Unset("row_pitch_m"), grid.row_pitch_m, Positive(2.0));
  keys.Bool(Optional("staggered"), grid.staggered);
}

/// Row by row from the top left, centred on the board; every other row of a staggered grid is
/// shifted right by half a pitch, as in OpenCV's asymmetric circle grid.
std::vector<Fiducial> DiscsOf(const DiscGrid& grid) {
  const double pitch = grid.pitch_m;
  const double width = (grid.columns - 1 + (grid.staggered ? 0.5 : 0.0)) * pitch;
  std::vector<Fiducial> marks;
  for (int row = 0; row < grid.rows; ++row) {
    const double shift = grid.staggered && row % 2 == 1 ? 0.5 * pitch : 0.0;
    for (int column = 0; column < grid.columns; ++column) {
      marks.push_back({.p_BF = {column * pitch + shift - 0.5 * width,
                                (row - 0.5 * (grid.rows - 1)) * grid.row_pitch_m}});
    }
  }
  return marks;
}

void CheckPlaces(const YamlReader& in, const FiducialBoard& board) {
  const double radius = 0.5 * board.disc_diameter_m;
  const double apart = board.HasBars() ? 2.0 * radius : (2.0 + 2.0 * kPlainGap) * radius;
  const auto refuse = [&](std::size_t i, const std::string& why) {
    if (!in.Has("fiducials")) in.Refuse("grid", why);
    const YamlNode& node = in.Child("fiducials").items[i];
    throw ConfigError(node.place.Text() + ": " + YamlReader::PathOf(in.PathOf("fiducials"), i) +
                      ": expected " + why);
  };
  for (std::size_t i = 0; i < board.fiducials.size(); ++i) {
    const Eigen::Vector2d& p = board.fiducials[i].p_BF;
    if (std::abs(p.x()) + radius > 0.5 * board.width_m + 1e-9 ||
        std::abs(p.y()) + radius > 0.5 * board.height_m + 1e-9) {
      refuse(i, "a disc inside the board, it sticks out");
    }
    for (std::size_t k = 0; k < i; ++k) {
      const double distance = (p - board.fiducials[k].p_BF).norm();
      if (distance < 2.0 * radius) {
        refuse(i, "a disc clear of the others, it overlaps number " + std::to_string(k));
      }
      if (distance < apart - 1e-9) {
        refuse(i, "white of a fifth of the diameter between plain discs, it is nearer to number " +
                      std::to_string(k));
      }
    }
  }
}

/// The motion in words.
std::string Text(const BoardMotion& motion) {
  const double turn_deg = std::round(10.0 * Degrees(std::abs(motion.turn_rad))) / 10.0;
  if (turn_deg > 0.0) return "a turn by " + NumberText(turn_deg) + " deg";
  return "a shift by " + NumberText(std::round(1e4 * motion.shift_m.norm()) / 1e4) + " m";
}

/// Every set of marks that carries a pose must be recognised by its layout and its bars.
void CheckBarsDiffer(const YamlReader& in, const FiducialBoard& board) {
  const BoardMotion motion = LargestSymmetry(board, MarksNeeded(board), 4.0);
  if (motion.marks == 0) return;
  in.Refuse("fiducials", "a layout without symmetry (" + Text(motion) + " puts " +
                             std::to_string(motion.marks) + " marks upon marks with the same bar)");
}

/// Two poses within the allowed roll differ by less than twice that roll, so no turn that small may
/// map the board onto itself.
void CheckUprightDecides(const YamlReader& in, const FiducialBoard& board) {
  const int all = static_cast<int>(board.fiducials.size());
  const BoardMotion motion = LargestSymmetry(board, all, 2.0 * board.upright.within_rad + 1e-9);
  if (motion.marks == 0) return;
  in.Refuse("upright_within_deg",
            "less than " +
                NumberText(std::round(10.0 * Degrees(std::abs(motion.turn_rad))) / 20.0) + ", as " +
                Text(motion) + " maps the discs onto themselves");
}

void VisitUpright(Keys& keys, bool needed, Upright& upright) {
  int index = 0;
  keys.Choice(Optional("upright_in"), index, {"image", "gravity"});
  if (needed) upright.against = index == 0 ? Upright::Against::kImage : Upright::Against::kGravity;
  keys.Degrees(keys.NeededIf(needed, "upright_within_deg"), upright.within_rad,
               Between(1.0, 180.0));
}

void VisitPlate(Keys& keys, FiducialBoard& board) {
  keys.Number("width_m", board.width_m, Positive(5.0));
  keys.Number("height_m", board.height_m, Positive(5.0));
}

/// @param diameter  the key of the discs' diameter
void VisitDiscs(Keys& keys, const Key& diameter, FiducialBoard& board) {
  int kind = 0;
  keys.Choice(Optional("kind"), kind, {"bars", "plain"});
  const bool bars = kind == 0;
  VisitPlate(keys, board);
  keys.Number(diameter, board.disc_diameter_m, Positive(1.0));
  for (const char* key : {"grid", "upright_in", "upright_within_deg"}) {
    keys.Allow(key, !bars, "no such key beside kind: bars, or kind: plain");
  }
  for (const char* key : {"bar_length_m", "bar_width_m"}) {
    keys.Allow(key, bars, "no bar in a board of kind: plain");
  }
  keys.Number(keys.NeededIf(bars, "bar_length_m"), board.bar_length_m, Positive(1.0));
  keys.Number(keys.NeededIf(bars, "bar_width_m"), board.bar_width_m, Positive(1.0));
  keys.Check("bar_length_m",
             !bars || std::hypot(board.bar_length_m, board.bar_width_m) < board.disc_diameter_m,
             "a bar whose corners lie inside the disc");
  VisitUpright(keys, !bars, board.upright);
  DiscGrid grid{.columns = 0};
  keys.Mapping(Unset("grid"), [&](Keys& in) { VisitGrid(in, grid); });
  const bool listed = grid.columns == 0;
  const int count = grid.columns * grid.rows;
  keys.Check("grid", listed || (count >= 6 && count <= kMostDiscs),
             "from 6 to " + std::to_string(kMostDiscs) + " discs");
  if (!listed) board.fiducials = DiscsOf(grid);
  const bool any = !keys.reads();
  keys.Items(keys.NeededIf(listed, "fiducials"), board.fiducials, any || bars ? 4 : 6,
             static_cast<std::size_t>(bars && !any ? kMostBars : kMostDiscs),
             [&](Keys& in, Fiducial& mark) {
               in.Number("x_m", mark.p_BF.x(), Between(-3.0, 3.0));
               in.Number("y_m", mark.p_BF.y(), Between(-3.0, 3.0));
               if (any) {
                 in.Degrees(Unset("rotation_deg"), mark.rotation, Between(-45.0, 90.0));
               } else if (bars) {
                 VisitRotation(in, mark.rotation);
               }
             });
}

/// A board of tags has no key of discs.
void VisitTagBoard(Keys& keys, FiducialBoard& board) {
  for (const char* key : {"kind", "disc_diameter_m", "bar_length_m", "bar_width_m", "fiducials",
                          "grid", "upright_in", "upright_within_deg"}) {
    keys.Allow(key, false, "no such key with tags: a board has either discs or tags");
  }
  VisitPlate(keys, board);
}

}  // namespace

void VisitBoard(Keys& keys, FiducialBoard& board) { VisitDiscs(keys, "disc_diameter_m", board); }

void CheckBoard(const YamlReader& in, const FiducialBoard& board) {
  if (!board.tags.empty()) return CheckTags(in, board);
  if (in.Has("grid") && in.Has("fiducials")) {
    in.Refuse("grid", "either grid or fiducials, not both");
  }
  CheckPlaces(in, board);
  board.HasBars() ? CheckBarsDiffer(in, board) : CheckUprightDecides(in, board);
}

bool IsBoardFile(const YamlNode& root) {
  return root.Find("fiducials") != nullptr || root.Find("grid") != nullptr ||
         root.Find("disc_diameter_m") != nullptr || root.Find("tags") != nullptr;
}

void VisitNamedBoard(Keys& keys, NamedBoard& named) {
  constexpr double kMostBow_m = 0.05;  // a bow beyond it shows no plane any more
  keys.Text("name", named.name);
  keys.Mapping(Unset("tags"), [&](Keys& in) { VisitTags(in, named.board.tags); });
  if (keys.reads() && !named.board.tags.empty()) {
    VisitTagBoard(keys, named.board);
  } else {
    VisitDiscs(keys, keys.NeededIf(true, "disc_diameter_m"), named.board);
  }
  keys.Number(Optional("flatness_m"), named.flatness_m, NonNegative(kMostBow_m));
}

NamedBoard LoadBoard(const std::string& file) {
  const YamlNode root = LoadYaml(file);
  NamedBoard named;
  const auto visit = [&](Keys& keys) { VisitNamedBoard(keys, named); };
  ReadKeys(root, "", visit);
  SetTagCells(named.board);
  CheckBoard(YamlReader(root, "", KeyNames(visit)), named.board);
  return named;
}

}  // namespace dockyard
