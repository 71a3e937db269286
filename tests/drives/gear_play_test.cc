// A drive with backlash, bend, homing error and current offset.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "models/read/load_motor.h"
#include "sim/drives/motor_drive.h"
#include "sim/drives/sensor_suite.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

constexpr double kDt_s = 1e-3, kInertia_kg_m2 = 1.0;
constexpr double kServo_nm_per_rad = 1e4 * kInertia_kg_m2;  // 100 rad/s

MotorModel Plain() {
  MotorModel motor;
  motor.torque_per_amp_nm = 10.0;
  motor.max_current_a = 5.0;
  motor.brake_torque_nm = 80.0;
  motor.max_speed_rad_s = 1.0;
  motor.max_accel_rad_s2 = 2.0;
  motor.counts_per_rev = 100000;
  return motor;
}

constexpr MotorCommand At(double rad) { return {MotorMode::kPosition, rad, 1.0, 2.0, 5.0}; }

/// An output with some damping of its own.
struct Output {
  explicit Output(const MotorModel& motor) : drive(motor, kInertia_kg_m2) {}
  void Turn(const MotorCommand& command, double load_nm, double seconds, double damping = 5.0) {
    for (long i = 0; i < std::lround(seconds / kDt_s); ++i) {
      out = drive.Step(command, angle, speed, kDt_s);
      speed += (out.torque_nm() + load_nm - damping * speed) / kInertia_kg_m2 * kDt_s;
      angle += speed * kDt_s;
    }
  }
  double encoder_rad() const { return angle + out.lead_rad; }

  MotorDrive drive;
  double angle = 0.0, speed = 0.0;
  DriveOutput out;
};

TEST(Backlash, PassesNoTorqueWithinItsDeadBandAndTheServosBeyond) {
  MotorModel motor = Plain();
  motor.backlash_rad = 0.02;
  for (const double asked : {-0.013, -0.01, -0.004, 0.0, 0.006, 0.0099, 0.012}) {
    MotorDrive drive(motor, kInertia_kg_m2);
    DriveOutput out;
    for (int i = 0; i < 3000; ++i) out = drive.Step(At(asked), 0.0, 0.0, kDt_s);  // held
    const double beyond = asked - std::clamp(asked, -0.01, 0.01);
    // In series with teeth that are a hundred times stiffer.
    EXPECT_NEAR(out.torque_nm(), beyond * kServo_nm_per_rad / 1.01, 1e-6) << asked;
    EXPECT_NEAR(out.lead_rad, asked - beyond / 101.0 * 100.0, 1e-6) << asked;
  }
}

TEST(Backlash, LetsTheOutputMoveByItselfAsTheLoadTurnsRound) {
  MotorModel motor = Plain();
  motor.backlash_rad = 0.03;
  Output output(motor);
  output.Turn(At(0.5), -5.0, 3.0);
  const double below = output.angle;
  output.Turn(At(0.5), 5.0, 3.0);
  const double servo = 2.0 * 5.0 / kServo_nm_per_rad;  // what the servo itself gives
  EXPECT_NEAR(output.angle - below, 0.03 + 1.01 * servo, 1e-5);
  EXPECT_NEAR(output.encoder_rad(), 0.5 + 0.5 * servo, 1e-5);
}

TEST(Backlash, LeavesABrakedOutputFreeWithinItAlone) {
  MotorModel motor = Plain();
  motor.backlash_rad = 0.03;
  Output output(motor);
  output.Turn({}, 2.0, 2.0);
  const double above = output.angle;
  output.Turn({}, -2.0, 2.0);
  EXPECT_NEAR(above - output.angle, 0.03, 1e-3);  // and the brake's bristle
}

TEST(Bend, DeflectsTheOutputByTorqueOverStiffness) {
  for (const double stiffness : {200.0, 2e3, 2e5}) {
    MotorModel motor = Plain();
    motor.bend_nm_per_rad = stiffness;
    Output output(motor);
    output.Turn(At(0.4), -8.0, 12.0, 20.0);
    EXPECT_NEAR(output.encoder_rad() - output.angle, 8.0 / stiffness, 1e-5) << stiffness;
    EXPECT_NEAR(output.encoder_rad(), 0.4 - 8.0 / kServo_nm_per_rad, 1e-5) << stiffness;
  }
}

TEST(Bend, LetsTheOutputSwingAtTheRootOfStiffnessOverInertia) {
  MotorModel motor = Plain();
  motor.bend_nm_per_rad = 100.0;
  Output output(motor);
  output.Turn(At(0.0), 0.0, 0.1);
  output.angle = 0.05;
  double last = output.angle, first_s = 0.0, time_s = 0.0;
  int crossings = 0;
  while (crossings < 9 && time_s < 10.0) {
    output.Turn(At(0.0), 0.0, kDt_s, 0.0);
    time_s += kDt_s;
    if ((last > 0.0) != (output.angle > 0.0) && ++crossings == 1) first_s = time_s;
    last = output.angle;
  }
  ASSERT_EQ(crossings, 9);
  EXPECT_NEAR((time_s - first_s) / 4.0, 2.0 * kPi / 10.0, 0.02 * 2.0 * kPi / 10.0);
}

TEST(Bend, StiffEnoughIsTheRigidDrive) {
  MotorModel stiff = Plain();
  stiff.bend_nm_per_rad = 1e8;
  stiff.gear_friction_nm = 1.0;
  stiff.gear_efficiency = 0.8;
  MotorModel rigid = stiff;
  rigid.bend_nm_per_rad = 0.0;
  Output a(stiff), b(rigid);
  for (const double target : {0.5, -0.2, 0.1}) {
    for (int i = 0; i < 10; ++i) {
      a.Turn(At(target), -3.0, 0.1);
      b.Turn(At(target), -3.0, 0.1);
      EXPECT_NEAR(a.angle, b.angle, 1e-4);
    }
  }
  EXPECT_EQ(b.out.lead_rad, 0.0);
}

TEST(HomingError, PutsTheOutputOffItsTargetAndTheEncoderOnIt) {
  MotorModel motor = Plain();
  motor.homing_error_rad = 0.02;
  Output output(motor);
  output.Turn(At(0.5), 0.0, 3.0);
  EXPECT_NEAR(output.angle, 0.48, 1e-6);
  SensorSuite sensors(ImuModel{}, {motor}, 20, 1);
  const SensorFrame frame =
      sensors.Read(0, {{.angle_rad = output.angle, .lead_rad = output.out.lead_rad}}, ImuSample{});
  const double read_rad = static_cast<double>(frame.motors[0].encoder_counts) * 2.0 * kPi / 1e5;
  EXPECT_NEAR(read_rad, 0.5, 4e-5);
}

TEST(CurrentOffset, IsInEachReadingOfWhatIsDrawn) {
  MotorModel motor = Plain();
  motor.current_offset_a = -0.3;
  SensorSuite sensors(ImuModel{}, {motor}, 20, 1);
  const auto read = [&](double drawn_a) {
    return sensors.Read(0, {{.current_a = drawn_a}}, ImuSample{}).motors[0].current_a;
  };
  EXPECT_DOUBLE_EQ(read(1.0), 0.7);
  EXPECT_DOUBLE_EQ(read(2.5), 2.2);
  EXPECT_EQ(read(0.1), 0.0);  // a magnitude
}

TEST(MotorFile, PlayBendHomingAndOffsetAreOptionalAndZeroUnlessGiven) {
  const ScratchFolder folder;
  const std::string plain =
      "torque_per_amp_nm: 1\nno_load_current_a: 0\nmax_current_a: 1\ngear_friction_nm: 0\n"
      "brake_torque_nm: 1\nmax_speed_rad_s: 1\nmax_accel_rad_s2: 1\nreflected_inertia_kg_m2: 1\n"
      "counts_per_rev: 100\ncurrent_noise_a: 0\n";
  const auto load = [&](const std::string& more) {
    const YamlNode root = LoadYaml(folder.Write("motor.yaml", plain + more));
    MotorModel motor;
    ReadKeys(root, "motor", [&](Keys& keys) { VisitMotor(keys, motor); });
    return motor;
  };
  const MotorModel none = load("");
  EXPECT_EQ(none.backlash_rad, 0.0);
  EXPECT_EQ(none.bend_nm_per_rad, 0.0);
  EXPECT_EQ(none.homing_error_rad, 0.0);
  EXPECT_EQ(none.current_offset_a, 0.0);
  EXPECT_EQ(none.current_offset_sigma_a, 0.0);
  EXPECT_EQ(none.current_scale_share, 0.0);
  const MotorModel all = load(
      "backlash_deg: 0.5\nbend_nm_per_rad: 300\nhoming_error_deg: -1\ncurrent_offset_a: 0.1\n"
      "current_offset_sigma_a: 0.02\ncurrent_scale_share: 0.03\n");
  EXPECT_DOUBLE_EQ(all.backlash_rad, Radians(0.5));
  EXPECT_EQ(all.bend_nm_per_rad, 300.0);
  EXPECT_DOUBLE_EQ(all.homing_error_rad, Radians(-1.0));
  EXPECT_EQ(all.current_offset_a, 0.1);
  EXPECT_EQ(all.current_offset_sigma_a, 0.02);
  EXPECT_EQ(all.current_scale_share, 0.03);
  EXPECT_THAT(MessageOf([&] { load("backlash_deg: -1\n"); }, folder),
              HasSubstr("motor.yaml:11:15: motor.backlash_deg: expected a number >= 0"));
}

}  // namespace
}  // namespace dockyard
