#include "straight_in.h"

#include <algorithm>
#include <cmath>

namespace {

using dockyard::Belief;
using dockyard::Commands;
using dockyard::MotorCommand;
using dockyard::MotorMode;
using dockyard::SensorFrame;
using dockyard::Tick;
using dockyard::axel::Motor;
using dockyard::axel::Nominal;

constexpr double kReel_m_s = 0.05;       // assumed, 0.03-0.10
constexpr double kPull_n = 300.0;        // what a forced fit into the cone takes; assumed, 105-300
constexpr double kDrumAccel_rad_s2 = 2;  // 0.05 m/s within half a second; assumed, 1-5
constexpr double kStall_m = 0.002;       // taken up less than this for kStalled: reeled in
constexpr Tick kStalled = 2000;          // [ms] assumed, 1000-4000
constexpr double kArmSpeed_rad_s = 0.17, kArmAccel_rad_s2 = 1.0;  // of the drive; assumed

class StraightIn final : public dockyard::Controller {
 public:
  explicit StraightIn(const Nominal& nominal) : nominal_(nominal) {}

  Commands Step(const SensorFrame& sensed) override {
    const double reeled_m = Reeled(sensed);
    if (std::abs(reeled_m - anchor_m_) > kStall_m) {
      anchor_m_ = reeled_m;
      still_since_ = sensed.tick;
    }
    Commands commands = dockyard::axel::BrakedCommands();
    if (sensed.tick - still_since_ > kStalled) {
      commands.verdict = dockyard::Verdict::kDone;
    } else {
      Of(commands, Motor::kLeftWheel) = Of(commands, Motor::kRightWheel) = {MotorMode::kFree};
      Of(commands, Motor::kSpool) = {.mode = MotorMode::kVelocity,
                                     .target = kReel_m_s / nominal_.drum_radius_m,
                                     .accel_rad_s2 = kDrumAccel_rad_s2,
                                     .current_limit_a = PullCurrent()};
    }
    Of(commands, Motor::kArm) = {.mode = MotorMode::kPosition,
                                 .speed_limit_rad_s = kArmSpeed_rad_s,
                                 .accel_rad_s2 = kArmAccel_rad_s2,
                                 .current_limit_a = OfNominal(Motor::kArm).max_current_a};
    belief_.phase = commands.verdict == dockyard::Verdict::kDone ? "docked" : "reel";
    return commands;
  }

  const Belief& belief() const override { return belief_; }

 private:
  static MotorCommand& Of(Commands& commands, Motor motor) {
    return commands.motors[static_cast<std::size_t>(motor)];
  }
  const dockyard::NominalMotor& OfNominal(Motor motor) const {
    return nominal_.motors[static_cast<std::size_t>(motor)];
  }
  double Reeled(const SensorFrame& sensed) const {
    const auto& spool = sensed.motors[static_cast<std::size_t>(Motor::kSpool)];
    return static_cast<double>(spool.encoder_counts) * OfNominal(Motor::kSpool).rad_per_count *
           nominal_.drum_radius_m;
  }
  /// The spool's current at kPull_n, as far as the motor may.
  double PullCurrent() const {
    const dockyard::NominalMotor& spool = OfNominal(Motor::kSpool);
    return std::min(
        spool.max_current_a,
        spool.no_load_current_a + kPull_n * nominal_.drum_radius_m / spool.torque_per_amp_nm);
  }

  const Nominal nominal_;
  double anchor_m_ = 0.0;
  Tick still_since_ = 0;
  Belief belief_;
};

}  // namespace

std::unique_ptr<dockyard::Controller> MakeStraightIn(const Nominal& nominal) {
  return std::make_unique<StraightIn>(nominal);
}
