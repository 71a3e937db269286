#include "models/raposa/load_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "models/raposa/make_nominal.h"
#include "models/read/load_model_yaml.h"
#include "support/loader_walk.h"

namespace dockyard::raposa {
namespace {

using testing::HasSubstr;

const char* const kName = "models/raposa/raposa.yaml";

std::string File() { return SourceFile(kName); }
void Load(const ModelChanges& changes) { LoadRobot(File(), changes); }

FileValues ValuesOf(const RobotModel& r) {
  const BeltsModel& b = r.belts;
  const DoorsModel& d = r.doors;
  const SocketModel& s = r.socket;
  const BackCameraModel& c = r.camera;
  const auto& lens = std::get<BrownPinhole>(c.camera.lens);
  FileValues values{{"belts.gauge_m", b.gauge_m},
                    {"belts.width_m", b.width_m},
                    {"belts.roller_radius_m", b.roller_radius_m},
                    {"belts.body_rear_m", b.body_rear_m},
                    {"belts.body_front_m", b.body_front_m},
                    {"belts.arm_length_m", b.arm_length_m},
                    {"belts.stiffness_pa_per_m", b.stiffness_pa_per_m},
                    {"belts.damping_pa_s_per_m", b.damping_pa_s_per_m},
                    {"belts.shear_stiffness_pa_per_m", b.shear_stiffness_pa_per_m},
                    {"belts.shear_damping_pa_s_per_m", b.shear_damping_pa_s_per_m},
                    {"belts.effective_gauge_m", b.effective_gauge_m},
                    {"belts.speed_offset", b.speed_offset},
                    {"belts.drift_time_s", b.drift_time_s},
                    {"belts.dead_band_m_s", b.dead_band_m_s},
                    {"doors.pinion_radius_m", d.pinion_radius_m},
                    {"arm_stop.stiffness_nm_per_rad", r.arm_stop.stiffness_nm_per_rad},
                    {"arm_stop.damping_nms_per_rad", r.arm_stop.damping_nms_per_rad},
                    {"doors.travel_m", d.travel_m},
                    {"doors.stop.stiffness_n_per_m", d.stop.stiffness_nm_per_rad},
                    {"doors.stop.damping_ns_per_m", d.stop.damping_nms_per_rad},
                    {"doors.plate_m", d.plate_m},
                    {"doors.closed_radius_m", d.closed_radius_m},
                    {"doors.friction", d.contact.friction},
                    {"doors.stiffness_n_per_m", d.contact.stiffness_n_per_m},
                    {"doors.damping_ns_per_m", d.contact.damping_ns_per_m},
                    {"socket.seat_m[0]", s.p_RS.x()},
                    {"socket.seat_m[1]", s.p_RS.y()},
                    {"socket.seat_m[2]", s.p_RS.z()},
                    {"socket.entrance_radius_m", s.entrance_radius_m},
                    {"socket.throat_radius_m", s.throat_radius_m},
                    {"socket.seat_radius_m", s.seat_radius_m},
                    {"socket.half_angle_deg", Degrees(s.half_angle_rad)},
                    {"socket.friction", s.contact.friction},
                    {"socket.stiffness_n_per_m", s.contact.stiffness_n_per_m},
                    {"socket.damping_ns_per_m", s.contact.damping_ns_per_m},
                    {"camera.width_px", c.camera.width},
                    {"camera.height_px", c.camera.height},
                    {"camera.focal_px", lens.fx},
                    {"camera.position_m[0]", c.X_RC.p.x()},
                    {"camera.position_m[1]", c.X_RC.p.y()},
                    {"camera.position_m[2]", c.X_RC.p.z()},
                    {"camera.pitch_deg", Degrees(-std::asin(c.X_RC.R(2, 2)))},
                    {"camera.half_view_deg", Degrees(c.half_view_rad)},
                    {"camera.hole_m", c.hole_m},
                    {"camera.delay_s", c.delay_s},
                    {"camera.shutter_s", c.shutter_s},
                    {"camera.blur_sigma_px", c.blur_sigma_px},
                    {"camera.full_well_e", c.full_well_e},
                    {"camera.read_noise_e", c.read_noise_e},
                    {"camera.vignetting_exponent", c.vignetting_exponent},
                    {"camera.exposed_level", c.exposed_level},
                    {"lamps.position_m[0]", r.lamps.p_R.x()},
                    {"lamps.position_m[1]", r.lamps.p_R.y()},
                    {"lamps.position_m[2]", r.lamps.p_R.z()},
                    {"lamps.apart_m", r.lamps.apart_m},
                    {"lamps.irradiance_at_1m", r.lamps.irradiance_at_1m},
                    {"lamps.half_angle_deg", Degrees(r.lamps.half_angle_rad)}};
  AddMotor("motors.belt", r.motors[static_cast<std::size_t>(Motor::kRightBelt)], values);
  AddMotor("motors.arm", r.motors[static_cast<std::size_t>(Motor::kArm)], values);
  AddMotor("motors.door", r.motors[static_cast<std::size_t>(Motor::kLeftDoor)], values);
  return values;
}

TEST(RaposaFile, IsReadAsItIsWritten) {
  ExpectReadAsWritten(LoadModelYaml(File()), ValuesOf(LoadRobot(File())));
}

TEST(RaposaFile, BadNumbersAndUnknownKeysAreRefusedAtTheirPlace) {
  ExpectBadNumbersRefused(LoadModelYaml(File()), Load);
  ExpectUnknownKeysRefused(LoadModelYaml(File()), Load);
}

TEST(RaposaFile, EachNumberIsNeeded) {
  const ScratchFolder folder;
  folder.CopyModel("raposa");
  ExpectNumbersNeeded(LoadModelYaml(File()), {},
                      [&](const std::string& text) { LoadRobot(folder.Write(kName, text)); });
}

TEST(RaposaFile, WithoutStiffnessOfContactsHasThatOfBefore) {
  const ScratchFolder folder;
  folder.CopyModel("raposa");
  std::istringstream lines(Slurp(File()));
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    const bool of_stop = line.starts_with("    ");
    const bool of_contact = line.find("stiffness_n_per_m") != std::string::npos ||
                            line.find("damping_ns_per_m") != std::string::npos;
    if (of_stop || !of_contact) kept += line + "\n";
  }
  folder.Write(kName, kept);
  const RobotModel robot = LoadRobot((folder.path() / kName).string());
  EXPECT_EQ(robot.socket.contact.stiffness_n_per_m, kHardContact.stiffness_n_per_m);
  EXPECT_EQ(robot.doors.contact.damping_ns_per_m, kHardContact.damping_ns_per_m);
}

TEST(RaposaFile, NumbersThatDoNotAgreeAreRefused) {
  const auto error = [](const std::string& text) { return ErrorWith(text, Load); };
  EXPECT_THAT(error("{belts: {width_m: 0.5}}"),
              HasSubstr("changed.yaml:1:19: belts.width_m: expected less than gauge_m"));
  EXPECT_THAT(error("{belts: {body_front_m: 0.2}}"), HasSubstr("where the URDF's arm_joint is"));
  EXPECT_THAT(error("{socket: {throat_radius_m: 0.036}}"),
              HasSubstr("less than entrance_radius_m"));
  EXPECT_THAT(error("{socket: {seat_radius_m: 0.017}}"), HasSubstr("socket.seat_radius_m"));
  EXPECT_THAT(error("{socket: {seat_m: [-0.30, 0.01, -0.038]}}"), HasSubstr("on the doors' axis"));
  EXPECT_THAT(error("{motors: {arm: {max_current_a: 0.3}}}"),
              HasSubstr("more than no_load_current_a"));
  EXPECT_THAT(error("{camera: {position_m: [0, 0]}}"), HasSubstr("camera.position_m"));
  EXPECT_THAT(error("{urdf: none.urdf}"), HasSubstr("urdf"));
}

std::string UrdfError(const std::string& from, const std::string& to) {
  const ScratchFolder folder;
  folder.CopyModel("raposa");
  const std::string urdf = "models/raposa/raposa.urdf";
  folder.Write(urdf, Replaced(Slurp(SourceFile(urdf)), from, to));
  return MessageOf([&] { LoadRobot((folder.path() / kName).string()); }, folder);
}

TEST(RaposaUrdf, JointsOfAnotherKindOrNameAreRefusedAtTheirPlace) {
  EXPECT_THAT(
      UrdfError("name=\"arm_joint\" type=\"revolute\"", "name=\"arm_joint\" type=\"continuous\""),
      testing::AllOf(HasSubstr("raposa.urdf:"), HasSubstr("expected a revolute joint")));
  EXPECT_THAT(UrdfError("name=\"left_door_joint\"", "name=\"left_flap\""), HasSubstr("left_flap"));
}

TEST(RaposaModel, MassScaleScalesMassesAndInertiasAlike) {
  const RobotModel one = LoadRobot(File());
  RobotModel more;
  LoadWith("{mass_scale: 1.5}",
           [&](const ModelChanges& changes) { more = LoadRobot(File(), changes); });
  EXPECT_NEAR(more.mass_kg(), 1.5 * one.mass_kg(), 1e-9);
  EXPECT_LT((more.arm.I_LCom_L - 1.5 * one.arm.I_LCom_L).norm(), 1e-12);
}

TEST(RaposaModel, ItsCameraFacesBackAndItsBeltsHaveOneMotor) {
  const RobotModel robot = LoadRobot(File());
  EXPECT_LT((robot.camera.X_RC.R.col(2) - Eigen::Vector3d(-1.0, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(robot.camera.X_RC.R.determinant(), 1.0, 1e-12);
  EXPECT_EQ(robot.motors[0].max_current_a, robot.motors[1].max_current_a);
}

}  // namespace
}  // namespace dockyard::raposa
