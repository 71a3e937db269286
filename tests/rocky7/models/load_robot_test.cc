#include "models/rocky7/load_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "models/read/load_model_yaml.h"
#include "models/rocky7/make_nominal.h"
#include "support/loader_walk.h"

namespace dockyard::rocky7 {
namespace {

using testing::HasSubstr;

const char* const kName = "models/rocky7/rocky7.yaml";

std::string File() { return SourceFile(kName); }
void Load(const ModelChanges& changes) { LoadRobot(File(), changes); }

void AddPlan(const RoverPlan& plan, FileValues& values) {
  values.merge(FileValues{{"speed_m_s", plan.speed_m_s},
                          {"steer_rate_deg_s", Degrees(plan.steer_rate_rad_s)},
                          {"wheel.radius_m", plan.wheel_radius_m},
                          {"wheel.width_m", plan.wheel_width_m},
                          {"point.x_m", plan.p_RP.x()},
                          {"point.y_m", plan.p_RP.y()},
                          {"view.x_m", plan.view->p_RC.x()},
                          {"view.y_m", plan.view->p_RC.y()},
                          {"view.half_width_deg", Degrees(plan.view->half_width_rad)},
                          {"view.near_m", plan.view->near_m},
                          {"view.far_m", plan.view->far_m}});
  for (std::size_t i = 0; i < plan.wheels.size(); ++i) {
    const std::string at = "wheels[" + std::to_string(i) + "].";
    values[at + "x_m"] = plan.wheels[i].p_RW.x();
    values[at + "y_m"] = plan.wheels[i].p_RW.y();
    if (plan.wheels[i].steer_limit_rad == 0.0) continue;
    values[at + "steer_limit_deg"] = Degrees(plan.wheels[i].steer_limit_rad);
  }
  for (std::size_t i = 0; i < plan.body[0].size(); ++i) {
    const std::string at = "body[0].corners[" + std::to_string(i) + "].";
    values[at + "x_m"] = plan.body[0][i].x();
    values[at + "y_m"] = plan.body[0][i].y();
  }
}

void AddStop(const std::string& at, const JointStop& stop, FileValues& values) {
  values[at + ".stiffness_nm_per_rad"] = stop.stiffness_nm_per_rad;
  values[at + ".damping_nms_per_rad"] = stop.damping_nms_per_rad;
}

// Of a motor with play.
void AddPlay(const std::string& at, const MotorModel& m, FileValues& values) {
  AddMotor(at, m, values);
  values[at + ".homing_error_deg"] = Degrees(m.homing_error_rad);
  values[at + ".backlash_deg"] = Degrees(m.backlash_rad);
  values[at + ".bend_nm_per_rad"] = m.bend_nm_per_rad;
}

void AddArm(const ArmModel& a, FileValues& values) {
  const std::string at = "build.arm.";
  values.merge(FileValues{{at + "x_m", a.p_RA.x()},
                          {at + "y_m", a.p_RA.y()},
                          {at + "z_m", a.p_RA.z()},
                          {at + "length_m", a.length_m},
                          {at + "mass_kg", a.mass_kg},
                          {at + "roll_stop_deg", Degrees(a.roll_stop_rad)},
                          {at + "pitch_low_deg", Degrees(a.pitch_low_rad)},
                          {at + "pitch_high_deg", Degrees(a.pitch_high_rad)},
                          {at + "scoop_low_deg", Degrees(a.scoop_low_rad)},
                          {at + "scoop_high_deg", Degrees(a.scoop_high_rad)},
                          {at + "stowed_pitch_deg", Degrees(a.stowed_pitch_rad)},
                          {at + "stowed_scoop_deg", Degrees(a.stowed_scoop_rad)},
                          {at + "scoops.width_m", a.scoop.width_m},
                          {at + "scoops.depth_m", a.scoop.depth_m},
                          {at + "scoops.belly_m", a.scoop.belly_m},
                          {at + "scoops.wall_m", a.scoop.wall_m},
                          {at + "scoops.opening_m", a.scoop.opening_m},
                          {at + "scoops.mass_kg", a.scoop.mass_kg}});
  AddStop(at + "stop", a.stop, values);
  AddStop(at + "scoops.stop", a.scoop.stop, values);
  AddPlay(at + "roll", a.roll, values);
  AddPlay(at + "pitch", a.pitch, values);
  AddPlay(at + "scoop", a.scoop_motor, values);
}

void AddMast(const MastModel& m, FileValues& values) {
  const std::string at = "build.mast.", can = at + "instrument.";
  const InstrumentModel& i = m.instrument;
  values.merge(FileValues{{at + "x_m", m.p_RM.x()},
                          {at + "z_m", m.p_RM.z()},
                          {at + "link1_m", m.link1_m},
                          {at + "link2_m", m.link2_m},
                          {at + "housing_kg", m.housing_kg},
                          {at + "link1_kg", m.link1_kg},
                          {at + "link2_kg", m.link2_kg},
                          {can + "radius_m", i.radius_m},
                          {can + "length_m", i.length_m},
                          {can + "mass_kg", i.mass_kg},
                          {can + "switch_radius_m", i.switch_radius_m},
                          {can + "switch_out_m", i.switch_out_m},
                          {can + "closes_n", i.closes_n},
                          {can + "switch_n_per_m", i.switch_n_per_m},
                          {can + "rim_n_per_m", i.rim_n_per_m},
                          {can + "mast_n_per_m", i.mast_n_per_m},
                          {can + "mast_ns_per_m", i.mast_ns_per_m},
                          {can + "friction", i.friction}});
  AddStop(at + "stop", m.stop, values);
  const char* const joints[] = {"roll", "shoulder", "elbow"};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string joint = at + joints[k];
    values.merge(FileValues{{joint + ".low_deg", Degrees(m.low_rad[k])},
                            {joint + ".high_deg", Degrees(m.high_rad[k])},
                            {joint + ".stowed_deg", Degrees(m.stowed_rad[k])},
                            {joint + ".watch_deg", Degrees(m.watch_rad[k])}});
    AddPlay(joint + ".motor", m.motors[k], values);
  }
}

void AddBody(const RoverModel& r, FileValues& values) {
  const Eigen::Vector3d& size = std::get<BoxShape>(r.body.collisions.front().shape).size_m;
  const SuspensionModel& s = r.suspension;
  const std::string at = "build.suspension.";
  values.merge(FileValues{{"build.body.mass_kg", r.body.mass_kg},
                          {"build.body.x_m", r.body.p_LoCom_L.x()},
                          {"build.body.z_m", r.body.p_LoCom_L.z()},
                          {"build.body.length_m", size.x()},
                          {"build.body.width_m", size.y()},
                          {"build.body.height_m", size.z()},
                          {"build.wheel_mass_kg", r.wheel_kg},
                          {"build.bracket_mass_kg", r.bracket_kg},
                          {"build.paddles.count", r.tyre.paddle_count},
                          {"build.paddles.height_m", r.tyre.paddle_height_m},
                          {"build.paddles.thickness_m", r.tyre.paddle_thickness_m},
                          {at + "pivot_x_m", s.pivot_x_m},
                          {at + "pivot_z_m", s.pivot_z_m},
                          {at + "bogie_x_m", s.bogie_x_m},
                          {at + "bogie_z_m", s.bogie_z_m},
                          {at + "rocker_mass_kg", s.rocker_kg},
                          {at + "bogie_mass_kg", s.bogie_kg},
                          {at + "friction_nm", s.friction_nm},
                          {at + "rocker_stop_deg", Degrees(s.rocker_stop_rad)},
                          {at + "bogie_stop_deg", Degrees(s.bogie_stop_rad)}});
  AddStop(at + "stop", s.stop, values);
  AddMotor("build.drive", r.drive, values);
  AddMotor("build.steer", r.steer, values);
  values["build.steer.homing_error_deg"] = Degrees(r.steer.homing_error_rad);
}

// As much of a pair's places as its mapping has; the other keys are the front pair's.
void AddPlaces(const std::string& at, const StereoRig& rig, bool back, FileValues& values) {
  const Eigen::Vector3d middle = 0.5 * (rig.X_RL.p + rig.X_RQ.p);
  values[at + ".forward_m"] = back ? -middle.x() : middle.x();
  values[at + ".height_m"] = middle.z();
  if (back) return;
  const Eigen::Vector3d border =
      rig.left.Direction({-0.5, 0.5 * (rig.left.height - 1)}).normalized();
  values[at + ".baseline_m"] = (rig.X_RL.p - rig.X_RQ.p).norm();
  values[at + ".pitch_deg"] = Degrees(-std::asin(rig.X_RL.R(2, 2)));
  values[at + ".field_of_view_deg"] = 2.0 * Degrees(std::acos(border.z()));
}

FileValues ValuesOf(const RobotModel& r) {
  FileValues values;
  AddPlan(r.rover.plan, values);
  AddBody(r.rover, values);
  AddArm(*r.rover.arm, values);
  AddMast(*r.rover.mast, values);
  AddPlaces("cameras", r.front.nominal, false, values);
  AddPlaces("back_cameras", r.back.nominal, true, values);
  AddPlaces("mast_cameras", r.mast_pair.nominal, false, values);
  values.merge(
      FileValues{{"cameras.as_built.relative_yaw_deg", Degrees(r.front.relative_yaw_sigma_rad)},
                 {"cameras.as_built.rotation_deg", Degrees(r.front.rotation_sigma_rad)},
                 {"cameras.as_built.focal_relative", r.front.lens.focal_sigma},
                 {"cameras.as_built.centre_px", r.front.lens.centre_sigma_px},
                 {"cameras.as_built.radial_px", r.front.lens.radial_sigma_px},
                 {"cameras.sensor.full_well_e", r.front.sensor.full_well_e},
                 {"cameras.sensor.read_noise_e", r.front.sensor.read_noise_e},
                 {"cameras.sensor.vignetting_exponent", r.front.sensor.vignetting_exponent},
                 {"cameras.sensor.blur_sigma_px", r.front.sensor.blur_sigma_px},
                 {"cameras.sensor.shutter_s", r.front.sensor.shutter_s},
                 {"cameras.sensor.video.noise_share", r.front.sensor.video.noise_share},
                 {"cameras.sensor.video.line_jitter_px", r.front.sensor.video.line_jitter_px},
                 {"imu.position_m[0]", r.imu.p_RI.x()},
                 {"imu.position_m[1]", r.imu.p_RI.y()},
                 {"imu.position_m[2]", r.imu.p_RI.z()},
                 {"imu.filter.rate_hz", 1.0 / r.imu.unit->period_s},
                 {"imu.gyro_walk_deg_per_sqrt_h", Degrees(r.imu.gyro_walk_rad_sqrt_s) * 60.0},
                 {"imu.gyro_bias_deg_per_h", Degrees(r.imu.gyro_bias_rad_s) * 3600.0},
                 {"imu.gyro_instability_deg_per_h", Degrees(r.imu.gyro_instability_rad_s) * 3600.0},
                 {"imu.accel_walk_m_s_per_sqrt_h", r.imu.accel_walk_m_s_sqrt_s * 60.0},
                 {"imu.accel_bias_m_s2", r.imu.accel_bias_m_s2},
                 {"imu.accel_instability_m_s2", r.imu.accel_instability_m_s2},
                 {"imu.instability_time_s", r.imu.instability_time_s}});
  return values;
}

TEST(Rocky7File, IsReadAsItIsWritten) {
  ExpectReadAsWritten(LoadModelYaml(File()), ValuesOf(LoadRobot(File())));
}

TEST(Rocky7File, BadNumbersAndUnknownKeysAreRefusedAtTheirPlace) {
  ExpectBadNumbersRefused(LoadModelYaml(File()), Load);
  ExpectUnknownKeysRefused(LoadModelYaml(File()), Load);
}

TEST(Rocky7File, EachNumberIsNeededButThoseOfFurtherPairs) {
  std::map<std::string, std::string> instead;
  for (const char* optional :
       {"cameras.pitch_deg", "cameras.sensor.shutter_s", "back_cameras.forward_m",
        "back_cameras.height_m", "mast_cameras.baseline_m", "mast_cameras.forward_m",
        "mast_cameras.height_m", "mast_cameras.pitch_deg", "mast_cameras.field_of_view_deg"}) {
    instead[optional] = kNoError;
  }
  // Those that may be left out are missed by their spreads alone.
  const YamlNode tree = LoadModelYaml(File());
  const YamlNode& spreads = *tree.Find("spreads");
  for (const auto& [path, value] : NumbersOf(tree)) {
    const bool play = path.ends_with(".homing_error_deg") || path.ends_with(".backlash_deg") ||
                      path.ends_with(".bend_nm_per_rad");
    const bool video = path.starts_with("cameras.sensor.video.");
    if (!play && !video && path != "build.arm.y_m") continue;
    const bool spread = spreads.Find(path.c_str()) != nullptr;
    instead[path] = spread ? "spreads." + path + ": expected the dotted key" : kNoError;
  }
  const ScratchFolder folder;
  ExpectNumbersNeeded(LoadModelYaml(File()), instead,
                      [&](const std::string& text) { LoadRobot(folder.Write(kName, text)); });
}

TEST(Rocky7File, NumbersThatDoNotAgreeAreRefused) {
  const auto error = [](const std::string& text) { return ErrorWith(text, Load); };
  EXPECT_THAT(error("{view: {far_m: 0.01}}"),
              HasSubstr("changed.yaml:1:16: view.far_m: expected a number above near_m"));
  EXPECT_THAT(error("{build: {mast: {link2_m: 0.12}}}"),
              HasSubstr("more than instrument.length_m"));
  EXPECT_THAT(error("{build: {mast: {roll: {high_deg: -171}}}}"), HasSubstr("roll.high_deg"));
  EXPECT_THAT(error("{build: {mast: {elbow: {watch_deg: 181}}}}"), HasSubstr("elbow.watch_deg"));
  EXPECT_THAT(error("{build: {arm: {stowed_pitch_deg: 81}}}"), HasSubstr("stowed_pitch_deg"));
  EXPECT_THAT(error("{build: {arm: {scoops: {opening_m: 0.1}}}}"),
              HasSubstr("less than twice depth_m"));
  EXPECT_THAT(error("{build: {arm: {scoops: {wall_m: 0.0061}}}}"), HasSubstr("at most a fifth"));
  EXPECT_THAT(error("{build: {drive: {max_current_a: 0.1}}}"),
              HasSubstr("more than no_load_current_a"));
  EXPECT_THAT(error("{build: {suspension: {on_bogies: [tail]}}}"), HasSubstr("name of a wheel"));
  EXPECT_THAT(error("{build: {suspension: {on_bogies: [back_left]}}}"), HasSubstr("each side"));
  EXPECT_THAT(error("{wheels: [{name: a, x_m: 0, y_m: 0.2}, {name: a, x_m: 0, y_m: -0.2}]}"),
              HasSubstr("a name of its own"));
}

// What the controllers and the world need of any rover is asked of its file.
TEST(Rocky7File, ARoverWithoutFixedWheelsRockersArmOrMastIsRefused) {
  const ScratchFolder folder;
  const auto without = [&](const std::string& part) {
    YamlNode tree = LoadModelYaml(File());
    const auto spreads = tree.Find("spreads") - tree.items.data();  // some are of the part
    tree.keys.erase(tree.keys.begin() + spreads);
    tree.items.erase(tree.items.begin() + spreads);
    YamlNode& build = *FindPath(tree, "build");
    const auto at = build.Find(part) - build.items.data();
    build.keys.erase(build.keys.begin() + at);
    build.items.erase(build.items.begin() + at);
    const std::string file = folder.Write(kName, FlowText(tree));
    return MessageOf([&] { LoadRobot(file); }, folder);
  };
  EXPECT_THAT(without("arm"), HasSubstr("an arm"));
  EXPECT_THAT(without("mast"), HasSubstr("a mast"));
  EXPECT_THAT(ErrorWith("{wheels: [{name: a, x_m: 0.3, y_m: 0.2, steer_limit_deg: 70}, "
                        "{name: b, x_m: 0.3, y_m: -0.2, steer_limit_deg: 70}, "
                        "{name: c, x_m: -0.3, y_m: 0.2, steer_limit_deg: 70}, "
                        "{name: d, x_m: -0.3, y_m: -0.2, steer_limit_deg: 70}], "
                        "build: {suspension: {on_bogies: [c, d]}}}",
                        Load),
              testing::AllOf(HasSubstr("changed.yaml:1:"), HasSubstr("some fixed ones")));
}

TEST(Rocky7Model, ItsBackPairLooksBackFromBehind) {
  const RobotModel robot = LoadRobot(File());
  const StereoRig &front = robot.front.nominal, &back = robot.back.nominal;
  EXPECT_GT(front.X_RL.R(0, 2), 0.5);
  EXPECT_LT(back.X_RL.R(0, 2), -0.5);
  EXPECT_LT(back.X_RL.p.x(), 0.0);
  // Its left camera is on the right of the rover.
  EXPECT_GT(front.X_RL.p.y(), 0.0);
  EXPECT_LT(back.X_RL.p.y(), 0.0);
}

TEST(Rocky7Model, ItsNominalMotorsAreThoseOfTheFileInTheirOrder) {
  const RobotModel robot = LoadRobot(File());
  const Nominal nominal = MakeNominal(robot);
  ASSERT_EQ(nominal.motors.size(), 15u);
  EXPECT_EQ(nominal.motors[5], NominalOf(robot.rover.drive));
  EXPECT_EQ(nominal.motors[6], NominalOf(robot.rover.steer));
  EXPECT_EQ(nominal.motors[FirstArmMotor(nominal)], NominalOf(robot.rover.arm->roll));
  EXPECT_EQ(nominal.motors[FirstMastMotor(nominal) + 2], NominalOf(robot.rover.mast->motors[2]));
  EXPECT_DOUBLE_EQ(nominal.motors[0].rad_per_count * 70000, 2.0 * kPi);
  EXPECT_DOUBLE_EQ(nominal.rolling_radius_m, 0.065 + 0.0037);
}

}  // namespace
}  // namespace dockyard::rocky7
