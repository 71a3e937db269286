#include "models/axel/load_station.h"

#include <cmath>
#include <limits>
#include <string_view>

#include "models/axel/mating_fit.h"
#include "models/read/config_error.h"
#include "models/read/load_board.h"
#include "models/read/load_contact.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_mounting.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/text_file.h"
#include "models/read/urdf.h"
#include "models/read/urdf_weld.h"
#include "models/read/yaml_reader.h"

namespace dockyard::axel {
namespace {

void VisitCone(Keys& keys, ConeModel& cone) {
  keys.Number("mouth_radius_m", cone.mouth_radius_m, Positive(2.0));
  keys.Number("funnel_length_m", cone.funnel_length_m, Positive(2.0));
  keys.Number("throat_radius_m", cone.throat_radius_m, Positive(2.0));
  keys.Number("socket_end_m", cone.socket_end_m, Positive(5.0));
  keys.Number(Optional("stop_depth_m"), cone.stop_depth_m, NonNegative(5.0));
  keys.Number("face_outer_radius_m", cone.face_outer_radius_m, Positive(2.0));
  keys.Number("funnel_friction", cone.funnel_friction, NonNegative(2.0));
  keys.Number("face_friction", cone.face_friction, NonNegative(2.0));
  keys.Number(Unset("rated_force_n"), cone.rated_force_n, Positive(1e6));
  keys.Number("contact_stiffness_n_per_m", cone.contact_stiffness_n_per_m, Between(1e3, 1e7));
  keys.Number("contact_damping_ns_per_m", cone.contact_damping_ns_per_m, NonNegative(1e6));
  keys.Check("throat_radius_m", cone.throat_radius_m < cone.mouth_radius_m,
             "less than mouth_radius_m");
  keys.Check("face_outer_radius_m", cone.face_outer_radius_m > cone.mouth_radius_m,
             "more than mouth_radius_m");
  keys.Check("stop_depth_m", cone.stop_depth_m <= 0.0 || cone.stop_depth_m >= cone.funnel_length_m,
             "0 or at least funnel_length_m");
  keys.Check("socket_end_m", cone.socket_end_m >= cone.funnel_length_m, "at least funnel_length_m");
}

/// Keys of the file that the model has otherwise.
struct StationFile {
  bool board_named = false;  // the board's mapping names its file
  std::string urdf, board;
  double mass_kg = kNone, mouth_height_m = kNone;  // NaN: as the URDF has it

  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
};

/// The board inline, or by the name of its file; the station places it.
void VisitBoardOf(Keys& keys, StationModel& station, StationFile& file) {
  keys.Number("height_above_axis_m", station.board_height_above_axis_m, Between(-2.0, 2.0));
  VisitMounting(keys, station.board_mounting);
  if (file.board_named) {
    keys.File("file", file.board);
  } else {
    VisitBoard(keys, station.board);
  }
}

void FinishBoard(const YamlReader& root, StationModel& station, StationFile& file) {
  const YamlNode& node = root.Child("board");
  const YamlReader in(node, "board",
                      KeyNames([&](Keys& keys) { VisitBoardOf(keys, station, file); }));
  if (file.board_named) {
    station.board = LoadBoard(file.board).board;
    if (!station.board.tags.empty()) {
      in.Refuse("file", "a board of discs, as the rover's controller finds no tags");
    }
  } else {
    CheckBoard(in, station.board);
  }
  const BoardCutout cutout = CutoutOf(station);
  const double least_m = 0.5 * station.board.disc_diameter_m + cutout.radius_m;
  for (std::size_t i = 0; i < station.board.fiducials.size(); ++i) {
    const double overlap_m = least_m - (station.board.fiducials[i].p_BF - cutout.p_B).norm();
    if (overlap_m <= 0.0) continue;
    const bool listed = !file.board_named && in.Has("fiducials");
    const YamlNode& place = listed ? in.Child("fiducials").items[i] : node;
    throw ConfigError(place.place.Text() + ": " + YamlReader::PathOf(in.PathOf("fiducials"), i) +
                      ": expected a disc clear of the cone's mouth and face, it overlaps by " +
                      NumberText(std::round(1e4 * overlap_m) / 1e4) + " m");
  }
}

void VisitFeet(Keys& keys, StationModel& station) {
  keys.Items("soles_m", station.feet, 3, 16, [](Keys& in, FootModel& foot) {
    in.Number("x", foot.p_SF.x(), Between(-5.0, 5.0));
    in.Number("y", foot.p_SF.y(), Between(-5.0, 5.0));
  });
  keys.Number("friction", station.foot_friction, NonNegative(3.0));
  keys.Number("stiffness_n_per_m", station.foot_stiffness_n_per_m, Between(1e3, 1e8));
  keys.Number(Optional("damping_ratio"), station.foot_damping_ratio, NonNegative(5.0));
  keys.Number(Optional("sole_diameter_m"), station.sole_diameter_m, NonNegative(0.3));
}

void YieldAsTheCone(StationModel& station) {
  station.body_contact.stiffness_n_per_m = station.cone.contact_stiffness_n_per_m;
  station.body_contact.damping_ns_per_m = station.cone.contact_damping_ns_per_m;
}

void VisitStation(Keys& keys, StationModel& station, StationFile& file) {
  keys.Text("name", station.name);
  keys.Degrees("tip_angle_deg", station.tip_angle_rad, Between(0.0, 30.0));
  keys.Mapping("cone", [&](Keys& in) { VisitCone(in, station.cone); });
  keys.Mapping(Optional("body_contact"), [&](Keys& in) {
    if (in.reads()) YieldAsTheCone(station);
    VisitContact(in, station.body_contact, Presence::kDefault);
  });
  keys.Mapping("board", [&](Keys& in) { VisitBoardOf(in, station, file); });
  keys.Number("anchor_depth_m", station.anchor_depth_m, Positive(5.0));
  keys.Mapping("feet", [&](Keys& in) { VisitFeet(in, station); });
  keys.File("urdf", file.urdf);
  if (keys.reads()) {
    keys.Number(Unset("mouth_height_m"), file.mouth_height_m, Positive(5.0));
  } else {  // or `from_axle`: FitMouth
    YamlNode either;
    keys.Tree(Unset("mouth_height_m"), either, YamlNode::Kind::kNull);
  }
  keys.Number(Unset("mass_kg"), file.mass_kg, Between(0.1, 1e5));
  NameSpreads(keys);
}

/// The station must stand: the weight must fall between the soles, else it topples by itself.
void CheckStands(const YamlReader& in, const StationModel& station) {
  Eigen::Vector2d low = station.feet[0].p_SF.head<2>(), high = low;
  for (const FootModel& foot : station.feet) {
    low = low.cwiseMin(foot.p_SF.head<2>());
    high = high.cwiseMax(foot.p_SF.head<2>());
  }
  const Pose3 X_SM = MouthInStation(station);
  const Eigen::Vector3d p_MCom =
      station.module.p_LoCom_L - Eigen::Vector3d(0.0, 0.0, station.mouth_height_m);
  const Eigen::Vector2d com = (X_SM * p_MCom).head<2>();
  if ((com.array() <= low.array()).any() || (com.array() >= high.array()).any()) {
    in.Refuse("feet", "soles on both sides of the centre of mass at x " + NumberText(com.x()) +
                          ", y " + NumberText(com.y()));
  }
}

/// The model with fixed links welded: the stand, which is only drawn, and the module on it.
UrdfModel WeldStation(const UrdfModel& urdf) {
  for (std::size_t i = 0; i < urdf.links.size(); ++i) {
    const LinkModel& link = urdf.links[i];
    if (CarrierOf(urdf, link.name) != "stand") continue;
    if (link.mass_kg == 0.0 && link.collisions.empty()) continue;
    throw ConfigError(urdf.place[i] +
                      ": expected neither <inertial> nor <collision>: mass and shape of the whole "
                      "station are the module's, the stand and what is fixed to it is drawn");
  }
  if (urdf.Joint("tilt_joint").type == "fixed") return urdf;  // TakeLinks refuses it
  UrdfModel welded = WeldFixedLinks(urdf);
  RequireJoints(welded, {"tilt_joint"}, "'stand' and 'module'");
  return welded;
}

/// mass_kg and mouth_height_m of the file, where given, stand instead of the URDF's.
void TakeLinks(const StationFile& file, const UrdfModel& drawn, StationModel& station) {
  const UrdfModel urdf = WeldStation(drawn);
  UrdfJoint tilt = urdf.Joint("tilt_joint");
  const bool fits = urdf.root == "stand" && tilt.parent == "stand" && tilt.child == "module" &&
                    tilt.type == "revolute" && tilt.axis_J == Eigen::Vector3d::UnitY() &&
                    tilt.X_PJ.R.isIdentity(1e-9) && tilt.X_PJ.p.head<2>().norm() < 1e-9 &&
                    tilt.X_PJ.p.z() > 0.0;
  if (!fits) {
    throw ConfigError(tilt.place +
                      ": expected a revolute joint about 0 1 0 from the root link 'stand' to "
                      "'module', its origin straight above the stand's");
  }
  if (!std::isnan(file.mouth_height_m)) tilt.X_PJ.p.z() = file.mouth_height_m;
  station.mouth_height_m = tilt.X_PJ.p.z();
  station.stand_visuals = urdf.Link("stand").visuals;
  station.module = RequireInertial(urdf, "module");
  const double mass_kg = std::isnan(file.mass_kg) ? station.module.mass_kg : file.mass_kg;
  const double scale = mass_kg / station.module.mass_kg;
  station.module.mass_kg *= scale;
  station.module.I_LCom_L *= scale;
  // From the mouth's frame, where the joint has it, to S.
  station.module.p_LoCom_L = tilt.X_PJ * station.module.p_LoCom_L;
  for (Visual& visual : station.module.visuals) visual.X_LV = tilt.X_PJ * visual.X_LV;
  for (Collision& part : station.module.collisions) part.X_LG = tilt.X_PJ * part.X_LG;
}

StationModel ReadStationKeys(const YamlNode& tree, MeshStore* meshes) {
  StationModel station;
  StationFile file;
  const YamlNode* board = tree.Find("board");
  file.board_named = board != nullptr && board->Find("file") != nullptr;
  const auto visit = [&](Keys& keys) { VisitStation(keys, station, file); };
  ReadKeys(tree, "", visit);
  if (tree.Find("body_contact") == nullptr) YieldAsTheCone(station);
  const YamlReader in(tree, "", KeyNames(visit));
  FinishBoard(in, station, file);
  TakeLinks(file, LoadUrdf(file.urdf, meshes), station);
  CheckStands(in, station);
  const double lowest = station.mouth_height_m - station.cone.face_outer_radius_m;
  if (lowest <= 0.0) in.Refuse("cone", "a face that clears the ground below the mouth");
  return station;
}

StationModel ReadStation(const YamlNode& tree, MeshStore* meshes) {
  return AdvisingOtherKinds("target", [&] { return ReadStationKeys(tree, meshes); });
}

constexpr std::string_view kMouthHeight = "mouth_height_m";

/// `mouth_height_m: from_axle` becomes the height that fits the rover. Without a rover the key
/// falls away.
void FitMouth(const RoverModel* rover, MeshStore* meshes, YamlNode& tree) {
  const YamlNode* height = tree.Find(kMouthHeight);
  if (height == nullptr || height->scalar != "from_axle") return;
  const auto at = height - tree.items.data();
  const YamlNode::Key key = tree.keys[static_cast<std::size_t>(at)];
  tree.keys.erase(tree.keys.begin() + at);
  tree.items.erase(tree.items.begin() + at);
  if (rover == nullptr) return;
  const StationModel station = ReadStation(tree, meshes);
  const double fitting_m =
      FittingMouthHeight(*rover, MeanAxleHeight(*rover), station.cone, station.tip_angle_rad);
  PutIfLeftOut(tree, key.name, std::round(1e4 * fitting_m) / 1e4);
}

/// Numbers that a file may leave out, so that what is built can deviate from them too.
void WriteLeftOut(const StationModel& told, YamlNode& tree) {
  PutIfLeftOut(tree, "mass_kg", told.module.mass_kg);
  PutIfLeftOut(tree, "mouth_height_m", told.mouth_height_m);
  PutIfLeftOut(tree, "cone.stop_depth_m", 0.0);
  PutIfLeftOut(tree, "feet.sole_diameter_m", 0.0);
  PutMountingIfLeftOut(tree, "board.mounting");
}

}  // namespace

void VisitStationKeys(Keys& keys) {
  StationModel station;
  StationFile file;
  VisitStation(keys, station, file);
}

StationModel LoadStation(const std::string& file, const ModelChanges& changes, MeshStore* meshes,
                         const RoverModel* docked_by) {
  YamlNode tree = LoadModelYaml(file);
  if (changes.nominal != nullptr) MergeYaml(tree, *changes.nominal);
  FitMouth(docked_by, meshes, tree);
  const StationModel told = ReadStation(tree, meshes);
  WriteLeftOut(told, tree);
  CheckSpreads(tree);
  if (changes.built == nullptr) return told;
  PutBuilt(tree, *changes.built);
  return ReadStation(tree, meshes);
}

}  // namespace dockyard::axel
