// The spool's pull in the search: gently, with a push of the wheels over a paddle, then harder, and
// never so that the station slides.
#include "controller/axel/tether_pull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/drive.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {
namespace {

class Pull : public testing::Test {
 protected:
  struct Command {
    double tension_n = 0.0, thrust_n = 0.0;
    bool pushes = false;
  };
  struct Motion {
    double taken_up_m_s = 0.0, rolled_m_s = 0.0;
  };
  /// Steps for so long, and moves as the function of its commands says. How the pull ends.
  TetherPull::Status RunFor(double seconds, const std::function<Motion(const Command&)>& motion) {
    senses_.Update(frame_);
    pull_.Begin(senses_);
    for (int i = 0; i < seconds / kTickSeconds / kControlPeriod; ++i) {
      Commands commands = BrakedCommands();
      const TetherPull::Status status = pull_.Step(senses_, &commands);
      if (status != TetherPull::Status::kPulls) return status;
      const auto spool = commands.motors[static_cast<std::size_t>(Motor::kSpool)];
      const auto wheel = commands.motors[static_cast<std::size_t>(Motor::kLeftWheel)];
      command_ = {.tension_n = TensionFromCurrent(nominal_, spool.current_limit_a),
                  .pushes = wheel.mode == MotorMode::kVelocity};
      pushed_ = pushed_ || command_.pushes;
      pushed_back_ = pushed_back_ || (command_.pushes && wheel.target < 0.0);
      most_n_ = std::max(most_n_, command_.tension_n);
      const Motion moved = motion(command_);
      reeled_m_ += moved.taken_up_m_s * kTickSeconds * kControlPeriod;
      rolled_m_ += moved.rolled_m_s * kTickSeconds * kControlPeriod;
      frame_.tick += kControlPeriod;
      Turn(Motor::kSpool,
           (reeled_m_ + stretch_m_per_n_ * command_.tension_n) / nominal_.drum_radius_m);
      Turn(Motor::kLeftWheel, rolled_m_ / nominal_.wheel_radius_m);
      Turn(Motor::kRightWheel, rolled_m_ / nominal_.wheel_radius_m);
      senses_.Update(frame_);
    }
    return TetherPull::Status::kPulls;
  }
  void Turn(Motor motor, double angle_rad) {
    const auto i = static_cast<std::size_t>(motor);
    frame_.motors[i].encoder_counts =
        static_cast<std::int64_t>(angle_rad / nominal_.motors[i].rad_per_count);
  }
  double SureLevelPull() const {
    return SetPointBelow(SureHold(nominal_, options_.hold, 0.0, 0.0), options_.hold);
  }

  const Nominal nominal_ = TestNominal();
  const AxelOptions options_{};
  SensorFrame frame_ = StillFrame();
  Senses senses_{nominal_, options_};
  TetherPull pull_{nominal_, options_};
  double reeled_m_ = 0.0, rolled_m_ = 0.0, most_n_ = 0.0, stretch_m_per_n_ = 0.0;
  bool pushed_ = false, pushed_back_ = false;
  Command command_;
};

TEST_F(Pull, IsGentleWhileTheRoverComesNearer) {
  EXPECT_EQ(RunFor(20.0,
                   [](const Command&) {
                     return Motion{0.03, 0.03};
                   }),
            TetherPull::Status::kPulls);
  EXPECT_LE(most_n_, options_.tether.first_tension_n + 1e-9);
  EXPECT_FALSE(pushed_);
}

TEST_F(Pull, WheelsPushOverWhatStopsIt) {
  EXPECT_EQ(RunFor(20.0,
                   [&](const Command& command) {
                     const bool at_paddle = std::fmod(reeled_m_, 0.15) > 0.13;
                     return command.pushes || !at_paddle ? Motion{0.03, 0.03} : Motion{};
                   }),
            TetherPull::Status::kPulls);
  EXPECT_TRUE(pushed_);
  EXPECT_FALSE(pushed_back_);
}

TEST_F(Pull, WheelsPushBackARoverThatIsDrawnBackwards) {
  RunFor(6.0, [&](const Command& command) {
    return command.pushes || reeled_m_ < 0.1 ? Motion{0.03, -0.03} : Motion{};
  });
  EXPECT_TRUE(pushed_back_);
}

// 35 kg on soles with a friction of 0.4 bear 137 N, with the worst of their tolerances 104 N.
TEST_F(Pull, IsNeverSoHardThatTheStationMaySlide) {
  EXPECT_EQ(RunFor(20.0, [](const Command&) { return Motion{}; }), TetherPull::Status::kStalls);
  EXPECT_TRUE(pushed_);
  EXPECT_NEAR(most_n_, SureLevelPull(), 1e-6);
  EXPECT_LT(most_n_ * 1.25, 104.5);
}

TEST_F(Pull, StallsThoughTheTetherStretches) {
  stretch_m_per_n_ = 1e-4;
  EXPECT_EQ(RunFor(12.0, [](const Command&) { return Motion{}; }), TetherPull::Status::kStalls);
  EXPECT_TRUE(pushed_);
}

// The drum takes up tether, and neither wheels nor inertial unit show that the rover moves.
TEST_F(Pull, IsWeakerWhereItDragsTheStation) {
  EXPECT_FALSE(pull_.slid());
  double slid_m = 0.0;
  EXPECT_EQ(RunFor(12.0,
                   [&](const Command& command) {
                     if (reeled_m_ < 0.03) return Motion{0.03, 0.03};
                     const bool slides = command.tension_n > 60.0 && senses_.now() > 2000;
                     slid_m += slides ? 0.03 * kTickSeconds * kControlPeriod : 0.0;
                     return slides ? Motion{0.03, 0.0} : Motion{};
                   }),
            TetherPull::Status::kStalls);
  EXPECT_TRUE(pull_.slid());
  EXPECT_LT(slid_m, 0.035);
  EXPECT_LT(command_.tension_n, 60.0);
}

}  // namespace
}  // namespace dockyard::axel
