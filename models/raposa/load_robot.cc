#include "models/raposa/load_robot.h"

#include <cmath>

#include "models/read/config_error.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_motor.h"
#include "models/read/load_mounting.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/read_imu.h"
#include "models/read/urdf.h"
#include "models/read/urdf_weld.h"
#include "models/read/yaml_reader.h"

namespace dockyard::raposa {
namespace {

void ReadBelts(const YamlReader& root, BeltsModel& belts) {
  const YamlReader in(root.Child("belts"), "belts",
                      {"gauge_m", "width_m", "roller_radius_m", "body_rear_m", "body_front_m",
                       "arm_length_m", "stiffness_pa_per_m", "damping_pa_s_per_m",
                       "shear_stiffness_pa_per_m", "shear_damping_pa_s_per_m", "effective_gauge_m",
                       "speed_offset", "drift_time_s", "dead_band_m_s"});
  belts.gauge_m = in.Number("gauge_m", Positive(3.0));
  belts.width_m = in.Number("width_m", Positive(1.0));
  belts.roller_radius_m = in.Number("roller_radius_m", Positive(1.0));
  belts.body_rear_m = in.Number("body_rear_m", Between(-3.0, 0.0));
  belts.body_front_m = in.Number("body_front_m", Between(0.0, 3.0));
  belts.arm_length_m = in.Number("arm_length_m", Positive(2.0));
  belts.stiffness_pa_per_m = in.Number("stiffness_pa_per_m", Between(1e5, 1e9));
  belts.damping_pa_s_per_m = in.Number("damping_pa_s_per_m", NonNegative(1e8));
  belts.shear_stiffness_pa_per_m = in.Number("shear_stiffness_pa_per_m", Between(1e4, 1e9));
  belts.shear_damping_pa_s_per_m = in.Number("shear_damping_pa_s_per_m", NonNegative(1e8));
  belts.effective_gauge_m = in.Number("effective_gauge_m", Positive(10.0));
  belts.speed_offset = in.Number("speed_offset", NonNegative(0.5));
  belts.drift_time_s = in.Number("drift_time_s", Between(1.0, 1e5));
  belts.dead_band_m_s = in.Number("dead_band_m_s", NonNegative(1.0));
  if (belts.width_m >= belts.gauge_m) in.Refuse("width_m", "less than gauge_m");
}

void ReadMotors(const YamlReader& root, RobotModel& robot) {
  const YamlReader in(root.Child("motors"), "motors", {"belt", "arm", "door"});
  const auto read = [&](const char* key) { return ReadMotor(in.Child(key), in.PathOf(key)); };
  const auto of = [&](Motor motor) -> MotorModel& {
    return robot.motors[static_cast<std::size_t>(motor)];
  };
  of(Motor::kLeftBelt) = of(Motor::kRightBelt) = read("belt");
  of(Motor::kArm) = read("arm");
  of(Motor::kLeftDoor) = of(Motor::kRightDoor) = read("door");
}

void ReadDoors(const YamlReader& root, DoorsModel& doors) {
  const YamlReader in(root.Child("doors"), "doors",
                      {"pinion_radius_m", "travel_m", "plate_m", "closed_radius_m", "friction"});
  doors.pinion_radius_m = in.Number("pinion_radius_m", Positive(0.2));
  doors.travel_m = in.Number("travel_m", Positive(0.5));
  doors.plate_m = in.Number("plate_m", Between(1e-3, 0.05));
  doors.closed_radius_m = in.Number("closed_radius_m", Positive(0.2));
  doors.friction = in.Number("friction", NonNegative(2.0));
}

void ReadSocket(const YamlReader& root, SocketModel& socket) {
  const YamlReader in(root.Child("socket"), "socket",
                      {"seat_m", "entrance_radius_m", "throat_radius_m", "seat_radius_m",
                       "half_angle_deg", "friction"});
  socket.p_RS = in.Vector3("seat_m", Between(-2.0, 2.0));
  socket.entrance_radius_m = in.Number("entrance_radius_m", Positive(0.5));
  socket.throat_radius_m = in.Number("throat_radius_m", Positive(0.5));
  socket.seat_radius_m = in.Number("seat_radius_m", Positive(socket.throat_radius_m));
  socket.half_angle_rad = in.Degrees("half_angle_deg", Between(5.0, 80.0));
  socket.friction = in.Number("friction", NonNegative(2.0));
  if (socket.throat_radius_m >= socket.entrance_radius_m) {
    in.Refuse("throat_radius_m", "less than entrance_radius_m");
  }
}

/// A pinhole that looks back along -x, turned down by its pitch.
Pose3 BackLooking(const Eigen::Vector3d& p_R, double pitch_rad) {
  Pose3 X_RC;
  X_RC.p = p_R;
  const Eigen::Vector3d view(-std::cos(pitch_rad), 0.0, -std::sin(pitch_rad));
  const Eigen::Vector3d right = Eigen::Vector3d::UnitY();  // of the view
  X_RC.R.col(0) = right;
  X_RC.R.col(1) = view.cross(right);
  X_RC.R.col(2) = view;
  return X_RC;
}

void ReadCamera(const YamlReader& root, BackCameraModel& camera) {
  const YamlReader in(root.Child("camera"), "camera",
                      {"width_px", "height_px", "focal_px", "position_m", "pitch_deg",
                       "half_view_deg", "hole_m", "delay_s", "shutter_s", "blur_sigma_px",
                       "full_well_e", "read_noise_e", "vignetting_exponent", "mounting"});
  camera.camera.width = in.Integer("width_px", 16, 4096);
  camera.camera.height = in.Integer("height_px", 16, 4096);
  const double f = in.Number("focal_px", Positive(1e5));
  camera.camera.lens = BrownPinhole{.fx = f,
                                    .fy = f,
                                    .cx = 0.5 * (camera.camera.width - 1),
                                    .cy = 0.5 * (camera.camera.height - 1)};
  camera.X_RC = BackLooking(in.Vector3("position_m", Between(-2.0, 2.0)),
                            in.Degrees("pitch_deg", Between(-60.0, 60.0)));
  const Pose3 mounting = ReadMounting(in);
  camera.X_RC = {mounting.R * camera.X_RC.R, camera.X_RC.p + mounting.p};
  camera.half_view_rad = in.Degrees("half_view_deg", Between(1.0, 60.0));
  camera.hole_m = in.Number("hole_m", Positive(0.5));
  camera.delay_s = in.Number("delay_s", NonNegative(kTickSeconds * kControlPeriod));
  camera.shutter_s = in.Number("shutter_s", Between(1e-4, 0.5));
  camera.blur_sigma_px = in.Number("blur_sigma_px", NonNegative(10.0));
  camera.full_well_e = in.Number("full_well_e", Between(100.0, 1e6));
  camera.read_noise_e = in.Number("read_noise_e", NonNegative(1e4));
  camera.vignetting_exponent = in.Number("vignetting_exponent", NonNegative(10.0));
}

void ReadLamps(const YamlReader& root, LampsModel& lamps) {
  const YamlReader in(root.Child("lamps"), "lamps",
                      {"position_m", "apart_m", "irradiance_at_1m", "half_angle_deg"});
  lamps.p_R = in.Vector3("position_m", Between(-2.0, 2.0));
  lamps.apart_m = in.Number("apart_m", NonNegative(2.0));
  lamps.irradiance_at_1m = in.Number("irradiance_at_1m", NonNegative(100.0));
  lamps.half_angle_rad = in.Degrees("half_angle_deg", Between(1.0, 89.0));
}

void RequireJoint(const UrdfJoint& joint, const char* type, const char* child) {
  const bool fits = joint.type == type && joint.parent == "body" && joint.child == child &&
                    joint.axis_J == Eigen::Vector3d::UnitY() && joint.X_PJ.R.isIdentity(1e-9);
  if (fits) return;
  throw ConfigError(joint.place + ": expected a " + type + " joint from 'body' to '" + child +
                    "' with axis 0 1 0 and an origin without rotation");
}

void TakeLinks(const UrdfModel& file, RobotModel& robot) {
  if (file.root != "body") {
    throw ConfigError(file.PlaceOf(file.root) + ": expected the root link to be 'body'");
  }
  const UrdfModel urdf = WeldFixedLinks(file);
  RequireJoints(urdf, {"arm_joint", "left_door_joint", "right_door_joint"},
                "'body', 'arm', 'left_door' and 'right_door'");
  const UrdfJoint &arm = urdf.Joint("arm_joint"), &left = urdf.Joint("left_door_joint"),
                  &right = urdf.Joint("right_door_joint");
  RequireJoint(arm, "revolute", "arm");
  RequireJoint(left, "prismatic", "left_door");
  RequireJoint(right, "prismatic", "right_door");
  if (left.X_PJ.p != right.X_PJ.p) {
    throw ConfigError(right.place + ": expected the origin of left_door_joint, where both V meet");
  }
  robot.body = RequireInertial(urdf, "body");
  robot.arm = RequireInertial(urdf, "arm");
  robot.left_door = RequireInertial(urdf, "left_door");
  robot.right_door = RequireInertial(urdf, "right_door");
  robot.p_R_arm = arm.X_PJ.p;
  robot.p_R_doors = left.X_PJ.p;
  robot.arm_lower_rad = arm.lower_rad;
  robot.arm_upper_rad = arm.upper_rad;
}

void ScaleMasses(double scale, RobotModel& robot) {
  for (LinkModel* link : {&robot.body, &robot.arm, &robot.left_door, &robot.right_door}) {
    link->mass_kg *= scale;
    link->I_LCom_L *= scale;
  }
}

void CheckTogether(const YamlReader& in, const RobotModel& robot) {
  const double arm_m = std::abs(robot.p_R_arm.x() - robot.belts.body_front_m);
  if (arm_m > 1e-6 || robot.p_R_arm.tail<2>().norm() > 1e-6) {
    in.Refuse("belts",
              "body_front_m where the URDF's arm_joint is, at height 0: the arm turns "
              "about the front roller");
  }
  const Eigen::Vector3d slot = robot.p_R_doors - robot.socket.p_RS;
  if (!(slot.x() < 0.0) || slot.tail<2>().norm() > 1e-6) {
    in.Refuse("socket", "a seat_m on the doors' axis and before them as seen from the arm");
  }
}

}  // namespace

static RobotModel ReadRobotFile(const std::string& file, const ModelChanges& changes,
                                MeshStore* meshes) {
  YamlNode tree = LoadModelYaml(file);
  if (changes.told != nullptr) MergeYaml(tree, *changes.told);
  PutIfLeftOut(tree, "mass_scale", 1.0);
  PutMountingIfLeftOut(tree, "camera.mounting");
  if (changes.built != nullptr) PutBuilt(tree, *changes.built);
  const YamlReader in(tree, "",
                      {"name", "urdf", "mass_scale", "belts", "motors", "doors", "socket", "camera",
                       "lamps", "imu", "spreads"});
  RobotModel robot;
  robot.name = in.Text("name");
  ReadBelts(in, robot.belts);
  ReadMotors(in, robot);
  ReadDoors(in, robot.doors);
  ReadSocket(in, robot.socket);
  ReadCamera(in, robot.camera);
  ReadLamps(in, robot.lamps);
  if (in.Has("imu")) robot.imu = ReadImu(in);
  TakeLinks(LoadUrdf(in.File("urdf"), meshes), robot);
  ScaleMasses(in.Number("mass_scale", Between(0.1, 10.0)), robot);
  CheckTogether(in, robot);
  CheckSpreads(tree);
  return robot;
}

RobotModel LoadRobot(const std::string& file, const ModelChanges& changes, MeshStore* meshes) {
  return AdvisingOtherKinds("robot", [&] { return ReadRobotFile(file, changes, meshes); });
}

}  // namespace dockyard::raposa
