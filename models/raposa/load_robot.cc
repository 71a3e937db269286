#include "models/raposa/load_robot.h"

#include <cmath>

#include "models/read/config_error.h"
#include "models/read/load_contact.h"
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

void VisitBelts(Keys& keys, BeltsModel& belts) {
  keys.Number("gauge_m", belts.gauge_m, Positive(3.0));
  keys.Number("width_m", belts.width_m, Positive(1.0));
  keys.Number("roller_radius_m", belts.roller_radius_m, Positive(1.0));
  keys.Number("body_rear_m", belts.body_rear_m, Between(-3.0, 0.0));
  keys.Number("body_front_m", belts.body_front_m, Between(0.0, 3.0));
  keys.Number("arm_length_m", belts.arm_length_m, Positive(2.0));
  keys.Number("stiffness_pa_per_m", belts.stiffness_pa_per_m, Between(1e5, 1e9));
  keys.Number("damping_pa_s_per_m", belts.damping_pa_s_per_m, NonNegative(1e8));
  keys.Number("shear_stiffness_pa_per_m", belts.shear_stiffness_pa_per_m, Between(1e4, 1e9));
  keys.Number("shear_damping_pa_s_per_m", belts.shear_damping_pa_s_per_m, NonNegative(1e8));
  keys.Number("effective_gauge_m", belts.effective_gauge_m, Positive(10.0));
  keys.Number("speed_offset", belts.speed_offset, NonNegative(0.5));
  keys.Number("drift_time_s", belts.drift_time_s, Between(1.0, 1e5));
  keys.Number("dead_band_m_s", belts.dead_band_m_s, NonNegative(1.0));
  keys.Check("width_m", belts.width_m < belts.gauge_m, "less than gauge_m");
}

void VisitMotors(Keys& keys, RobotModel& robot) {
  const auto visit = [&](const char* key, Motor left, Motor right) {
    MotorModel& motor = robot.motors[static_cast<std::size_t>(left)];
    keys.Mapping(key, [&](Keys& in) { VisitMotor(in, motor); });
    robot.motors[static_cast<std::size_t>(right)] = motor;
  };
  visit("belt", Motor::kLeftBelt, Motor::kRightBelt);
  visit("arm", Motor::kArm, Motor::kArm);
  visit("door", Motor::kLeftDoor, Motor::kRightDoor);
}

void VisitDoors(Keys& keys, DoorsModel& doors) {
  keys.Number("pinion_radius_m", doors.pinion_radius_m, Positive(0.2));
  keys.Number("travel_m", doors.travel_m, Positive(0.5));
  keys.Number("plate_m", doors.plate_m, Between(1e-3, 0.05));
  keys.Number("closed_radius_m", doors.closed_radius_m, Positive(0.2));
  keys.Mapping("stop", [&](Keys& in) { VisitSlideStop(in, doors.stop); });
  VisitContact(keys, doors.contact, Presence::kDefault);
}

void VisitSocket(Keys& keys, SocketModel& socket) {
  keys.Vector3("seat_m", socket.p_RS, Between(-2.0, 2.0));
  keys.Number("entrance_radius_m", socket.entrance_radius_m, Positive(0.5));
  keys.Number("throat_radius_m", socket.throat_radius_m, Positive(0.5));
  keys.Number("seat_radius_m", socket.seat_radius_m,
              keys.Limits(Positive(socket.throat_radius_m), Positive(0.5)));
  keys.Degrees("half_angle_deg", socket.half_angle_rad, Between(5.0, 80.0));
  VisitContact(keys, socket.contact, Presence::kDefault);
  keys.Check("throat_radius_m", socket.throat_radius_m < socket.entrance_radius_m,
             "less than entrance_radius_m");
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

void VisitCamera(Keys& keys, BackCameraModel& camera) {
  keys.Integer("width_px", camera.camera.width, 16, 4096);
  keys.Integer("height_px", camera.camera.height, 16, 4096);
  double focal_px = 0.0, pitch_rad = 0.0;
  Eigen::Vector3d p_R = Eigen::Vector3d::Zero();
  Pose3 mounting;
  keys.Number("focal_px", focal_px, Positive(1e5));
  keys.Vector3("position_m", p_R, Between(-2.0, 2.0));
  keys.Degrees("pitch_deg", pitch_rad, Between(-60.0, 60.0));
  VisitMounting(keys, mounting);
  camera.camera.lens = BrownPinhole{.fx = focal_px,
                                    .fy = focal_px,
                                    .cx = 0.5 * (camera.camera.width - 1),
                                    .cy = 0.5 * (camera.camera.height - 1)};
  camera.X_RC = BackLooking(p_R, pitch_rad);
  camera.X_RC = {mounting.R * camera.X_RC.R, camera.X_RC.p + mounting.p};
  keys.Degrees("half_view_deg", camera.half_view_rad, Between(1.0, 60.0));
  keys.Number("hole_m", camera.hole_m, Positive(0.5));
  keys.Number("delay_s", camera.delay_s, NonNegative(kTickSeconds * kControlPeriod));
  keys.Number("shutter_s", camera.shutter_s, Between(1e-4, 0.5));
  keys.Number("blur_sigma_px", camera.blur_sigma_px, Between(0.0, 1.5));
  keys.Number("full_well_e", camera.full_well_e, Between(100.0, 1e6));
  keys.Number("read_noise_e", camera.read_noise_e, NonNegative(1e4));
  keys.Number("vignetting_exponent", camera.vignetting_exponent, NonNegative(10.0));
  keys.Number("exposed_level", camera.exposed_level, Between(0.02, 0.8));
}

void VisitLamps(Keys& keys, LampsModel& lamps) {
  keys.Vector3("position_m", lamps.p_R, Between(-2.0, 2.0));
  keys.Number("apart_m", lamps.apart_m, NonNegative(2.0));
  keys.Number("irradiance_at_1m", lamps.irradiance_at_1m, NonNegative(100.0));
  keys.Degrees("half_angle_deg", lamps.half_angle_rad, Between(1.0, 89.0));
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

/// Keys of the file that the model has otherwise.
struct RobotFile {
  std::string urdf;
  double mass_scale = 1.0;
};

void VisitRobot(Keys& keys, RobotModel& robot, RobotFile& file) {
  keys.Text("name", robot.name);
  keys.Mapping("belts", [&](Keys& in) { VisitBelts(in, robot.belts); });
  keys.Mapping("motors", [&](Keys& in) { VisitMotors(in, robot); });
  keys.Mapping("arm_stop", [&](Keys& in) { VisitStop(in, robot.arm_stop); });
  keys.Mapping("doors", [&](Keys& in) { VisitDoors(in, robot.doors); });
  keys.Mapping("socket", [&](Keys& in) { VisitSocket(in, robot.socket); });
  keys.Mapping("camera", [&](Keys& in) { VisitCamera(in, robot.camera); });
  keys.Mapping("lamps", [&](Keys& in) { VisitLamps(in, robot.lamps); });
  keys.Mapping(Unset("imu"),
               [&](Keys& in) { VisitImu(in, robot.imu ? *robot.imu : robot.imu.emplace()); });
  keys.File("urdf", file.urdf);
  keys.Number(Optional("mass_scale"), file.mass_scale, Between(0.1, 10.0));
  NameSpreads(keys);
}

}  // namespace

void VisitRobotKeys(Keys& keys) {
  RobotModel robot;
  RobotFile file;
  VisitRobot(keys, robot, file);
}

static RobotModel ReadRobotFile(const std::string& file, const ModelChanges& changes,
                                MeshStore* meshes) {
  YamlNode tree = LoadModelYaml(file);
  if (changes.nominal != nullptr) MergeYaml(tree, *changes.nominal);
  PutIfLeftOut(tree, "mass_scale", 1.0);
  PutMountingIfLeftOut(tree, "camera.mounting");
  if (changes.built != nullptr) PutBuilt(tree, *changes.built);
  RobotModel robot;
  RobotFile keys;
  const auto visit = [&](Keys& all) { VisitRobot(all, robot, keys); };
  ReadKeys(tree, "", visit);
  TakeLinks(LoadUrdf(keys.urdf, meshes), robot);
  ScaleMasses(keys.mass_scale, robot);
  const YamlReader in(tree, "", KeyNames(visit));
  CheckTogether(in, robot);
  CheckSpreads(tree);
  return robot;
}

RobotModel LoadRobot(const std::string& file, const ModelChanges& changes, MeshStore* meshes) {
  return AdvisingOtherKinds("robot", [&] { return ReadRobotFile(file, changes, meshes); });
}

}  // namespace dockyard::raposa
