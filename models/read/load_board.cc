#include "models/read/load_board.h"

#include <array>
#include <cmath>

#include "controller/geometry/pose.h"
#include "models/parts/board_symmetry.h"
#include "models/read/config_error.h"

namespace dockyard {
namespace {

constexpr int kMostBars = 32, kMostDiscs = 100;  // of one board; naming slows steeply
// White between two plain discs, in diameters: detection compares the print with a ring of 0.175
// diameters about the disc (controller/vision/board/bar.cc).
constexpr double kPlainGap = 0.2;

/// The four rotations of Tsai et al., III-A, exactly as written.
double ReadRotation(const YamlReader& mark) {
  constexpr std::array<double, 4> kRotations{-kPi / 4, 0.0, kPi / 4, kPi / 2};
  return kRotations[static_cast<std::size_t>(
      mark.Choice("rotation_deg", {"-45", "0", "45", "90"}))];
}

std::vector<Fiducial> ReadList(const YamlReader& in, bool bars) {
  const YamlNode& list =
      in.List("fiducials", bars ? 4 : 6, static_cast<std::size_t>(bars ? kMostBars : kMostDiscs));
  std::vector<std::string> keys{"x_m", "y_m"};
  if (bars) keys.push_back("rotation_deg");
  std::vector<Fiducial> marks;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlReader mark(list.items[i], YamlReader::PathOf(in.PathOf("fiducials"), i), keys);
    Fiducial fiducial;
    fiducial.p_BF = {mark.Number("x_m", Between(-3.0, 3.0)),
                     mark.Number("y_m", Between(-3.0, 3.0))};
    if (bars) fiducial.rotation = ReadRotation(mark);
    marks.push_back(fiducial);
  }
  return marks;
}

/// Row by row from the top left, centred on the board; every other row of a staggered grid is
/// shifted right by half a pitch, as in OpenCV's asymmetric circle grid.
std::vector<Fiducial> ReadGrid(const YamlReader& board) {
  const YamlReader in(board.Child("grid"), board.PathOf("grid"),
                      {"columns", "rows", "pitch_m", "row_pitch_m", "staggered"});
  const int columns = in.Integer("columns", 2, 50), rows = in.Integer("rows", 2, 50);
  const double pitch = in.Number("pitch_m", Positive(2.0));
  const double row_pitch = in.NumberOr("row_pitch_m", pitch, Positive(2.0));
  const bool staggered = in.BoolOr("staggered", false);
  if (columns * rows < 6 || columns * rows > kMostDiscs) {
    board.Refuse("grid", "from 6 to " + std::to_string(kMostDiscs) + " discs");
  }
  const double width = (columns - 1 + (staggered ? 0.5 : 0.0)) * pitch;
  std::vector<Fiducial> marks;
  for (int row = 0; row < rows; ++row) {
    const double shift = staggered && row % 2 == 1 ? 0.5 * pitch : 0.0;
    for (int column = 0; column < columns; ++column) {
      marks.push_back(
          {.p_BF = {column * pitch + shift - 0.5 * width, (row - 0.5 * (rows - 1)) * row_pitch}});
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

Upright ReadUpright(const YamlReader& in) {
  constexpr std::array kWords{Upright::Against::kImage, Upright::Against::kGravity};
  return {.against =
              kWords[static_cast<std::size_t>(in.ChoiceOr("upright_in", 0, {"image", "gravity"}))],
          .within_rad = in.Degrees("upright_within_deg", Between(1.0, 180.0))};
}

void RefuseKeys(const YamlReader& in, const std::vector<std::string>& keys,
                const std::string& why) {
  for (const std::string& key : keys) {
    if (in.Has(key)) in.Refuse(key, why);
  }
}

}  // namespace

std::vector<std::string> BoardKeys(std::vector<std::string> more) {
  for (const char* key : {"kind", "width_m", "height_m", "disc_diameter_m", "bar_length_m",
                          "bar_width_m", "fiducials", "grid", "upright_in", "upright_within_deg"}) {
    more.push_back(key);
  }
  return more;
}

FiducialBoard ReadBoard(const YamlReader& in) {
  FiducialBoard board;
  const bool bars = in.ChoiceOr("kind", 0, {"bars", "plain"}) == 0;
  board.width_m = in.Number("width_m", Positive(5.0));
  board.height_m = in.Number("height_m", Positive(5.0));
  board.disc_diameter_m = in.Number("disc_diameter_m", Positive(1.0));
  if (bars) {
    RefuseKeys(in, {"grid", "upright_in", "upright_within_deg"},
               "no such key beside kind: bars, or kind: plain");
    board.bar_length_m = in.Number("bar_length_m", Positive(1.0));
    board.bar_width_m = in.Number("bar_width_m", Positive(1.0));
    if (std::hypot(board.bar_length_m, board.bar_width_m) >= board.disc_diameter_m) {
      in.Refuse("bar_length_m", "a bar whose corners lie inside the disc");
    }
  } else {
    RefuseKeys(in, {"bar_length_m", "bar_width_m"}, "no bar in a board of kind: plain");
    if (in.Has("grid") && in.Has("fiducials")) {
      in.Refuse("grid", "either grid or fiducials, not both");
    }
    board.upright = ReadUpright(in);
  }
  board.fiducials = in.Has("grid") ? ReadGrid(in) : ReadList(in, bars);
  CheckPlaces(in, board);
  bars ? CheckBarsDiffer(in, board) : CheckUprightDecides(in, board);
  return board;
}

bool IsBoardFile(const YamlNode& root) {
  return root.Find("fiducials") != nullptr || root.Find("grid") != nullptr ||
         root.Find("disc_diameter_m") != nullptr;
}

NamedBoard LoadBoard(const std::string& file) {
  const YamlNode root = LoadYaml(file);
  constexpr double kMostBow_m = 0.05;  // a bow beyond it shows no plane any more
  const YamlReader in(root, "", BoardKeys({"name", "flatness_m"}));
  return {.name = in.Text("name"),
          .board = ReadBoard(in),
          .flatness_m = in.NumberOr("flatness_m", 0.0, NonNegative(kMostBow_m))};
}

}  // namespace dockyard
