#include "models/load_station.h"

#include <array>
#include <cmath>

#include "models/config_error.h"
#include "models/text_file.h"
#include "models/urdf.h"
#include "models/urdf_weld.h"
#include "models/yaml_reader.h"

namespace dockyard {
namespace {

void ReadCone(const YamlReader& root, ConeModel& cone) {
  const YamlReader in(root.Child("cone"), "cone",
                      {"mouth_radius_m", "funnel_length_m", "throat_radius_m", "socket_end_m",
                       "stop_depth_m", "face_outer_radius_m", "wedges", "funnel_friction",
                       "face_friction", "contact_stiffness_n_per_m", "contact_damping_ns_per_m"});
  cone.mouth_radius_m = in.Number("mouth_radius_m", Positive(2.0));
  cone.funnel_length_m = in.Number("funnel_length_m", Positive(2.0));
  cone.throat_radius_m = in.Number("throat_radius_m", Positive(2.0));
  cone.socket_end_m = in.Number("socket_end_m", Positive(5.0));
  cone.stop_depth_m = in.NumberOr("stop_depth_m", 0.0, NonNegative(5.0));
  cone.face_outer_radius_m = in.Number("face_outer_radius_m", Positive(2.0));
  cone.wedges = in.Integer("wedges", 8, 256);
  cone.funnel_friction = in.Number("funnel_friction", NonNegative(2.0));
  cone.face_friction = in.Number("face_friction", NonNegative(2.0));
  cone.contact_stiffness_n_per_m = in.Number("contact_stiffness_n_per_m", Between(1e3, 1e7));
  cone.contact_damping_ns_per_m = in.Number("contact_damping_ns_per_m", NonNegative(1e6));
  if (cone.throat_radius_m >= cone.mouth_radius_m) {
    in.Refuse("throat_radius_m", "less than mouth_radius_m");
  }
  if (cone.face_outer_radius_m <= cone.mouth_radius_m) {
    in.Refuse("face_outer_radius_m", "more than mouth_radius_m");
  }
  if (cone.stop_depth_m > 0.0 && cone.stop_depth_m < cone.funnel_length_m) {
    in.Refuse("stop_depth_m", "0 or at least funnel_length_m");
  }
  if (cone.socket_end_m < cone.funnel_length_m) {
    in.Refuse("socket_end_m", "at least funnel_length_m");
  }
}

/// The four rotations of Tsai et al., III-A, exactly as written.
double ReadRotation(const YamlReader& mark) {
  constexpr std::array<double, 4> kRotations{-kPi / 4, 0.0, kPi / 4, kPi / 2};
  return kRotations[static_cast<std::size_t>(
      mark.Choice("rotation_deg", {"-45", "0", "45", "90"}))];
}

void CheckMarks(const YamlReader& board_in, const std::vector<Fiducial>& marks,
                const FiducialBoard& board, const BoardCutout& cutout) {
  const double radius = 0.5 * board.disc_diameter_m;
  const auto refuse = [&](std::size_t i, const std::string& why) {
    const YamlNode& node = board_in.Child("fiducials").items[i];
    throw ConfigError(node.place.Text() + ": " +
                      YamlReader::PathOf(board_in.PathOf("fiducials"), i) + ": " + why);
  };
  std::array<int, 4> count{};
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Eigen::Vector2d& p = marks[i].p_BF;
    if (std::abs(p.x()) + radius > 0.5 * board.width_m ||
        std::abs(p.y()) + radius > 0.5 * board.height_m) {
      refuse(i, "expected a disc inside the board, it sticks out");
    }
    if ((p - cutout.p_B).norm() < radius + cutout.radius_m) {
      refuse(i,
             "expected a disc clear of the cone's mouth and face, it overlaps by " +
                 NumberText(std::round(1e4 * (radius + cutout.radius_m - (p - cutout.p_B).norm())) /
                            1e4) +
                 " m");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if ((p - marks[k].p_BF).norm() < 2.0 * radius) {
        refuse(i, "expected a disc clear of the others, it overlaps number " + std::to_string(k));
      }
    }
    count[static_cast<std::size_t>(std::lround(marks[i].rotation / (kPi / 4))) + 1] += 1;
  }
  for (const int of_one_rotation : count) {
    if (of_one_rotation != 2) board_in.Refuse("fiducials", "two fiducials of each rotation");
  }
}

void ReadBoard(const YamlReader& root, StationModel& station) {
  const YamlReader in(root.Child("board"), "board",
                      {"width_m", "height_m", "height_above_axis_m", "disc_diameter_m",
                       "bar_length_m", "bar_width_m", "fiducials"});
  FiducialBoard& board = station.board;
  board.width_m = in.Number("width_m", Positive(5.0));
  board.height_m = in.Number("height_m", Positive(5.0));
  board.disc_diameter_m = in.Number("disc_diameter_m", Positive(1.0));
  board.bar_length_m = in.Number("bar_length_m", Positive(1.0));
  board.bar_width_m = in.Number("bar_width_m", Positive(1.0));
  station.board_height_above_axis_m = in.Number("height_above_axis_m", Between(-2.0, 2.0));
  if (std::hypot(board.bar_length_m, board.bar_width_m) >= board.disc_diameter_m) {
    in.Refuse("bar_length_m", "a bar whose corners lie inside the disc");
  }
  const YamlNode& list = in.List("fiducials", 8, 8);
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlReader mark(list.items[i], YamlReader::PathOf(in.PathOf("fiducials"), i),
                          {"x_m", "y_m", "rotation_deg"});
    Fiducial fiducial;
    fiducial.p_BF = {mark.Number("x_m", Between(-3.0, 3.0)),
                     mark.Number("y_m", Between(-3.0, 3.0))};
    fiducial.rotation = ReadRotation(mark);
    board.fiducials.push_back(fiducial);
  }
  CheckMarks(in, board.fiducials, board, CutoutOf(station));
}

void ReadFeet(const YamlReader& root, StationModel& station) {
  const YamlReader in(root.Child("feet"), "feet", {"soles_m", "friction", "stiffness_n_per_m"});
  const YamlNode& list = in.List("soles_m", 3, 16);
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlReader sole(list.items[i], YamlReader::PathOf(in.PathOf("soles_m"), i), {"x", "y"});
    station.feet.push_back({Eigen::Vector3d(sole.Number("x", Between(-5.0, 5.0)),
                                            sole.Number("y", Between(-5.0, 5.0)), 0.0)});
  }
  station.foot_friction = in.Number("friction", NonNegative(3.0));
  station.foot_stiffness_n_per_m = in.Number("stiffness_n_per_m", Between(1e3, 1e8));
}

/// Standing: the weight must fall between the soles, else the station topples by itself.
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

/// The model with fixed links welded: the stand, which only stands there, and the module on it.
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
void TakeLinks(const YamlReader& in, const UrdfModel& file, StationModel& station) {
  const UrdfModel urdf = WeldStation(file);
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
  tilt.X_PJ.p.z() = in.NumberOr("mouth_height_m", tilt.X_PJ.p.z(), Positive(5.0));
  station.mouth_height_m = tilt.X_PJ.p.z();
  station.stand_visuals = urdf.Link("stand").visuals;
  station.module = urdf.Link("module");
  if (!(station.module.mass_kg > 0.0)) {
    throw ConfigError(urdf.PlaceOf("module") + ": expected an <inertial>, found none");
  }
  const double scale =
      in.NumberOr("mass_kg", station.module.mass_kg, Between(0.1, 1e5)) / station.module.mass_kg;
  station.module.mass_kg *= scale;
  station.module.I_LCom_L *= scale;
  // From the mouth's frame, where the joint has it, to S.
  station.module.p_LoCom_L = tilt.X_PJ * station.module.p_LoCom_L;
  for (Visual& visual : station.module.visuals) visual.X_LV = tilt.X_PJ * visual.X_LV;
  for (Collision& part : station.module.collisions) part.X_LG = tilt.X_PJ * part.X_LG;
}

}  // namespace

StationModel LoadStation(const std::string& file, const YamlNode* changes) {
  YamlNode tree = LoadYaml(file);
  if (changes != nullptr) MergeYaml(tree, *changes);
  const YamlReader in(tree, "",
                      {"name", "urdf", "tip_angle_deg", "cone", "board", "anchor_depth_m", "feet",
                       "mass_kg", "mouth_height_m"});
  StationModel station;
  station.name = in.Text("name");
  station.tip_angle_rad = in.Degrees("tip_angle_deg", Between(0.0, 30.0));
  ReadCone(in, station.cone);
  ReadBoard(in, station);
  station.anchor_depth_m = in.Number("anchor_depth_m", Positive(5.0));
  ReadFeet(in, station);
  TakeLinks(in, LoadUrdf(in.File("urdf")), station);
  CheckStands(in, station);
  const double lowest = station.mouth_height_m - station.cone.face_outer_radius_m;
  if (lowest <= 0.0) in.Refuse("cone", "a face that clears the ground below the mouth");
  return station;
}

}  // namespace dockyard
