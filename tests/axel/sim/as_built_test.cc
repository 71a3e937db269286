// What is built otherwise than told: the world has it, the controller's nominal parameters do not.
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "sim/axel/build_run.h"
#include "sim/axel/nominal_json.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

/// The typical scenario with a small yard, which is quick to make.
Scenario Typical(std::vector<std::string> sets) {
  const std::vector<KnownSystem> known{
      {.name = "axel", .controllers = {"dockyard"}, .file_keys = {"station"}}};
  sets.insert(sets.begin(), {"yard={length_m: 4, width_m: 4, cell_m: 0.2}", "start.r_m=1.2"});
  return LoadScenario(SourceFile("scenarios/axel_typical.yaml"), sets, known);
}
BuiltRun Build(const std::vector<std::string>& sets, MeshStore* meshes = nullptr) {
  const Scenario scenario = Typical(sets);
  return BuildRun(scenario, LoadModels(scenario, meshes));
}
std::string Message(const std::vector<std::string>& sets, MeshStore& meshes) {
  const ScratchFolder folder;
  return MessageOf([&] { LoadModels(Typical(sets), &meshes); }, folder);
}

const MotorModel& MotorOf(const BuiltRun& run, Motor motor) {
  return run.world.rover.motors[static_cast<std::size_t>(motor)];
}
double CylinderRadius(const LinkModel& wheel) {
  return std::get<CylinderShape>(wheel.collisions.at(0).shape).radius_m;
}
/// The largest x of the link's drawing [m].
double DrawnFront(const LinkModel& link) {
  double front = 0.0;
  for (const Visual& visual : link.visuals) {
    for (const Eigen::Vector3d& v : visual.mesh->vertices) {
      front = std::max(front, (visual.X_LV * v).x());
    }
  }
  return front;
}
double YawDeg(const Pose3& X_RC) {  // of the view, its z axis
  return Degrees(std::atan2(X_RC.R(1, 2), X_RC.R(0, 2)));
}
Pose3 NominalLeft(const BuiltRun& run) { return run.world.rover.stereo.nominal.X_RL; }

struct Difference {
  std::string set;                // under as_built
  double (*of)(const BuiltRun&);  // the number in the world
  double built;                   // by hand
};

const Difference kDifferences[] = {
    // 0.265 x 1.02 m of rim and 0.035 m of paddle
    {"robot.wheels.radius_m.times=1.02",
     [](const BuiltRun& run) { return RollingRadius(run.world.rover.right_wheel_soil); }, 0.3053},
    {"robot.wheels.radius_m.times=1.02",
     [](const BuiltRun& run) { return CylinderRadius(run.world.rover.right_wheel); }, 0.3053},
    {"robot.wheels.left_radius_scale=1.01",
     [](const BuiltRun& run) { return RollingRadius(run.world.rover.left_wheel_soil); }, 0.303},
    {"robot.wheels.left_radius_scale=1.01",
     [](const BuiltRun& run) { return RollingRadius(run.world.rover.right_wheel_soil); }, 0.300},
    {"robot.wheels.left_radius_scale=1.01",
     [](const BuiltRun& run) { return DrawnFront(run.world.rover.left_wheel); }, 0.303},
    {"robot.wheels.right_radius_scale.times=0.99",
     [](const BuiltRun& run) { return RollingRadius(run.world.rover.right_wheel_soil); }, 0.297},
    {"robot.wheels.track_m.plus=0.01",
     [](const BuiltRun& run) { return run.world.rover.track_m(); }, 0.86},
    {"robot.arm.offset_m=0.005", [](const BuiltRun& run) { return run.world.rover.arm_length_m; },
     1.005},
    {"robot.arm.offset_m=0.005", [](const BuiltRun& run) { return run.world.rover.collar.front_m; },
     0.955},
    {"robot.arm.offset_m=0.005",
     [](const BuiltRun& run) { return DrawnFront(run.world.rover.arm); }, 1.005},
    {"robot.arm.length_m.plus=-0.003",
     [](const BuiltRun& run) { return run.world.rover.arm_length_m; }, 0.997},
    {"robot.tether.drum_radius_m.times=1.05",
     [](const BuiltRun& run) { return run.world.rover.tether.drum_radius_m; }, 0.063},
    {"robot.tether.drum_growth_m_per_turn=2e-4",
     [](const BuiltRun& run) { return run.world.rover.tether.drum_growth_m_per_turn; }, 2e-4},
    {"robot.tether.axial_stiffness_n.times=0.8",
     [](const BuiltRun& run) { return run.world.rover.tether.axial_stiffness_n; }, 48000},
    {"robot.motors.wheel.torque_per_amp_nm.times=1.1",
     [](const BuiltRun& run) { return MotorOf(run, Motor::kRightWheel).torque_per_amp_nm; }, 16.5},
    {"robot.motors.left_wheel.torque_per_amp_nm.times=0.9",
     [](const BuiltRun& run) { return MotorOf(run, Motor::kLeftWheel).torque_per_amp_nm; }, 13.5},
    {"robot.motors.left_wheel.torque_per_amp_nm.times=0.9",
     [](const BuiltRun& run) { return MotorOf(run, Motor::kRightWheel).torque_per_amp_nm; }, 15},
    {"robot.motors.right_wheel.no_load_current_a.plus=0.05",
     [](const BuiltRun& run) { return MotorOf(run, Motor::kRightWheel).no_load_current_a; }, 0.25},
    {"robot.motors.spool.torque_per_amp_nm.times=0.6",  // weak
     [](const BuiltRun& run) { return MotorOf(run, Motor::kSpool).torque_per_amp_nm; }, 6},
    {"robot.motors.spool.max_current_a.times=0.7",  // limited by a hot driver
     [](const BuiltRun& run) { return MotorOf(run, Motor::kSpool).max_current_a; }, 1.4},
    {"robot.motors.wheel.max_speed_rad_s.times=0.8",  // a bus that sags
     [](const BuiltRun& run) { return MotorOf(run, Motor::kLeftWheel).max_speed_rad_s; }, 0.4},
    {"robot.motors.spool.gear_friction_nm.times=2",
     [](const BuiltRun& run) { return MotorOf(run, Motor::kSpool).gear_friction_nm; }, 1.0},
    {"robot.motors.arm.torque_per_amp_nm=44",
     [](const BuiltRun& run) { return MotorOf(run, Motor::kArm).torque_per_amp_nm; }, 44},
    {"robot.cameras.mounting.yaw_deg=0.5",
     [](const BuiltRun& run) { return YawDeg(NominalLeft(run)); }, 0.5},
    {"robot.cameras.mounting.z_m=0.004", [](const BuiltRun& run) { return NominalLeft(run).p.z(); },
     0.224},
    {"robot.cameras.baseline_m.plus=0.002",
     [](const BuiltRun& run) { return run.built_rig.baseline_m(); }, 0.352},
    {"robot.mass_scale=1.1", [](const BuiltRun& run) { return run.world.rover.mass_kg(); }, 44},
    {"robot.body_com_x_m.plus=0.01",
     [](const BuiltRun& run) { return run.world.rover.body.p_LoCom_L.x(); }, -0.03},
    {"robot.imu.gyro_bias_deg_per_h.times=3",
     [](const BuiltRun& run) { return 3600.0 * Degrees(run.world.rover.imu.gyro_bias_rad_s); }, 30},
    {"station.mouth_height_m.plus=0.01",
     [](const BuiltRun& run) { return run.world.station.mouth_height_m; }, 0.3509},
    {"station.tip_angle_deg.plus=0.5",
     [](const BuiltRun& run) { return Degrees(run.world.station.tip_angle_rad); }, 5.5},
    {"station.board.mounting.y_m=0.003",
     [](const BuiltRun& run) { return BoardInStation(run.world.station).p.y(); }, 0.003},
    {"station.board.mounting.roll_deg=0.4",  // about the axis, so that one side of it sinks
     [](const BuiltRun& run) {
       const Eigen::Vector3d right_M = MouthInStation(run.world.station).R.transpose() *
                                       BoardInStation(run.world.station).R.col(0);
       return Degrees(std::atan2(right_M.z(), right_M.y()));
     },
     0.4},
    {"station.mass_kg.times=1.2",
     [](const BuiltRun& run) { return run.world.station.module.mass_kg; }, 42},
    {"station.feet.friction.times=0.9",
     [](const BuiltRun& run) { return run.world.station.foot_friction; }, 0.36},
    {"station.cone.throat_radius_m.plus=1e-4",
     [](const BuiltRun& run) { return run.world.station.cone.throat_radius_m; }, 0.0321},
    {"station.anchor_depth_m.plus=0.01",
     [](const BuiltRun& run) { return run.world.station.anchor_depth_m; }, 0.36},
    {"soil.cohesion_pa.times=1.5", [](const BuiltRun& run) { return run.world.soil.cohesion_pa; },
     7500},
    {"soil.friction_angle_deg.plus=-2",
     [](const BuiltRun& run) { return Degrees(run.world.soil.friction_angle_rad); }, 36},
};

TEST(AsBuilt, IsInTheWorldAndNotInTheNominalParameters) {
  MeshStore meshes;
  const std::string told = ToJson(Build({}, &meshes).nominal).dump();
  for (const Difference& difference : kDifferences) {
    SCOPED_TRACE(difference.set);
    const BuiltRun built = Build({"as_built." + difference.set}, &meshes);
    EXPECT_NEAR(difference.of(built), difference.built, 1e-7);
    EXPECT_EQ(ToJson(built.nominal).dump(), told);
  }
}

TEST(Changes, AreBuiltAndTold) {
  const BuiltRun run =
      Build({"changes.robot.wheels.radius_m=0.285", "changes.robot.arm.offset_m=0.1",
             "changes.robot.wheels.track_m=0.9"});
  EXPECT_NEAR(RollingRadius(run.world.rover.left_wheel_soil), 0.32, 1e-12);
  EXPECT_NEAR(CylinderRadius(run.world.rover.left_wheel), 0.32, 1e-12);
  EXPECT_NEAR(run.nominal.wheel_radius_m, 0.32, 1e-12);
  EXPECT_NEAR(run.nominal.arm_length_m, 1.1, 1e-12);
  EXPECT_NEAR(run.nominal.track_m, 0.9, 1e-12);
}

TEST(Changes, ToldWheelRadiusIsTheMeanOfBoth) {
  const BuiltRun run = Build({"changes.robot.wheels.left_radius_scale=1.02"});
  EXPECT_NEAR(run.nominal.wheel_radius_m, 0.5 * (0.306 + 0.300), 1e-12);
}

TEST(AsBuilt, ComesOnTopOfWhatIsTold) {
  const BuiltRun run = Build({"changes.robot.tether.drum_radius_m=0.05",
                              "as_built.robot.tether.drum_radius_m={times: 1.1, plus: 0.001}",
                              "axel.tip_angle_deg=3", "as_built.station.tip_angle_deg.plus=1"});
  EXPECT_DOUBLE_EQ(run.nominal.drum_radius_m, 0.05);
  EXPECT_NEAR(run.world.rover.tether.drum_radius_m, 0.056, 1e-12);
  EXPECT_NEAR(Degrees(run.world.station.tip_angle_rad), 4.0, 1e-12);
  EXPECT_NEAR(run.nominal.X_DB.p.x(), 0.17 * std::sin(Radians(3)), 1e-12);
}

TEST(AsBuilt, SideDeviatesFromTheMotorOfBothAsBuilt) {
  const BuiltRun run = Build({"as_built.robot.motors.wheel.torque_per_amp_nm.times=1.1",
                              "as_built.robot.motors.left_wheel.torque_per_amp_nm.times=0.9"});
  EXPECT_NEAR(MotorOf(run, Motor::kLeftWheel).torque_per_amp_nm, 15 * 1.1 * 0.9, 1e-12);
  EXPECT_NEAR(MotorOf(run, Motor::kRightWheel).torque_per_amp_nm, 15 * 1.1, 1e-12);
}

TEST(AsBuilt, MountingMovesCamerasOfAnyFile) {
  const std::string navcam = "camera.file=" + SourceFile("models/cameras/navcam.yaml");
  const BuiltRun plain = Build({navcam});
  const BuiltRun built = Build({navcam, "as_built.robot.cameras.mounting.pitch_deg=0.5"});
  const Eigen::Matrix3d turn = NominalLeft(built).R * NominalLeft(plain).R.transpose();
  EXPECT_TRUE(turn.isApprox(RotY(Radians(0.5)), 1e-12));
  EXPECT_EQ(ToJson(built.nominal).dump(), ToJson(plain.nominal).dump());
}

TEST(AsBuilt, IsWrittenOutAndReadBack) {
  const Scenario s = Typical({"as_built.robot.arm.offset_m=0.003"});
  const ScratchFolder folder;
  const Scenario back = LoadScenario(folder.Write("r.yaml", ResolvedYaml(s)), {},
                                     {{"axel", {"dockyard"}, {"station"}}});
  EXPECT_EQ(FlowText(back.as_built), FlowText(s.as_built));
}

TEST(AsBuilt, WhatNoWorldCanHaveOtherwiseIsRefused) {
  MeshStore meshes;
  EXPECT_EQ(Message({"as_built.robot.name=other"}, meshes),
            "--set as_built.robot.name=other: as_built.robot.name: expected keys that something is "
            "built by, a name is not");
  EXPECT_THAT(Message({"as_built.soil.source=other"}, meshes), HasSubstr("as_built.soil.source"));
  EXPECT_THAT(Message({"as_built.robot.wheels.left_phase_deg=3"}, meshes),
              HasSubstr("is drawn for each"));
  EXPECT_THAT(Message({"as_built.robot.arm.at_power_on_deg=3"}, meshes),
              HasSubstr("lies on the ground"));
  EXPECT_THAT(
      Message({"as_built.station.board.fiducials=[{x_m: -0.36, y_m: -0.17, rotation_deg: 0},"
               "{x_m: 0.36, y_m: -0.17, rotation_deg: 45}, {x_m: -0.36, y_m: 0.15,"
               "rotation_deg: 90}, {x_m: 0.36, y_m: 0.15, rotation_deg: -45}]"},
              meshes),
      HasSubstr("as_built.station.board: expected as many fiducials as are told, 8"));
  EXPECT_THAT(Message({"as_built.robot.spreads={}"}, meshes), HasSubstr("as_built.robot.spreads"));
  EXPECT_THAT(Message({"camera.file=" + SourceFile("models/cameras/navcam.yaml"),
                       "as_built.robot.cameras.baseline_m.plus=0.001"},
                      meshes),
              HasSubstr("expected none beside camera.file"));
}

TEST(AsBuilt, MistakesAreToldByPlaceAndPath) {
  MeshStore meshes;
  EXPECT_THAT(Message({"as_built.rover.mass_scale=1"}, meshes), HasSubstr("as_built.rover"));
  EXPECT_THAT(Message({"as_built.robot=5"}, meshes), HasSubstr("expected a mapping"));
  EXPECT_THAT(Message({"as_built.robot.arm.lenght_m=1"}, meshes), HasSubstr("did you mean"));
  EXPECT_THAT(Message({"as_built.robot.arm.lenght_m.plus=1"}, meshes),
              HasSubstr("arm.lenght_m: expected a value: the model has no such number"));
  EXPECT_THAT(Message({"as_built.robot.arm.length_m.tmes=1"}, meshes),
              HasSubstr("did you mean 'arm.length_m.times'?"));
  EXPECT_THAT(Message({"as_built.robot.imu.position_m.plus=1"}, meshes),
              HasSubstr("imu.position_m: expected a value: only a number can be built by times"));
  EXPECT_EQ(
      Message({"as_built.station.feet.friction.plus=9"}, meshes),
      "--set as_built.station.feet.friction.plus=9: feet.friction: expected a number >= 0 and "
      "<= 3, found '9.4'");
  EXPECT_THAT(Message({"as_built.station.cone.throat_radius_m=0.03"}, meshes),
              HasSubstr("cone.throat_radius_m: expected more than the 0.0312 m of the arm's tip"));
}

}  // namespace
}  // namespace dockyard::axel
