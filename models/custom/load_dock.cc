#include "models/custom/load_dock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "models/custom/load_robot.h"
#include "models/custom/take_wheels.h"
#include "models/read/config_error.h"
#include "models/read/load_board.h"
#include "models/read/load_contact.h"
#include "models/read/load_link_tree.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_pins.h"
#include "models/read/load_spreads.h"
#include "models/read/near_names.h"
#include "models/read/other_kind.h"
#include "models/read/urdf.h"
#include "models/read/yaml_reader.h"

namespace dockyard::custom {
namespace {

constexpr std::size_t kMostBoards = 8;
// A bow of more than this share of the smaller side is no board that is flat by its drawing.
// Assumed, 0.02-0.2.
constexpr double kMostBow = 0.1;

/// A board's mapping: where it is on which link, and its own file.
struct BoardFile {
  std::string name, link, file;
  Eigen::Vector3d middle_L{0, 0, 0};
  RollPitchYaw turn;  // of its normal, from the link's x axis; roll about that
  double dust = 0.0, wear = 0.0, print_scale = 1.0;
};

/// What is built off the drawing, of all boards and of all pins and pads.
struct DockErrors {
  double print_scale = 1.0, dust = 0.0, wear = 0.0;
  double flatness_m = 0.0, bow_rad = 0.0;
  RollPitchYaw board_turn;
  Eigen::Vector3d board_L{0, 0, 0}, pin_L{0, 0, 0};
  double pin_force_scale = 1.0;
};

/// Keys of the file that the model has otherwise.
struct DockFile {
  std::string urdf;
  JointsFile joints;
  std::vector<BoardFile> boards;
  PinsFile pins;
  DockErrors errors;
  double mass_scale = 1.0;
};

void VisitBoardFit(Keys& keys, BoardFile& board) {
  using enum Presence;
  keys.Text({"name", "", "for messages", kRequired}, board.name);
  keys.File({"file", "", "the board's marks (models/boards)", kRequired}, board.file);
  keys.Text({"link", "", "of the URDF file, on which it is", kRequired}, board.link);
  keys.Vector3({"middle_m", "m", "its middle in the link's frame", kRequired}, board.middle_L,
               Between(-10.0, 10.0));
  keys.Degrees({"yaw_deg", "deg", "where it faces: 0 along the link's x axis, 90 along its y axis"},
               board.turn.yaw, Between(-180.0, 180.0));
  keys.Degrees({"pitch_deg", "deg", "the same, down positive"}, board.turn.pitch,
               Between(-90.0, 90.0));
  keys.Degrees({"roll_deg", "deg", "about its normal"}, board.turn.roll, Between(-180.0, 180.0));
  keys.Number({"dust", "", "mean share of its face under dust"}, board.dust, Between(0.0, 0.6));
  keys.Number({"wear", "", "share of the ink that is gone"}, board.wear, Between(0.0, 0.6));
  keys.Number({"print_scale", "", "size of the print, over that of its file"}, board.print_scale,
              Between(0.8, 1.25));
}

void VisitPlace(Keys& keys, Pose2& place) {
  keys.Number({"x_m", "m", "of the dock off its nominal place"}, place.x, Between(-1.0, 1.0));
  keys.Number({"y_m", "m", "the same, to the left"}, place.y, Between(-1.0, 1.0));
  keys.Degrees({"yaw_deg", "deg", "the same, counter-clockwise"}, place.heading,
               Between(-45.0, 45.0));
}

// In the axes of the link that carries it.
void VisitShift(Keys& keys, const char* whose, Eigen::Vector3d& shift_L) {
  const std::array<const char*, 3> names{"x_m", "y_m", "z_m"};
  for (Eigen::Index i = 0; i < 3; ++i) {
    keys.Number({names[static_cast<std::size_t>(i)], "m", whose}, shift_L[i], Between(-0.5, 0.5));
  }
}

void VisitErrors(Keys& keys, DockErrors& errors) {
  keys.Mapping({"boards_as_built", "", ""}, [&](Keys& in) {
    in.Number({"print_scale", "", "of all boards' prints, times their own"}, errors.print_scale,
              Between(0.8, 1.25));
    in.Number({"dust", "", "share of all boards' faces under dust, more than their own"},
              errors.dust, Between(0.0, 0.6));
    in.Number({"wear", "", "share of the ink that is gone, more than their own"}, errors.wear,
              Between(0.0, 0.6));
    in.Number({"flatness_m", "m",
               "of all boards: how far the middle is out over the edges, below 0 a hollow; to "
               "a tenth of the smaller side"},
              errors.flatness_m, Between(-0.5, 0.5));
    in.Degrees({"bow_deg", "deg", "in which they bend: 0 across, 90 up"}, errors.bow_rad,
               Between(-180.0, 180.0));
    VisitShift(in, "of all boards off their places", errors.board_L);
    in.Degrees({"roll_deg", "deg", "of all boards, about their normals"}, errors.board_turn.roll,
               Between(-30.0, 30.0));
    in.Degrees({"pitch_deg", "deg", "the same, down positive"}, errors.board_turn.pitch,
               Between(-30.0, 30.0));
    in.Degrees({"yaw_deg", "deg", "the same, about the vertical"}, errors.board_turn.yaw,
               Between(-30.0, 30.0));
  });
  keys.Mapping({"pins_as_built", "", ""}, [&](Keys& in) {
    VisitShift(in, "of all pins and pads off their places", errors.pin_L);
    in.Number({"force_scale", "", "of all pins' forces"}, errors.pin_force_scale,
              Between(0.1, 10.0));
  });
}

void VisitDock(Keys& keys, DockModel& dock, DockFile& file) {
  using enum Presence;
  keys.Text({"name", "", "shown in messages", kRequired}, dock.name);
  keys.File({"urdf", "", "its links", kRequired}, file.urdf);
  keys.Bool({"fixed", "", "in the ground, as one that is screwed to a wall"}, dock.fixed);
  keys.Number({"floor_grip", "", "of its feet on the floor, a share of rubber's"}, dock.floor_grip,
              NonNegative(3.0));
  keys.Mapping(Optional("contact"),
               [&](Keys& in) { VisitContact(in, dock.contact, Presence::kDefault); });
  keys.Items({"boards", "", "boards of marks", kUnset}, file.boards, 0, kMostBoards, VisitBoardFit);
  VisitPins(keys, file.pins);
  VisitJoints(keys, file.joints);
  VisitErrors(keys, file.errors);
  keys.Mapping(Optional("place"), [&](Keys& in) { VisitPlace(in, dock.X_DD_built); });
  keys.Number({"mass_scale", "", "of all its links"}, file.mass_scale, Between(0.1, 10.0));
  NameSpreads(keys);
}

// B: x right and y down as its viewer sees it, against its normal.
Eigen::Matrix3d BoardAxes(const RollPitchYaw& turn) {
  Eigen::Matrix3d faces_x;
  faces_x << 0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  return ToRotation(turn) * faces_x;
}

Pose3 PoseOf(const BoardFile& board, const DockErrors& errors) {
  RollPitchYaw turn = board.turn;
  turn.roll += errors.board_turn.roll;
  turn.pitch += errors.board_turn.pitch;
  turn.yaw += errors.board_turn.yaw;
  return {BoardAxes(turn), board.middle_L + errors.board_L};
}

void ShiftPins(const DockErrors& errors, ElectricalParts& parts) {
  for (SpringPin& pin : parts.pins) {
    pin.p_L += errors.pin_L;
    pin.first_n *= errors.pin_force_scale;
    pin.last_n *= errors.pin_force_scale;
  }
  for (ContactPad& pad : parts.pads) pad.X_LP.p += errors.pin_L;
}

void ScalePrint(double scale, FiducialBoard& board) {
  board.disc_diameter_m *= scale;
  board.bar_length_m *= scale;
  board.bar_width_m *= scale;
  for (Fiducial& mark : board.fiducials) mark.p_BF *= scale;
  for (SquareTag& tag : board.tags) {
    tag.p_BT *= scale;
    tag.size_m *= scale;
  }
}

void CheckFlatness(const YamlReader& in, const BoardFit& fit) {
  const double most_m = kMostBow * std::min(fit.board.width_m, fit.board.height_m);
  if (std::abs(fit.flatness_m) <= most_m) return;
  const YamlNode& node = *in.Child("boards_as_built").Find("flatness_m");
  throw ConfigError(node.place.Text() + ": boards_as_built.flatness_m: expected at most " +
                    NumberText(std::round(1e5 * most_m) / 1e5) +
                    " m to either side, a tenth of the smaller side of board '" + fit.name +
                    "', found " + node.Found());
}

void TakeBoards(const YamlReader& in, const DockFile& file, DockModel& dock) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < file.boards.size(); ++i) {
    const BoardFile& each = file.boards[i];
    TakeName(each.name, PlaceInList(in, "boards", i, "name"), names);
    const NamedFrame& frame =
        RequireFrame(dock.tree, each.link, PlaceInList(in, "boards", i, "link"));
    BoardFit fit{.name = each.name,
                 .board = LoadBoard(each.file).board,
                 .link = frame.link,
                 .X_LB = frame.X_LF * PoseOf(each, file.errors),
                 .dust = std::min(0.6, each.dust + file.errors.dust),
                 .wear = std::min(0.6, each.wear + file.errors.wear),
                 .flatness_m = file.errors.flatness_m,
                 .bow_rad = file.errors.bow_rad};
    CheckFlatness(in, fit);
    ScalePrint(each.print_scale * file.errors.print_scale, fit.board);
    dock.boards.push_back(std::move(fit));
  }
}

// So that what is built may differ from what is left out.
void PutErrorsIfLeftOut(YamlNode& root) {
  for (const char* key :
       {"place.x_m", "place.y_m", "place.yaw_deg", "boards_as_built.dust", "boards_as_built.wear",
        "boards_as_built.flatness_m", "boards_as_built.bow_deg", "boards_as_built.x_m",
        "boards_as_built.y_m", "boards_as_built.z_m", "boards_as_built.roll_deg",
        "boards_as_built.pitch_deg", "boards_as_built.yaw_deg", "pins_as_built.x_m",
        "pins_as_built.y_m", "pins_as_built.z_m"}) {
    PutIfLeftOut(root, key, 0.0);
  }
  for (const char* key :
       {"mass_scale", "boards_as_built.print_scale", "pins_as_built.force_scale"}) {
    PutIfLeftOut(root, key, 1.0);
  }
}

DockModel ReadDockFile(const std::string& path, const ModelChanges& changes, MeshStore* meshes) {
  YamlNode root = LoadModelYaml(path);
  if (root.Find("wheels") != nullptr)
    throw ConfigError(path + ": expected a dock's file, found a robot's: it has wheels");
  if (changes.nominal != nullptr) MergeYaml(root, *changes.nominal);
  PutErrorsIfLeftOut(root);
  if (changes.built != nullptr) PutBuilt(root, *changes.built);
  DockModel dock;
  DockFile file;
  const auto visit = [&](Keys& keys) { VisitDock(keys, dock, file); };
  ReadKeys(root, "", visit);
  const YamlReader in(root, "", KeyNames(visit));
  dock.tree = TakeLinkTree(in, LoadUrdf(file.urdf, meshes), file.joints);
  ScaleMass(file.mass_scale, dock.tree);
  TakeBoards(in, file, dock);
  dock.electrical = TakePins(in, file.pins, [&](const std::string& name, const std::string& place) {
    const NamedFrame& frame = RequireFrame(dock.tree, name, place);
    return LinkPlace{frame.link, frame.X_LF};
  });
  ShiftPins(file.errors, dock.electrical);
  CheckSpreads(root);
  return dock;
}

}  // namespace

void VisitDockKeys(Keys& keys) {
  DockModel dock;
  DockFile file;
  VisitDock(keys, dock, file);
}

bool IsDockFile(const YamlNode& root) {
  return root.Find("urdf") != nullptr && root.Find("boards") != nullptr &&
         root.Find("wheels") == nullptr;
}

DockModel LoadDock(const std::string& file, const ModelChanges& changes, MeshStore* meshes) {
  return Advising(kGoOn, [&] { return ReadDockFile(file, changes, meshes); });
}

}  // namespace dockyard::custom
