#include <gmock/gmock.h>

#include <cmath>

#include "models/axel/load_axel.h"
#include "models/axel/load_station.h"
#include "models/axel/make_nominal.h"
#include "models/read/urdf.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

constexpr double kGravity = 9.81;

RoverModel Axel() { return LoadRover(SourceFile("models/axel/axel.yaml")); }

/// Message for axel.yaml or axel.urdf with one place changed.
std::string ChangedMessage(const std::string& name, const std::string& from,
                           const std::string& to) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string changed = "models/axel/" + name;
  folder.Write(changed, Replaced(Slurp(SourceFile(changed)), from, to));
  const std::string file = (folder.path() / "models/axel/axel.yaml").string();
  return MessageOf([&] { LoadRover(file); }, folder);
}

struct Solid {
  double mass_kg;
  Eigen::Vector3d p;
  Eigen::Vector3d moments;  // about its own centre
};

/// Solid cylinder along y.
Eigen::Vector3d Cylinder(double m, double r, double l) {
  const double across = m * (3 * r * r + l * l) / 12;
  return {across, m * r * r / 2, across};
}

Eigen::Vector3d Box(double m, double a, double b, double c) {
  return {m * (b * b + c * c) / 12, m * (a * a + c * c) / 12, m * (a * a + b * b) / 12};
}

/// Parallel axes (Huygens and Steiner).
void ExpectComposed(const LinkModel& link, const std::vector<Solid>& solids) {
  double mass = 0.0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  for (const Solid& s : solids) {
    mass += s.mass_kg;
    com += s.mass_kg * s.p;
  }
  com /= mass;
  Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
  for (const Solid& s : solids) {
    const Eigen::Vector3d d = s.p - com;
    I += Eigen::Matrix3d(s.moments.asDiagonal());
    I += s.mass_kg * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
  }
  EXPECT_NEAR(link.mass_kg, mass, 1e-9);
  EXPECT_LT((link.p_LoCom_L - com).norm(), 1e-9);
  EXPECT_LT((link.I_LCom_L - I).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(AxelMass, BodyIsItsHousingHeadsAndBatteries) {
  const Eigen::Vector3d head = Box(1, 0.065, 0.064, 0.044), half = Cylinder(1, 0.09, 0.08);
  ExpectComposed(Axel().body, {{20, {-0.042, 0, -0.022}, Cylinder(20, 0.16, 0.56)},
                               {1, {0.08, 0.175, 0.22}, head},
                               {1, {0.08, -0.175, 0.22}, head},
                               {1, {-0.14, 0.075, 0}, half},
                               {1, {-0.14, -0.075, 0}, half}});
}

TEST(CoaxialMass, IsOnTheAxleButForHeadsAndArm) {
  const RoverModel rover = LoadRover(SourceFile("models/axel/axel_coaxial.yaml"));
  const Eigen::Vector3d head = Box(1, 0.065, 0.064, 0.044), half = Cylinder(11, 0.16, 0.18);
  ExpectComposed(rover.body, {{11, {0, 0.19, 0}, half},
                              {11, {0, -0.19, 0}, half},
                              {1, {0.08, 0.175, 0.22}, head},
                              {1, {0.08, -0.175, 0.22}, head},
                              {2, {0, 0, 0}, Cylinder(2, 0.09, 0.20)}});
  const Eigen::Vector3d rod = Cylinder(2, 0.0225, 1.0);
  ExpectComposed(rover.arm, {{2, {0.5, 0, 0}, {rod.y(), rod.x(), rod.z()}}});
  EXPECT_NEAR(rover.mass_kg(), 40.0, 1e-9);
  const double nose_down_nm = kGravity * (rover.arm.mass_kg * rover.arm.p_LoCom_L.x() +
                                          rover.body.mass_kg * rover.body.p_LoCom_L.x());
  EXPECT_NEAR(nose_down_nm, 11.4, 0.05);
}

TEST(AxelField, HasTheSensesOfItsFileOnAxelsBody) {
  const RoverModel field = LoadRover(SourceFile("models/axel/axel_field.yaml")), axel = Axel();
  EXPECT_EQ(field.mass_kg(), axel.mass_kg());
  ASSERT_TRUE(field.imu.unit);
  EXPECT_EQ(field.imu.unit->filter, AttitudeFilter::kMahony);
  EXPECT_EQ(field.imu.clock_offset_s, 0.01);
  const std::size_t arm = static_cast<std::size_t>(Motor::kArm);
  EXPECT_DOUBLE_EQ(field.motors[arm].backlash_rad, Radians(0.3));
  EXPECT_EQ(field.motors[arm].bend_nm_per_rad, 5000.0);
  EXPECT_EQ(field.motors[arm].torque_per_amp_nm, axel.motors[arm].torque_per_amp_nm);
  EXPECT_EQ(field.motors[0].current_scale_share, 0.02);
  ASSERT_TRUE(field.tether_sensor);
  EXPECT_DOUBLE_EQ(field.tether_sensor->direction_offset_rad, Radians(1.0));
  EXPECT_EQ(field.stereo.sensor.readout_s, 0.02);
  EXPECT_EQ(field.stereo.sensor.exposure.by, ExposureBy::kBefore);
  EXPECT_EQ(field.stereo.sensor.defects.hot_share, 0.001);
  EXPECT_EQ(field.stereo.lens.ripple_px, 0.15);
  EXPECT_EQ(field.stereo.sensor.full_well_e, axel.stereo.sensor.full_well_e);
  EXPECT_EQ(axel.stereo.sensor.readout_s, 0.0);
  EXPECT_EQ(axel.stereo.sensor.exposure.by, ExposureBy::kSame);
  EXPECT_EQ(axel.stereo.sensor.defects.hot_share, 0.0);
  EXPECT_EQ(axel.stereo.lens.ripple_px, 0.0);
  EXPECT_FALSE(axel.tether_sensor);
  EXPECT_FALSE(axel.imu.unit);
  EXPECT_EQ(axel.motors[arm].backlash_rad, 0.0);
}

TEST(AxelMass, ArmIsAUniformRod) {
  const Eigen::Vector3d along_y = Cylinder(4, 0.0225, 1.0);
  ExpectComposed(Axel().arm, {{4, {0.5, 0, 0}, {along_y.y(), along_y.x(), along_y.z()}}});
}

TEST(AxelMass, WheelIsAHoopAndADisc) {
  const double r2 = 0.265 * 0.265, across = 4 * (r2 / 2 + 0.15 * 0.15 / 12);
  for (const LinkModel& wheel : {Axel().left_wheel, Axel().right_wheel}) {
    ExpectComposed(wheel, {{4, {0, 0, 0}, {across, 4 * r2, across}},
                           {2, {0, 0, 0}, Cylinder(2, 0.265, 0.15)}});
  }
}

TEST(AxelMass, TotalIs40KgAndTheNoseIsHeavyBy10Nm) {
  const RoverModel axel = Axel();
  EXPECT_NEAR(axel.mass_kg(), 40.0, 1e-9);
  const double nose_down_nm = kGravity * (axel.arm.mass_kg * axel.arm.p_LoCom_L.x() +
                                          axel.body.mass_kg * axel.body.p_LoCom_L.x());
  EXPECT_NEAR(nose_down_nm, 10.2, 0.05);
}

TEST(AxelMotors, CarryWhatTheyMust) {
  const RoverModel axel = Axel();
  const auto limit_nm = [&](Motor which) {
    const MotorModel& m = axel.motors[static_cast<std::size_t>(which)];
    return m.torque_per_amp_nm * (m.max_current_a - m.no_load_current_a);
  };
  EXPECT_NEAR(limit_nm(Motor::kLeftWheel), 40.0, 0.1);
  EXPECT_NEAR(limit_nm(Motor::kRightWheel), 40.0, 0.1);
  EXPECT_NEAR(limit_nm(Motor::kArm), 80.0, 1e-9);
  EXPECT_NEAR(limit_nm(Motor::kSpool) / axel.tether.drum_radius_m, 300.0, 1e-9);
}

TEST(AxelCameras, AreLevelSideBySideWith90Degrees) {
  const StereoRig& rig = Axel().stereo.nominal;
  EXPECT_NEAR(rig.baseline_m(), 0.35, 1e-12);
  EXPECT_GT(rig.X_RL.p.y(), rig.X_RQ.p.y());
  const auto ahead = rig.left.Project(Inverse(rig.X_RL) * (rig.X_RL.p + Eigen::Vector3d(3, 0, 0)));
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(ahead->x(), 511.5, 1e-9);
  EXPECT_NEAR(ahead->y(), 383.5, 1e-9);
  // 45 deg to the left is the image's left border.
  const auto left = rig.left.Project(Inverse(rig.X_RL) * (rig.X_RL.p + Eigen::Vector3d(3, 3, 0)));
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->x(), -0.5, 1e-9);
}

/// Whether any corner of a link's visuals lies in the image of a camera.
int CornersInView(const LinkModel& link, const Pose3& X_RLink, const Camera& camera,
                  const Pose3& X_RC) {
  int count = 0;
  for (const Visual& visual : link.visuals) {
    for (const Eigen::Vector3d& v : visual.mesh->vertices) {
      const auto pixel = camera.Project(Inverse(X_RC) * (X_RLink * (visual.X_LV * v)));
      if (pixel && camera.Sees(*pixel)) ++count;
    }
  }
  return count;
}

TEST(AxelCameras, SeeTheArmButNotTheirOwnBody) {
  const RoverModel axel = Axel();
  const StereoRig& rig = axel.stereo.nominal;
  EXPECT_EQ(CornersInView(axel.body, {}, rig.left, rig.X_RL), 0);
  EXPECT_EQ(CornersInView(axel.body, {}, rig.right, rig.X_RQ), 0);
  EXPECT_GT(CornersInView(axel.arm, {}, rig.left, rig.X_RL), 0);
}

TEST(AxelWheels, HaveTheirDrawnPaddlesWhereTheSoilFeelsThem) {
  const RoverModel axel = Axel();
  const auto farthest_on_paddle_line = [](const LinkModel& wheel, double phase_rad) {
    const Eigen::Vector3d along = RotY(phase_rad) * Eigen::Vector3d::UnitX();
    double farthest = 0.0;
    for (const Visual& visual : wheel.visuals) {
      for (const Eigen::Vector3d& v : visual.mesh->vertices) {
        farthest = std::max(farthest, (visual.X_LV * v).dot(along));
      }
    }
    return farthest;
  };
  EXPECT_NEAR(farthest_on_paddle_line(axel.left_wheel, axel.left_wheel_soil.phase_rad), 0.30, 1e-6);
  EXPECT_NEAR(farthest_on_paddle_line(axel.right_wheel, axel.right_wheel_soil.phase_rad), 0.30,
              1e-6);
  EXPECT_LT(farthest_on_paddle_line(axel.left_wheel, kPi / 12), 0.295);
}

// It goes round the axle: nothing but the housing, whose middle its root is, may stand in its
// plane.
TEST(AxelArm, GoesRoundBetweenTheBodysHalves) {
  const RoverModel axel = Axel();
  EXPECT_TRUE(std::isinf(axel.arm_lower_rad) && std::isinf(axel.arm_upper_rad));
  const double widest = std::max({axel.tip.radius_m, axel.collar.radius_m, 0.0225});
  for (const Collision& part : axel.body.collisions) {
    if (part.name == "housing") continue;
    const auto* box = std::get_if<BoxShape>(&part.shape);
    ASSERT_NE(box, nullptr) << part.name;
    EXPECT_GT(std::abs(part.X_LG.p.y()) - 0.5 * box->size_m.y(), widest) << part.name;
  }
  // What is drawn outside the housing as well.
  for (const Visual& visual : axel.body.visuals) {
    for (const Eigen::Vector3d& v : visual.mesh->vertices) {
      const double from_housing = std::hypot(v.x() + 0.042, v.z() + 0.022);
      if (from_housing > 0.161) {
        EXPECT_GT(std::abs(v.y()), widest);
      }
    }
  }
}

// As it turns over, the body passes the ground inside the rims.
TEST(AxelBody, TurnsOverWithinItsWheels) {
  const RoverModel axel = Axel();
  for (const Visual& visual : axel.body.visuals) {
    for (const Eigen::Vector3d& v : visual.mesh->vertices) {
      EXPECT_LT(std::hypot(v.x(), v.z()), axel.left_wheel_soil.rim_radius_m + 0.003);
    }
  }
}

TEST(AxelArm, IsDrawnAsLongAsItIs) {
  const RoverModel axel = Axel();
  double front = 0.0;
  for (const Eigen::Vector3d& v : axel.arm.visuals.at(0).mesh->vertices) {
    front = std::max(front, v.x());
  }
  EXPECT_NEAR(front, axel.arm_length_m, 1e-6);
}

TEST(Nominal, TellsNominalNumbers) {
  const RoverModel axel = Axel();
  const StationModel station = LoadStation(SourceFile("models/axel/station/station.yaml"));
  const Nominal nominal = MakeNominal(axel, station, 0.3);
  EXPECT_DOUBLE_EQ(nominal.wheel_radius_m, 0.30);
  EXPECT_DOUBLE_EQ(nominal.track_m, 0.85);
  EXPECT_DOUBLE_EQ(nominal.arm_length_m, 1.0);
  EXPECT_DOUBLE_EQ(nominal.drum_radius_m, 0.06);
  EXPECT_DOUBLE_EQ(nominal.arm_at_zero_rad, 0.3);
  EXPECT_DOUBLE_EQ(nominal.mouth_height_m, 0.34);
  EXPECT_DOUBLE_EQ(nominal.anchor_depth_m, 0.35);
  EXPECT_DOUBLE_EQ(nominal.spool_friction_n, 0.5 / 0.06);
  EXPECT_DOUBLE_EQ(nominal.throat_depth_m, 0.12);
  EXPECT_DOUBLE_EQ(nominal.seat_depth_m, 0.23);
  EXPECT_NEAR(nominal.motors[static_cast<int>(Motor::kSpool)].rad_per_count * 122880, 2 * kPi,
              1e-12);
  EXPECT_EQ(nominal.board.fiducials.size(), 8u);
  // 0.17 m up the face, which is tipped forward by 5 deg.
  EXPECT_NEAR(nominal.X_DB.p.x(), 0.17 * std::sin(Radians(5)), 1e-12);
  EXPECT_NEAR(nominal.X_DB.p.z(), 0.34 + 0.17 * std::cos(Radians(5)), 1e-12);
}

TEST(RoverFile, BadValuesAreToldByPlaceAndPath) {
  EXPECT_THAT(ChangedMessage("axel.yaml", "radius_m: 0.265", "radius_m: ten"),
              "models/axel/axel.yaml:16:13: wheels.radius_m: expected a number > 0, found 'ten'");
  EXPECT_THAT(ChangedMessage("axel.yaml", "count: 12 ", "count: 1e9"),
              HasSubstr("wheels.paddles.count: expected a whole number from 0 to 64, found '1e9'"));
  EXPECT_THAT(ChangedMessage("axel.yaml", "max_current_a: 2.0 ", "max_current_a: 0.1 "),
              HasSubstr("motors.spool.max_current_a: expected more than no_load_current_a"));
  EXPECT_THAT(ChangedMessage("axel.yaml", "position_m: [-0.05, 0, 0.05]", "position_m: [0, 0]"),
              HasSubstr("imu.position_m: expected a list of 3, found a list of 2"));
  EXPECT_THAT(ChangedMessage("axel.yaml", "position_m: [-0.05, 0,", "position_m: [-0.05, up,"),
              HasSubstr("imu.position_m[1]: expected a number from -5 to 5, found 'up'"));
}

TEST(RoverFile, MotorsProfileAndGearsAreOptionalAndChecked) {
  const RoverModel axel = Axel();
  EXPECT_EQ(axel.motors[0].profile, ProfileShape::kTrapezoid);
  const std::string mark = "    counts_per_rev: 204800";
  EXPECT_THAT(ChangedMessage("axel.yaml", mark, "    profile: jerky\n" + mark),
              HasSubstr("motors.wheel.profile: expected one of"));
  EXPECT_THAT(
      ChangedMessage("axel.yaml", "gear_efficiency: 0.8 ", "gear_efficiency: 1.2 "),
      HasSubstr("motors.arm.gear_efficiency: expected a number from 0.2 to 1, found '1.2'"));
}

TEST(RoverFile, ImuIsInTheUnitsOfItsDataSheet) {
  const ImuModel imu = Axel().imu;
  EXPECT_NEAR(imu.gyro_walk_rad_sqrt_s, 4.3633e-5, 1e-9);     // 0.15 deg per root hour
  EXPECT_NEAR(imu.gyro_instability_rad_s, 2.4241e-6, 1e-10);  // 0.5 deg/h
  EXPECT_NEAR(imu.accel_walk_m_s_sqrt_s, 1e-3, 1e-12);        // 0.06 m/s per root hour
}

TEST(RoverFile, MustAgreeWithItsUrdf) {
  EXPECT_THAT(
      ChangedMessage("axel.yaml", "tip_radius_m: 0.0312", "tip_radius_m: 0.034"),
      HasSubstr("arm: expected the radius and front of collision 'tip' of the URDF, 0.0312"));
  EXPECT_THAT(ChangedMessage("axel.yaml", "radius_m: 0.265", "radius_m: 0.300"),
              HasSubstr("wheels: expected rim and paddle to add up to the radius of the wheel's "
                        "collision cylinder in the URDF, 0.3, found 0.335"));
}

TEST(RoverFile, NeedsItsLinksAndJoints) {
  EXPECT_THAT(ChangedMessage("axel.urdf", "<link name=\"arm\">", "<link name=\"boom\">"),
              HasSubstr(": <child>: expected the name of a link, found 'arm'"));
  EXPECT_THAT(ChangedMessage("axel.urdf", "\"arm_joint\"", "\"boom_joint\""),
              HasSubstr("models/axel/axel.urdf: expected a joint named 'arm_joint', found none"));
  EXPECT_THAT(ChangedMessage("axel.urdf", "\"left_wheel_joint\" type=\"continuous\"",
                             "\"left_wheel_joint\" type=\"fixed\""),
              HasSubstr("joint 'left_wheel_joint': expected type continuous, found 'fixed'"));
  EXPECT_THAT(ChangedMessage("axel.urdf", "\"arm_joint\" type=\"continuous\"",
                             "\"arm_joint\" type=\"fixed\""),
              HasSubstr("joint 'arm_joint': expected type continuous or revolute, found 'fixed'"));
}

TEST(RoverFile, AnotherRoversArmMayHaveEndStops) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string urdf = "models/axel/axel.urdf", joint = "\"arm_joint\" type=\"continuous\">";
  folder.Write(urdf,
               Replaced(Slurp(SourceFile(urdf)), joint,
                        "\"arm_joint\" type=\"revolute\">\n<limit lower=\"-1.0\" upper=\"1.3\" "
                        "effort=\"80\" velocity=\"0.5\"/>"));
  const RoverModel rover = LoadRover((folder.path() / "models/axel/axel.yaml").string());
  EXPECT_EQ(rover.arm_lower_rad, -1.0);
  EXPECT_EQ(rover.arm_upper_rad, 1.3);
}

}  // namespace
}  // namespace dockyard::axel
