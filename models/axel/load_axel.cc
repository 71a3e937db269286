#include "models/axel/load_axel.h"

#include <utility>
#include <vector>

#include "models/axel/rover_changes.h"
#include "models/axel/rover_links.h"
#include "models/axel/urdf_agreement.h"
#include "models/read/config_error.h"
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

const std::vector<std::string> kKeys{"name",   "urdf",    "mass_scale", "body_com_x_m",
                                     "wheels", "motors",  "arm",        "tether",
                                     "imu",    "cameras", "spreads"};
const std::vector<std::string> kWheelKeys{
    "radius_m",           "width_m",         "paddles",
    "left_phase_deg",     "right_phase_deg", "left_radius_scale",
    "right_radius_scale", "track_m"};
const std::vector<std::string> kArmKeys{
    "length_m",        "at_power_on_deg",          "tip_radius_m", "tip_length_m",
    "ground_friction", "ground_stiffness_n_per_m", "offset_m",     "collar"};

// A cable's masses must be some.
constexpr double kLightestCable_kg_per_m = 0.001;

/// The wheels' motor with the keys of one side on top.
MotorModel ReadWheelMotor(const YamlReader& motors, const char* side) {
  if (!motors.Has(side)) return ReadMotor(motors.Child("wheel"), motors.PathOf("wheel"));
  YamlNode merged = motors.Child("wheel");
  MergeYaml(merged, motors.Child(side));
  return ReadMotor(merged, motors.PathOf(side));
}

void ReadMotors(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(root.Child("motors"), "motors",
                      {"wheel", "left_wheel", "right_wheel", "arm", "spool"});
  rover.motors[static_cast<int>(Motor::kLeftWheel)] = ReadWheelMotor(in, "left_wheel");
  rover.motors[static_cast<int>(Motor::kRightWheel)] = ReadWheelMotor(in, "right_wheel");
  rover.motors[static_cast<int>(Motor::kArm)] = ReadMotor(in.Child("arm"), in.PathOf("arm"));
  rover.motors[static_cast<int>(Motor::kSpool)] = ReadMotor(in.Child("spool"), in.PathOf("spool"));
}

void ReadWheels(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(root.Child("wheels"), "wheels", kWheelKeys);
  const WheelModel wheel = ReadWheelShape(in);
  rover.left_wheel_soil = rover.right_wheel_soil = wheel;
  rover.left_wheel_soil.phase_rad = in.DegreesOr("left_phase_deg", 0.0, Between(-180.0, 180.0));
  rover.right_wheel_soil.phase_rad = in.DegreesOr("right_phase_deg", 0.0, Between(-180.0, 180.0));
}

void ReadCollar(const YamlReader& arm, RoverModel& rover) {
  if (!arm.Has("collar")) return;
  const YamlReader in(arm.Child("collar"), arm.PathOf("collar"),
                      {"radius_m", "front_m", "front_radius_m", "lead_in_m", "length_m"});
  CollarModel& collar = rover.collar;
  collar.radius_m = in.Number("radius_m", Positive(0.5));
  collar.front_m = in.Number("front_m", Positive(5.0));
  collar.front_radius_m = in.Number("front_radius_m", Between(0.002, 0.5));
  collar.lead_in_m = in.Number("lead_in_m", Between(0.002, 1.0));
  collar.length_m = in.Number("length_m", Between(0.002, 1.0));
  if (collar.front_m > rover.arm_length_m - rover.tip.length_m) {
    in.Refuse("front_m", "at most length_m - tip_length_m: a collar behind the tip");
  }
  if (collar.lead_in_m + collar.length_m >= collar.front_m) {
    in.Refuse("length_m", "a collar that ends before the axle");
  }
  if (collar.front_radius_m > collar.radius_m) {
    in.Refuse("front_radius_m", "at most radius_m: the lead-in widens backwards");
  }
}

void ReadArm(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(root.Child("arm"), "arm", kArmKeys);
  rover.arm_length_m = in.Number("length_m", Positive(5.0));
  rover.arm_at_power_on_rad = in.Degrees("at_power_on_deg", Between(-180.0, 180.0));
  rover.tip.radius_m = in.Number("tip_radius_m", Positive(0.5));
  rover.tip.length_m = in.Number("tip_length_m", Positive(1.0));
  rover.tip.ground_friction = in.Number("ground_friction", NonNegative(2.0));
  rover.tip.ground_stiffness_n_per_m = in.Number("ground_stiffness_n_per_m", Between(100.0, 1e6));
  if (rover.tip.length_m >= rover.arm_length_m) in.Refuse("tip_length_m", "less than length_m");
  ReadCollar(in, rover);
}

void ReadTether(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(
      root.Child("tether"), "tether",
      {"law", "axial_stiffness_n", "damping_ns_per_m", "diameter_m", "mass_kg_per_m",
       "friction_on_station", "friction_on_ground", "friction_on_rock", "friction_on_rover",
       "drum_radius_m", "drum_growth_m_per_turn"});
  TetherModel& tether = rover.tether;
  tether.law =
      in.ChoiceOr("law", 0, {"massless", "cable"}) == 0 ? TetherLaw::kMassless : TetherLaw::kCable;
  tether.axial_stiffness_n = in.Number("axial_stiffness_n", Between(100.0, 1e6));
  tether.damping_ns_per_m = in.Number("damping_ns_per_m", NonNegative(1e5));
  tether.diameter_m = in.Number("diameter_m", Positive(0.05));
  tether.mass_kg_per_m = in.Number("mass_kg_per_m", NonNegative(5.0));
  tether.friction_on_station = in.Number("friction_on_station", NonNegative(2.0));
  tether.friction_on_ground = in.NumberOr("friction_on_ground", 0.5, NonNegative(2.0));
  tether.friction_on_rock = in.NumberOr("friction_on_rock", 0.4, NonNegative(2.0));
  tether.friction_on_rover = in.NumberOr("friction_on_rover", 0.4, NonNegative(2.0));
  if (tether.law == TetherLaw::kCable && tether.mass_kg_per_m < kLightestCable_kg_per_m) {
    in.Refuse("mass_kg_per_m", "at least 0.001 for the law 'cable'");
  }
  tether.drum_radius_m = in.Number("drum_radius_m", Between(0.005, 0.5));
  tether.drum_growth_m_per_turn =
      in.NumberOr("drum_growth_m_per_turn", 0.0, NonNegative(0.1 * tether.drum_radius_m));
}

/// What the URDF must agree with: the numbers that it holds too, and its links.
RoverModel ReadDrawn(const YamlNode& tree, const UrdfModel& urdf) {
  const YamlReader in(tree, "", kKeys);
  RoverModel rover;
  ReadWheels(in, rover);
  ReadArm(in, rover);
  TakeRoverLinks(urdf, rover);
  CheckArm(urdf, rover);
  RequireAgreement(in, rover);
  return rover;
}

/// Numbers in which a rover may differ from what it was drawn for.
void Differ(const YamlReader& root, RoverModel& rover) {
  const YamlReader wheels(root.Child("wheels"), "wheels", kWheelKeys);
  for (const auto& [key, wheel] : {std::pair("left_radius_scale", &rover.left_wheel_soil),
                                   std::pair("right_radius_scale", &rover.right_wheel_soil)}) {
    const double scale = wheels.NumberOr(key, 1.0, Between(0.5, 2.0));
    wheel->rim_radius_m *= scale;
    wheel->paddle_height_m *= scale;
  }
  const YamlReader arm(root.Child("arm"), "arm", kArmKeys);
  const double offset_m = arm.NumberOr("offset_m", 0.0, Between(-1.0, 1.0));
  rover.arm_length_m += offset_m;
  rover.collar.front_m += offset_m;
}

void TakeLinks(const YamlReader& in, const RoverModel& drawn, RoverModel& rover) {
  rover.body = drawn.body;
  rover.left_wheel = drawn.left_wheel;
  rover.right_wheel = drawn.right_wheel;
  rover.arm = drawn.arm;
  rover.arm_lower_rad = drawn.arm_lower_rad;
  rover.arm_upper_rad = drawn.arm_upper_rad;
  FitLinks(in, drawn, rover);
  const YamlReader wheels(in.Child("wheels"), "wheels", kWheelKeys);
  const double track_m = wheels.NumberOr("track_m", drawn.track_m(), Between(0.05, 10.0));
  rover.p_R_left_wheel = Eigen::Vector3d(0.0, 0.5 * track_m, 0.0);
  rover.p_R_right_wheel = -rover.p_R_left_wheel;
  const double scale = in.NumberOr("mass_scale", 1.0, Between(0.1, 10.0));
  for (LinkModel* link : {&rover.body, &rover.left_wheel, &rover.right_wheel, &rover.arm}) {
    link->mass_kg *= scale;
    link->I_LCom_L *= scale;
  }
  double& com_x_m = rover.body.p_LoCom_L.x();
  com_x_m = in.NumberOr("body_com_x_m", com_x_m, Between(-1.0, 1.0));
}

RoverModel ReadRoverKeys(const YamlNode& tree, const YamlNode& drawn_by, int image_width,
                         int image_height, MeshStore* meshes) {
  const YamlReader in(tree, "", kKeys);
  RoverModel rover;
  rover.name = in.Text("name");
  ReadWheels(in, rover);
  ReadMotors(in, rover);
  ReadArm(in, rover);
  ReadTether(in, rover);
  rover.imu = ReadImu(in);
  rover.stereo =
      ReadStereo(in, {image_width, image_height}, {kDefaultImageWidth, kDefaultImageHeight});
  Differ(in, rover);
  const UrdfModel urdf = LoadUrdf(in.File("urdf"), meshes);
  TakeLinks(in, ReadDrawn(drawn_by, urdf), rover);
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

RoverModel LoadRover(const std::string& file, int image_width, int image_height,
                     const ModelChanges& changes, MeshStore* meshes) {
  const auto names_urdf = [](const YamlNode* keys) { return keys && keys->Find("urdf"); };
  YamlNode tree = LoadModelYaml(file);
  YamlNode drawn_by = tree;
  if (changes.told != nullptr) MergeYaml(tree, *changes.told);
  if (names_urdf(changes.told)) drawn_by = tree;
  const RoverModel told = ReadRover(tree, drawn_by, image_width, image_height, meshes);
  WriteLeftOut(told, tree);
  CheckSpreads(WithSideMotors(tree));
  if (changes.built == nullptr) return told;
  PutBuiltRover(tree, *changes.built);
  if (names_urdf(changes.built)) drawn_by = tree;
  return ReadRover(tree, drawn_by, image_width, image_height, meshes);
}

}  // namespace dockyard::axel
