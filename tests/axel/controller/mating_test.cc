#include "controller/axel/mating.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/kinematic_rover.h"

namespace dockyard::axel {
namespace {

constexpr double kFloor = 0.23;
const MateOptions kMate;

TEST(SeatRuling, PictureDecidesWhateverTheDrumSays) {
  for (const double drum : {0.10, 0.19, 0.23, 0.30}) {
    for (const std::optional<double> push :
         {std::optional<double>{}, std::optional<double>{0.02}}) {
      EXPECT_EQ(RuleSeat({drum, 0.229, push}, kFloor, kMate), SeatRuling::kSeated);
      EXPECT_EQ(RuleSeat({drum, 0.195, push}, kFloor, kMate), SeatRuling::kShort);
    }
  }
}

TEST(SeatRuling, WithoutPictureAPushMustFindTheTipFirm) {
  EXPECT_EQ(RuleSeat({0.23, {}, {}}, kFloor, kMate), SeatRuling::kUnproven);
  EXPECT_EQ(RuleSeat({0.23, {}, 0.001}, kFloor, kMate), SeatRuling::kSeated);
  EXPECT_EQ(RuleSeat({0.23, {}, 0.02}, kFloor, kMate), SeatRuling::kShort);
}

TEST(SeatRuling, DrumThatIsNotDeepEnoughIsShortHoweverFirm) {
  EXPECT_EQ(RuleSeat({0.195, {}, {}}, kFloor, kMate), SeatRuling::kShort);
  EXPECT_EQ(RuleSeat({0.195, {}, 0.0}, kFloor, kMate), SeatRuling::kShort);
}

// Against poses put together from the other end: tip in the dock, then body, then board.
TEST(DepthBySighting, IsThatOfTheTipWhateverTheBodysPitchAndTheArmsAngle) {
  const Nominal nominal = TestNominal();
  for (const double depth : {-0.3, 0.0, 0.19, 0.23}) {
    for (const double pitch : {-0.2, 0.0, 0.1}) {
      for (const double arm : {-0.1, 0.0, 0.3}) {
        const double elevation = -(pitch + arm);
        const Pose2 X_DR{nominal.arm_length_m * std::cos(elevation) - depth, 0.01, kPi};
        const Pose3 X_HR{RotY(pitch), Eigen::Vector3d::Zero()};
        const Pose3 X_RB = Inverse(FromGround(X_DR, nominal.wheel_radius_m) * X_HR) * nominal.X_DB;
        EXPECT_NEAR(DepthBySighting(nominal, X_RB, arm), depth, 1e-12);
      }
    }
  }
}

class Wiggle : public testing::Test {
 protected:
  /// Steps the reel-in while nothing moves, until it has stopped; returns the commands.
  std::vector<Commands> UntilItStops() {
    std::vector<Commands> sent;
    for (int i = 0; i < 2'000; ++i) {
      frame_.tick += kControlPeriod;
      senses_.Update(frame_);
      Commands commands = BrakedCommands();
      if (reel_in_.Step(senses_, &commands)) return sent;
      sent.push_back(commands);
    }
    ADD_FAILURE() << "never stops";
    return sent;
  }

  Nominal nominal_ = TestNominal();
  AxelOptions options_;
  SensorFrame frame_ = StillFrame();
  Senses senses_{nominal_, options_};
  ReelIn reel_in_{nominal_, options_};
};

TEST_F(Wiggle, TurnsToAndFroWithoutGoingOnAndEndsWhereItBegan) {
  senses_.Update(frame_);
  reel_in_.Begin(senses_, 0.0);
  double hardest = 0.0;
  for (int k = 1; k <= options_.mate.wiggles; ++k) {
    reel_in_.Wiggle(senses_);
    double turned = 0.0, most = 0.0;
    for (const Commands& commands : UntilItStops()) {
      const MotorCommand& left = commands.motors[static_cast<std::size_t>(Motor::kLeftWheel)];
      const MotorCommand& right = commands.motors[static_cast<std::size_t>(Motor::kRightWheel)];
      EXPECT_GT(commands.motors[static_cast<std::size_t>(Motor::kSpool)].target, 0.0);
      if (left.mode == MotorMode::kFree || left.target == right.target) continue;  // after it
      EXPECT_DOUBLE_EQ(left.target, -right.target);
      turned += right.target;
      most = std::max(most, right.target);
    }
    EXPECT_NEAR(turned, 0.0, most + 1e-9);  // but for one control period
    EXPECT_GT(most, hardest);               // each time harder
    hardest = most;
  }
}

TEST_F(Wiggle, WheelsRunAlongWithLittleThrustAndAreFreeAtTheEnd) {
  senses_.Update(frame_);
  reel_in_.Begin(senses_, 0.05);
  bool free = false;
  double last_thrust_n = 0.0;
  const std::vector<Commands> sent = UntilItStops();
  for (const Commands& commands : sent) {
    double thrust_n = 0.0;
    for (const Motor wheel : {Motor::kLeftWheel, Motor::kRightWheel}) {
      const auto i = static_cast<std::size_t>(wheel);
      const MotorCommand& command = commands.motors[i];
      const NominalMotor& motor = nominal_.motors[i];
      free = free || command.mode == MotorMode::kFree;
      if (free) {
        EXPECT_EQ(command.mode, MotorMode::kFree);
        continue;
      }
      EXPECT_EQ(command.mode, MotorMode::kVelocity);
      EXPECT_DOUBLE_EQ(command.target, options_.tether.reel_m_s / nominal_.wheel_radius_m);
      thrust_n += (command.current_limit_a - motor.no_load_current_a) * motor.torque_per_amp_nm /
                  nominal_.wheel_radius_m;
    }
    if (!free && &commands == &sent.front()) {
      EXPECT_NEAR(thrust_n, options_.mate.thrust_n, 1e-9);
    }
    if (!free) last_thrust_n = thrust_n;
  }
  EXPECT_NEAR(last_thrust_n, options_.mate.still_thrust_n, 1e-9);
  EXPECT_TRUE(free);
}

TEST_F(Wiggle, SpoolPullsGentlyFirstThenAsHardAsItCan) {
  senses_.Update(frame_);
  reel_in_.Begin(senses_, 0.05);
  const std::vector<Commands> sent = UntilItStops();
  const auto tension_n = [&](const Commands& commands) {
    const double current_a =
        commands.motors[static_cast<std::size_t>(Motor::kSpool)].current_limit_a;
    return TensionFromCurrent(nominal_, current_a) - nominal_.spool_friction_n;
  };
  EXPECT_NEAR(tension_n(sent.front()), options_.mate.gentle_tension_n, 1e-9);
  EXPECT_NEAR(tension_n(sent.back()), options_.tether.reel_tension_n, 1e-9);
  for (std::size_t i = 1; i < sent.size(); ++i)
    EXPECT_GE(tension_n(sent[i]), tension_n(sent[i - 1]));
}

}  // namespace
}  // namespace dockyard::axel
