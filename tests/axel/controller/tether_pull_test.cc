// The spool's pull in the search: gently, with a push of the wheels over a paddle, then harder.
#include "controller/axel/tether_pull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/drive.h"

namespace dockyard::axel {
namespace {

class Pull : public testing::Test {
 protected:
  struct Told {
    double tension_n = 0.0;
    bool pushes = false;
  };
  /// Steps for so long, with a tether taken up as the function of what it was told; whether it
  /// ended stalled.
  bool StallsWithin(double seconds, const std::function<double(const Told&)>& takes_up_m_s) {
    senses_.Update(frame_);
    pull_.Begin(senses_);
    for (int i = 0; i < seconds / kTickSeconds / kControlPeriod; ++i) {
      Commands commands = BrakedCommands();
      if (pull_.Step(senses_, &commands)) return true;
      const auto spool = commands.motors[static_cast<std::size_t>(Motor::kSpool)];
      const auto wheel = commands.motors[static_cast<std::size_t>(Motor::kLeftWheel)];
      told_ = {TensionFromCurrent(nominal_, spool.current_limit_a),
               wheel.mode == MotorMode::kVelocity};
      pushed_ = pushed_ || told_.pushes;
      most_n_ = std::max(most_n_, told_.tension_n);
      reeled_m_ += takes_up_m_s(told_) * kTickSeconds * kControlPeriod;
      frame_.tick += kControlPeriod;
      frame_.motors[static_cast<std::size_t>(Motor::kSpool)].encoder_counts =
          static_cast<std::int64_t>(
              (reeled_m_ + StretchAt(told_.tension_n)) / nominal_.drum_radius_m /
              nominal_.motors[static_cast<std::size_t>(Motor::kSpool)].rad_per_count);
      senses_.Update(frame_);
    }
    return false;
  }
  double StretchAt(double tension_n) const { return stretch_m_per_n_ * tension_n; }

  const Nominal nominal_ = TestNominal();
  const AxelOptions options_{};
  SensorFrame frame_ = StillFrame();
  Senses senses_{nominal_, options_};
  TetherPull pull_{nominal_, options_};
  double reeled_m_ = 0.0, most_n_ = 0.0, stretch_m_per_n_ = 0.0;
  bool pushed_ = false;
  Told told_;
};

TEST_F(Pull, IsGentleWhileTheRoverComesNearer) {
  EXPECT_FALSE(StallsWithin(20.0, [](const Told&) { return 0.03; }));
  EXPECT_NEAR(most_n_, options_.tether.first_tension_n, 1e-9);
  EXPECT_FALSE(pushed_);
}

TEST_F(Pull, WheelsPushOverWhatStopsIt) {
  EXPECT_FALSE(StallsWithin(20.0, [&](const Told& told) {
    const bool at_paddle = std::fmod(reeled_m_, 0.15) > 0.13;
    return told.pushes || !at_paddle ? 0.03 : 0.0;
  }));
  EXPECT_TRUE(pushed_);
  EXPECT_NEAR(most_n_, options_.tether.first_tension_n, 1e-9);
}

TEST_F(Pull, IsHarderWhereAPushDoesNotHelp) {
  EXPECT_FALSE(StallsWithin(20.0, [&](const Told& told) {
    return told.tension_n > options_.tether.first_tension_n + 1.0 ? 0.03 : 0.0;
  }));
  EXPECT_NEAR(most_n_, options_.tether.search_tension_n, 1e-9);
}

// 35 N more stretch the tether by more than a rover at rest may creep.
TEST_F(Pull, StallsThoughTheTetherStretches) {
  stretch_m_per_n_ = 1e-4;
  EXPECT_TRUE(StallsWithin(8.0, [](const Told&) { return 0.0; }));
  EXPECT_TRUE(pushed_);
  EXPECT_NEAR(most_n_, options_.tether.search_tension_n, 1e-9);
}

}  // namespace
}  // namespace dockyard::axel
