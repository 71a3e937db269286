#include "controller/axel/mating.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/seat_check.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {
namespace {

constexpr double kFloor = 0.23;
const MateOptions kMate;

TEST(SeatRuling, PictureDecidesWhateverTheDrumSays) {
  for (const double drum : {0.10, 0.19, 0.23, 0.30}) {
    for (const std::optional<double> push :
         {std::optional<double>{}, std::optional<double>{0.02}}) {
      EXPECT_EQ(RuleSeat({drum, TipSeen{0.229, 0.01}, push}, kFloor, kMate), SeatRuling::kSeated);
      EXPECT_EQ(RuleSeat({drum, TipSeen{0.195, 0.01}, push}, kFloor, kMate), SeatRuling::kShort);
    }
  }
}

TEST(SeatRuling, ArmThatLeansBeyondItsPlayIsAskewHoweverDeep) {
  for (const double side : {-1.0, 1.0}) {
    EXPECT_EQ(RuleSeat({0.23, TipSeen{0.23, side * Radians(1.5)}, {}}, kFloor, kMate),
              SeatRuling::kSeated);
    EXPECT_EQ(RuleSeat({0.23, TipSeen{0.23, side * Radians(2.5)}, 0.0}, kFloor, kMate),
              SeatRuling::kAskew);
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
TEST(SightingAtHome, GivesDepthAndLeanWhateverTheBodysPitchAndTheArmsAngle) {
  const Nominal nominal = TestNominal();
  for (const double depth : {-0.3, 0.0, 0.19, 0.23}) {
    for (const double pitch : {-0.2, 0.0, 0.1}) {
      for (const double arm : {-0.1, 0.0, 0.3}) {
        for (const double askew : {-0.05, 0.0, 0.02}) {
          const double reach_m = nominal.arm_length_m * std::cos(pitch + arm);
          // Towards D's +y is clockwise for a rover that faces the dock.
          const Pose2 X_DR{reach_m * std::cos(askew) - depth, 0.01, kPi - askew};
          const Pose3 X_HR{RotY(pitch), Eigen::Vector3d::Zero()};
          const Pose3 X_RB =
              Inverse(FromGround(X_DR, nominal.wheel_radius_m) * X_HR) * nominal.X_DB;
          EXPECT_NEAR(DepthBySighting(nominal, X_RB, arm), depth, 1e-12);
          EXPECT_NEAR(AskewBySighting(nominal, X_RB, arm), askew, 1e-12);
        }
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
  nominal_.paddle_pitch_m = 0.0;  // of smooth wheels, which need no roll
  reel_in_ = ReelIn(nominal_, options_);
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

TEST_F(Wiggle, SecondRollsHalfAPitchBackWithTheSpoolGivingWayAndOnAgain) {
  senses_.Update(frame_);
  reel_in_.Begin(senses_, 0.0);
  reel_in_.Wiggle(senses_);
  UntilItStops();
  reel_in_.Wiggle(senses_);
  const std::vector<Commands> sent = UntilItStops();
  double way_m = 0.0, furthest_back_m = 0.0;
  for (std::size_t i = 0;
       i < static_cast<std::size_t>(4 * options_.mate.wiggle_quarter / kControlPeriod); ++i) {
    const MotorCommand& left = sent[i].motors[static_cast<std::size_t>(Motor::kLeftWheel)];
    const MotorCommand& right = sent[i].motors[static_cast<std::size_t>(Motor::kRightWheel)];
    const MotorCommand& spool = sent[i].motors[static_cast<std::size_t>(Motor::kSpool)];
    EXPECT_DOUBLE_EQ(left.target, right.target);
    if (left.target < 0.0) {
      EXPECT_DOUBLE_EQ(TensionFromCurrent(nominal_, spool.current_limit_a),
                       options_.tether.reverse_tension_n);
    }
    way_m += left.target * nominal_.wheel_radius_m * kTickSeconds * kControlPeriod;
    furthest_back_m = std::min(furthest_back_m, way_m);
  }
  const double step_m = 0.001;  // of one control period
  EXPECT_NEAR(furthest_back_m, -0.5 * nominal_.paddle_pitch_m, step_m);
  EXPECT_NEAR(way_m, 0.0, 2.0 * step_m);
}

class Straightening : public Wiggle {
 protected:
  /// What is left of the lean, of a rover that turns by this share of what its wheels are told.
  double LeftOf(double lean_rad, double response) {
    Straighten straighten(lean_rad);
    turns_ = 0;
    for (int i = 0; i < 500; ++i) {
      frame_.tick += kControlPeriod;
      senses_.Update(frame_);
      Commands commands = BrakedCommands();
      if (straighten.Step(nominal_, senses_, options_.mate, &commands))
        return straighten.LeanLeft(senses_);
      const MotorCommand& left = commands.motors[static_cast<std::size_t>(Motor::kLeftWheel)];
      const MotorCommand& right = commands.motors[static_cast<std::size_t>(Motor::kRightWheel)];
      if (left.mode != MotorMode::kVelocity) continue;
      ++turns_;
      const double rate = (right.target - left.target) * nominal_.wheel_radius_m / nominal_.track_m;
      frame_.imu.yaw_rad += response * rate * kTickSeconds * kControlPeriod;
    }
    ADD_FAILURE() << "never ends";
    return 0.0;
  }
  int turns_ = 0;
};

TEST_F(Straightening, TurnsAnArmThatLeansToEitherSideUntilItIsNearlyStraight) {
  for (const double side : {-1.0, 1.0}) {
    const double left_rad = LeftOf(side * Radians(2.3), 1.0);
    EXPECT_NEAR(Degrees(left_rad), side * Degrees(options_.mate.straight_rad), 0.1);
  }
}

TEST_F(Straightening, LeavesAnArmAloneThatIsStraightEnough) {
  EXPECT_DOUBLE_EQ(LeftOf(0.9 * options_.mate.straighten_rad, 1.0),
                   0.9 * options_.mate.straighten_rad);
  EXPECT_EQ(turns_, 0);
}

TEST_F(Straightening, OfARoverThatDoesNotTurnEndsAndLeavesTheLean) {
  EXPECT_DOUBLE_EQ(LeftOf(Radians(2.3), 0.0), Radians(2.3));
  EXPECT_GT(turns_, 0);
}

class EnteringTheMouth : public Wiggle {
 protected:
  Entry entry_{nominal_, options_};

  /// Steps with wheels that push like this and roll like this, until the entry is over or the time
  /// is; returns how long it took [s].
  double SecondsUntilOver(double thrust_n, double speed_m_s, double tip_gap_m, double roll_rad) {
    const auto left = static_cast<std::size_t>(Motor::kLeftWheel);
    frame_.imu.roll_rad = roll_rad;
    for (const auto i : {left, static_cast<std::size_t>(Motor::kRightWheel)}) {
      const NominalMotor& motor = nominal_.motors[i];
      frame_.motors[i].current_a = motor.no_load_current_a + 0.5 * thrust_n *
                                                                 nominal_.wheel_radius_m /
                                                                 motor.torque_per_amp_nm;
    }
    double rolled_m = 0.0;
    for (int i = 0; i < 1'000; ++i) {
      frame_.tick += kControlPeriod;
      rolled_m += speed_m_s * kTickSeconds * kControlPeriod;
      for (const auto m : {left, static_cast<std::size_t>(Motor::kRightWheel)}) {
        frame_.motors[m].encoder_counts = static_cast<std::int64_t>(
            std::round(rolled_m / nominal_.wheel_radius_m / nominal_.motors[m].rad_per_count));
      }
      senses_.Update(frame_);
      if (entry_.Over(senses_, tip_gap_m)) return kTickSeconds * kControlPeriod * (i + 1);
    }
    return kNever;
  }
  static constexpr double kNever = 1e9;
  static constexpr double kSpeed = 0.03;
};

TEST_F(EnteringTheMouth, IsOverWhereTheTipIsDeepEnoughAndTheAxleLevel) {
  EXPECT_LT(SecondsUntilOver(20.0, kSpeed, -0.04, 0.0), 0.1);
  EXPECT_FALSE(entry_.felt());
}

TEST_F(EnteringTheMouth, GoesOnWhileTheTipIsNotDeepOrTheAxleNotLevel) {
  EXPECT_EQ(SecondsUntilOver(20.0, kSpeed, 0.02, 0.0), kNever);
  EXPECT_EQ(SecondsUntilOver(20.0, kSpeed, -0.04, Radians(2.0)), kNever);
}

TEST_F(EnteringTheMouth, IsOverOnceWheelsPushAndDoNotRoll) {
  EXPECT_NEAR(SecondsUntilOver(options_.mate.enter_thrust_n, 0.0, 0.03, 0.0), 0.5, 0.4);
  EXPECT_TRUE(entry_.felt());
}

TEST_F(EnteringTheMouth, WheelsThatPushAndRollOrStandWithoutPushingFeelNothing) {
  EXPECT_EQ(SecondsUntilOver(options_.mate.enter_thrust_n, kSpeed, 0.03, 0.0), kNever);
  EXPECT_EQ(SecondsUntilOver(20.0, 0.0, 0.03, 0.0), kNever);
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
  // On level ground the station bears less for sure than the gentle pull.
  const double sure_n = SetPointBelow(SureHold(nominal_, options_.hold, 0.0, 0.0), options_.hold);
  ASSERT_LT(sure_n, options_.mate.gentle_tension_n);
  EXPECT_NEAR(tension_n(sent.front()), sure_n, 1e-9);
  EXPECT_NEAR(tension_n(sent.back()), options_.tether.reel_tension_n, 1e-9);
  for (std::size_t i = 1; i < sent.size(); ++i)
    EXPECT_GE(tension_n(sent[i]), tension_n(sent[i - 1]));
}

/// Whether the wheels turn a rover whose image shows its tip so deep, with its arm 3 deg aside.
bool TurnsInItsSeat(double depth_m) {
  const Nominal nominal = TestNominal();
  const AxelOptions options{};
  Senses senses(nominal, options);
  SightingJudge judge(LookOptions{}, nominal.X_DB);
  SeatCheck check(nominal, options);
  const double heading = kPi - Radians(3.0), arm_m = nominal.arm_length_m;
  const Pose2 X_DR{-depth_m - arm_m * std::cos(heading), -arm_m * std::sin(heading), heading};
  const Locator locate = [&](const StereoImages&, const LocateHints&) {
    LocateOutput out{PoseFailure::kNoCorrespondence, {}};
    out.sighting = DockSighting{Inverse(FromGround(X_DR, nominal.wheel_radius_m)) * nominal.X_DB,
                                1.0, 14, true};
    return out;
  };
  check.Begin();
  SensorFrame frame = StillFrame();
  frame.imu.specific_force_R.z() = 9.81;
  bool asked = false, turns = false, over = false;
  for (Tick tick = 0; tick < 60'000 && !over; tick += kControlPeriod) {
    frame.tick = tick;
    frame.images.clear();
    const GrayImage gray{2, 1, {7, 9}};
    if (asked) frame.images = {{kLeftCamera, gray, tick}, {kRightCamera, gray, tick}};
    senses.Update(frame);
    Commands commands = BrakedCommands();
    over = check.Step(frame, tick, locate, &judge, &senses, &commands);
    asked = !commands.take_images.empty();
    turns = turns || commands.motors[0].target * commands.motors[1].target < 0.0;
  }
  EXPECT_TRUE(over);
  EXPECT_TRUE(check.tip());
  return turns;
}

TEST(SeatCheck, StraightensAnArmOnTheFloorAndNoneThatStoppedShort) {
  const double seat_m = TestNominal().seat_depth_m;
  EXPECT_TRUE(TurnsInItsSeat(seat_m));
  EXPECT_FALSE(TurnsInItsSeat(seat_m - 0.04));
}

}  // namespace
}  // namespace dockyard::axel
