#include "models/axel/load_axel.h"

#include <cmath>
#include <limits>
#include <utility>

#include "models/axel/own_view.h"
#include "models/axel/rover_changes.h"
#include "models/axel/rover_links.h"
#include "models/axel/urdf_agreement.h"
#include "models/read/config_error.h"
#include "models/read/load_contact.h"
#include "models/read/load_joints.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_motor.h"
#include "models/read/load_spreads.h"
#include "models/read/load_wheel.h"
#include "models/read/other_kind.h"
#include "models/read/read_imu.h"
#include "models/read/read_stereo.h"
#include "models/read/urdf.h"
#include "models/read/yaml_reader.h"

namespace dockyard::axel {
namespace {

// A cable's masses must be some.
constexpr double kLightestCable_kg_per_m = 0.001;

/// Keys of the file that the model has otherwise.
struct RoverFile {
  std::string urdf;
  StereoFile cameras;
  JointsFile joints;
  // In which a rover may differ from what it was drawn for; NaN: as drawn.
  double left_radius_scale = 1.0, right_radius_scale = 1.0, arm_offset_m = 0.0, mass_scale = 1.0;
  double track_m = kNone, body_com_x_m = kNone;

  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
};

void VisitMotors(Keys& keys, RoverModel& rover) {
  MotorModel& left = rover.motors[static_cast<int>(Motor::kLeftWheel)];
  MotorModel& right = rover.motors[static_cast<int>(Motor::kRightWheel)];
  keys.Mapping("wheel", [&](Keys& in) { VisitMotor(in, left); });
  right = left;  // a side's own keys come on top
  keys.Mapping(Unset("left_wheel"), [&](Keys& in) { VisitMotor(in, left, Presence::kDefault); });
  keys.Mapping(Unset("right_wheel"), [&](Keys& in) { VisitMotor(in, right, Presence::kDefault); });
  keys.Mapping("arm",
               [&](Keys& in) { VisitMotor(in, rover.motors[static_cast<int>(Motor::kArm)]); });
  keys.Mapping("spool",
               [&](Keys& in) { VisitMotor(in, rover.motors[static_cast<int>(Motor::kSpool)]); });
}

void VisitWheels(Keys& keys, RoverModel& rover, RoverFile& file) {
  WheelModel &left = rover.left_wheel_soil, &right = rover.right_wheel_soil;
  VisitWheelShape(keys, left);
  right = left;
  keys.Degrees(Optional("left_phase_deg"), left.phase_rad, Between(-180.0, 180.0));
  keys.Degrees(Optional("right_phase_deg"), right.phase_rad, Between(-180.0, 180.0));
  keys.Number(Optional("left_radius_scale"), file.left_radius_scale, Between(0.5, 2.0));
  keys.Number(Optional("right_radius_scale"), file.right_radius_scale, Between(0.5, 2.0));
  keys.Number(Unset("track_m"), file.track_m, Between(0.05, 10.0));
}

void VisitCollar(Keys& keys, RoverModel& rover) {
  CollarModel& collar = rover.collar;
  keys.Number("radius_m", collar.radius_m, Positive(0.5));
  keys.Number("front_m", collar.front_m, Positive(5.0));
  keys.Number("front_radius_m", collar.front_radius_m, Between(0.002, 0.5));
  keys.Number("lead_in_m", collar.lead_in_m, Between(0.002, 1.0));
  keys.Number("length_m", collar.length_m, Between(0.002, 1.0));
  keys.Check("front_m", collar.front_m <= rover.arm_length_m - rover.tip.length_m,
             "at most length_m - tip_length_m: a collar behind the tip");
  keys.Check("length_m", collar.lead_in_m + collar.length_m < collar.front_m,
             "a collar that ends before the axle");
  keys.Check("front_radius_m", collar.front_radius_m <= collar.radius_m,
             "at most radius_m: the lead-in widens backwards");
}

void VisitArm(Keys& keys, RoverModel& rover, RoverFile& file) {
  keys.Number("length_m", rover.arm_length_m, Positive(5.0));
  keys.Degrees("at_power_on_deg", rover.arm_at_power_on_rad, Between(-180.0, 180.0));
  keys.Number("tip_radius_m", rover.tip.radius_m, Positive(0.5));
  keys.Number("tip_length_m", rover.tip.length_m, Positive(1.0));
  keys.Number("ground_friction", rover.tip.ground_friction, NonNegative(2.0));
  keys.Number("ground_stiffness_n_per_m", rover.tip.ground_stiffness_n_per_m, Between(100.0, 1e6));
  keys.Number(Optional("ground_damping_ratio"), rover.tip.ground_damping_ratio, NonNegative(5.0));
  keys.Check("tip_length_m", rover.tip.length_m < rover.arm_length_m, "less than length_m");
  keys.Mapping(Unset("collar"), [&](Keys& in) { VisitCollar(in, rover); });
  keys.Number(Optional("offset_m"), file.arm_offset_m, Between(-1.0, 1.0));
  keys.Mapping(Optional("stop"),
               [&](Keys& in) { VisitStop(in, rover.arm_stop, Presence::kDefault); });
}

void VisitTether(Keys& keys, TetherModel& tether) {
  keys.Choice(Optional("law"), tether.law, {"massless", "cable"});
  keys.Number("axial_stiffness_n", tether.axial_stiffness_n, Between(100.0, 1e6));
  keys.Number("damping_ns_per_m", tether.damping_ns_per_m, NonNegative(1e5));
  keys.Number("diameter_m", tether.diameter_m, Positive(0.05));
  keys.Number("mass_kg_per_m", tether.mass_kg_per_m, NonNegative(5.0));
  keys.Number("friction_on_station", tether.friction_on_station, NonNegative(2.0));
  tether.friction_on_ground = 0.5;
  tether.friction_on_rock = tether.friction_on_rover = 0.4;
  keys.Number(Optional("friction_on_ground"), tether.friction_on_ground, NonNegative(2.0));
  keys.Number(Optional("friction_on_rock"), tether.friction_on_rock, NonNegative(2.0));
  keys.Number(Optional("friction_on_rover"), tether.friction_on_rover, NonNegative(2.0));
  keys.Check("mass_kg_per_m",
             tether.law != TetherLaw::kCable || tether.mass_kg_per_m >= kLightestCable_kg_per_m,
             "at least 0.001 for the law 'cable'");
  keys.Number("drum_radius_m", tether.drum_radius_m, Between(0.005, 0.5));
  keys.Number(Optional("drum_growth_m_per_turn"), tether.drum_growth_m_per_turn,
              keys.Limits(NonNegative(0.1 * tether.drum_radius_m), NonNegative(0.05)));
}

void VisitTetherSensor(Keys& keys, TetherSensorModel& sensor) {
  keys.Number(Optional("tension_noise_n"), sensor.tension_noise_n, NonNegative(1e3));
  keys.Number(Optional("tension_offset_n"), sensor.tension_offset_n, NonNegative(1e3));
  keys.Number(Optional("tension_scale_share"), sensor.tension_scale_share, NonNegative(0.5));
  keys.Degrees(Optional("direction_noise_deg"), sensor.direction_noise_rad, NonNegative(45.0));
  keys.Degrees(Optional("direction_offset_deg"), sensor.direction_offset_rad, NonNegative(45.0));
}

void VisitRover(Keys& keys, RoverModel& rover, RoverFile& file) {
  keys.Text("name", rover.name);
  keys.Mapping("wheels", [&](Keys& in) { VisitWheels(in, rover, file); });
  keys.Mapping("motors", [&](Keys& in) { VisitMotors(in, rover); });
  keys.Mapping("arm", [&](Keys& in) { VisitArm(in, rover, file); });
  keys.Mapping(Optional("rock_contact"),
               [&](Keys& in) { VisitYield(in, rover.rock_contact, Presence::kDefault); });
  keys.Mapping("tether", [&](Keys& in) { VisitTether(in, rover.tether); });
  keys.Mapping(Unset("tether_sensor"), [&](Keys& in) {
    VisitTetherSensor(in,
                      rover.tether_sensor ? *rover.tether_sensor : rover.tether_sensor.emplace());
  });
  keys.Mapping("imu", [&](Keys& in) { VisitImu(in, rover.imu); });
  VisitStereo(keys, "cameras", file.cameras);
  keys.File("urdf", file.urdf);
  VisitJoints(keys, file.joints);
  keys.Number(Optional("mass_scale"), file.mass_scale, Between(0.1, 10.0));
  keys.Number(Unset("body_com_x_m"), file.body_com_x_m, Between(-1.0, 1.0));
  NameSpreads(keys);
}

/// What the URDF must agree with: the numbers that it holds too, and its links.
RoverModel ReadDrawn(const YamlNode& tree, const UrdfModel& urdf) {
  RoverModel rover;
  RoverFile file;
  const YamlReader in(tree, "", KeyNames(VisitRoverKeys));
  ReadKeys(in.Child("wheels"), "wheels", [&](Keys& keys) { VisitWheels(keys, rover, file); });
  ReadKeys(in.Child("arm"), "arm", [&](Keys& keys) { VisitArm(keys, rover, file); });
  TakeRoverLinks(urdf, rover);
  CheckArm(urdf, rover);
  RequireAgreement(in, rover);
  return rover;
}

/// The cameras that the URDF was drawn for.
StereoFile ReadDrawnCameras(const YamlNode& tree) {
  StereoFile cameras;
  YamlNode alone;
  alone.kind = YamlNode::Kind::kMapping;
  alone.keys.push_back({"cameras", {}});
  alone.items.push_back(*tree.Find("cameras"));
  ReadKeys(alone, "", [&](Keys& keys) { VisitStereo(keys, "cameras", cameras); });
  return cameras;
}

/// Cameras that have the rover itself before them would end as a run without a detection.
void RequireView(const YamlReader& in, const RoverModel& rover) {
  const std::string blinded = BlindedBy(rover);
  if (blinded.empty()) return;
  const YamlNode& cameras = in.Child("cameras");
  const char* key = cameras.Find("forward_m") != nullptr ? "forward_m" : "file";
  const YamlNode* node = cameras.Find(key);
  throw ConfigError((node != nullptr ? node : &cameras)->place.Text() + ": cameras." + key +
                    ": expected cameras with at most half of an image filled by the rover's own "
                    "body, found " +
                    blinded);
}

/// Numbers in which a rover may differ from what it was drawn for.
void Differ(const RoverFile& file, RoverModel& rover) {
  for (const auto& [scale, wheel] : {std::pair(file.left_radius_scale, &rover.left_wheel_soil),
                                     std::pair(file.right_radius_scale, &rover.right_wheel_soil)}) {
    wheel->rim_radius_m *= scale;
    wheel->paddle_height_m *= scale;
  }
  rover.arm_length_m += file.arm_offset_m;
  rover.collar.front_m += file.arm_offset_m;
}

void TakeLinks(const YamlReader& in, const RoverFile& file, const RoverModel& drawn,
               RoverModel& rover) {
  rover.body = drawn.body;
  rover.left_wheel = drawn.left_wheel;
  rover.right_wheel = drawn.right_wheel;
  rover.arm = drawn.arm;
  rover.arm_lower_rad = drawn.arm_lower_rad;
  rover.arm_upper_rad = drawn.arm_upper_rad;
  FitLinks(in, drawn, rover);
  const double track_m = std::isnan(file.track_m) ? drawn.track_m() : file.track_m;
  rover.p_R_left_wheel = Eigen::Vector3d(0.0, 0.5 * track_m, 0.0);
  rover.p_R_right_wheel = -rover.p_R_left_wheel;
  const auto weigh = [&](LinkModel& link) {
    link.mass_kg *= file.mass_scale;
    link.I_LCom_L *= file.mass_scale;
  };
  for (LinkModel* link : {&rover.body, &rover.left_wheel, &rover.right_wheel, &rover.arm}) {
    weigh(*link);
  }
  for (JointedLink& each : rover.further.links) {
    weigh(each.link);
    // What the arm carries is mounted further out with it.
    if (each.carrier == kArmNumber) each.X_PL.p.x() += rover.arm_length_m - drawn.arm_length_m;
  }
  for (LinkPin& pin : rover.further.pins) {
    if (pin.a == kArmNumber) pin.p_A.x() += rover.arm_length_m - drawn.arm_length_m;
  }
  if (!std::isnan(file.body_com_x_m)) rover.body.p_LoCom_L.x() = file.body_com_x_m;
}

RoverModel ReadRoverKeys(const YamlNode& tree, const YamlNode& drawn_by, int image_width,
                         int image_height, MeshStore* meshes) {
  RoverModel rover;
  RoverFile file;
  const auto visit = [&](Keys& keys) { VisitRover(keys, rover, file); };
  ReadKeys(tree, "", visit);
  const YamlReader in(tree, "", KeyNames(visit));
  rover.stereo = StereoOf(file.cameras, {image_width, image_height},
                          {kDefaultImageWidth, kDefaultImageHeight});
  Differ(file, rover);
  const UrdfModel urdf = LoadUrdf(file.urdf, meshes);
  const RoverModel drawn = ReadDrawn(drawn_by, urdf);
  rover.further = TakeFurtherLinks(in, urdf, file.joints);
  TakeLinks(in, file, drawn, rover);
  FitCameraHeads(ReadDrawnCameras(drawn_by), file.cameras, rover.body);
  RequireView(in, rover);
  CheckArm(urdf, rover);
  if (rover.arm_at_power_on_rad < rover.arm_lower_rad ||
      rover.arm_at_power_on_rad > rover.arm_upper_rad) {
    in.Refuse("arm", "at_power_on_deg within the limits of the URDF's arm_joint");
  }
  return rover;
}

RoverModel ReadRover(const YamlNode& tree, const YamlNode& drawn_by, int image_width,
                     int image_height, MeshStore* meshes) {
  return AdvisingOtherKinds(
      "robot", [&] { return ReadRoverKeys(tree, drawn_by, image_width, image_height, meshes); });
}

}  // namespace

void VisitRoverKeys(Keys& keys) {
  RoverModel rover;
  RoverFile file;
  VisitRover(keys, rover, file);
}

RoverModel LoadRover(const std::string& file, int image_width, int image_height,
                     const ModelChanges& changes, MeshStore* meshes) {
  const auto names_urdf = [](const YamlNode* keys) { return keys && keys->Find("urdf"); };
  YamlNode tree = LoadModelYaml(file);
  YamlNode drawn_by = tree;
  if (changes.nominal != nullptr) MergeYaml(tree, *changes.nominal);
  if (names_urdf(changes.nominal)) drawn_by = tree;
  const RoverModel told = ReadRover(tree, drawn_by, image_width, image_height, meshes);
  WriteLeftOut(told, tree);
  CheckSpreads(WithSideMotors(tree));
  if (changes.built == nullptr) return told;
  PutBuiltRover(tree, *changes.built);
  if (names_urdf(changes.built)) drawn_by = tree;
  return ReadRover(tree, drawn_by, image_width, image_height, meshes);
}

}  // namespace dockyard::axel
