#include "sim/study/scripted_controller.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

// Of wheels and drum, as the docking controller has them (assumed, 0.1-1 and 1-5).
constexpr double kWheelAccelRadPerS2 = 0.3, kDrumAccelRadPerS2 = 2.0;
constexpr double kWinchSpeed = 0.05;  // of a winch whose speed the script leaves open [m/s]

class Scripted final : public Controller {
 public:
  Scripted(const RoverSheet& sheet, const std::vector<ScriptStep>& script)
      : sheet_(sheet), script_(script) {
    belief_.phase = "script";
  }

  Commands Step(const SensorFrame& sensed) override {
    Commands commands;
    double begun_s = 0.0;
    const double now_s = static_cast<double>(sensed.tick) * kTickSeconds;
    for (const ScriptStep& step : script_) {
      begun_s += step.for_s;
      if (now_s >= begun_s) continue;
      Play(step, commands);
      return commands;
    }
    commands.verdict = Verdict::kGivenUp;
    return commands;
  }

  const Belief& belief() const override { return belief_; }

 private:
  MotorCommand Run(Motor motor, double rad_s, double accel_rad_s2, double current_a) const {
    const MotorSheet& sheet = sheet_.motors[static_cast<std::size_t>(motor)];
    return {.mode = MotorMode::kVelocity,
            .target = rad_s,
            .accel_rad_s2 = accel_rad_s2,
            .current_limit_a = std::min(current_a, sheet.max_current_a)};
  }

  void Play(const ScriptStep& step, Commands& commands) const {
    for (const Motor motor : {Motor::kLeftWheel, Motor::kRightWheel}) {
      MotorCommand& command = commands.motors[static_cast<std::size_t>(motor)];
      if (step.free_wheels) {
        command.mode = MotorMode::kFree;
        continue;
      }
      const double side = motor == Motor::kLeftWheel ? -0.5 : 0.5;
      const double rim_m_s = step.speed_m_s + side * sheet_.track_m * step.turn_rad_s;
      command = Run(motor, rim_m_s / sheet_.wheel_radius_m, kWheelAccelRadPerS2,
                    sheet_.motors[static_cast<std::size_t>(motor)].max_current_a);
    }
    const bool open_speed = step.reel_m_s == 0.0;
    if (open_speed && !step.tension_n) return;  // braked
    const MotorSheet& spool = sheet_.motors[static_cast<std::size_t>(Motor::kSpool)];
    const double reel_m_s = open_speed ? kWinchSpeed : step.reel_m_s;
    const double current_a = step.tension_n ? spool.no_load_current_a + *step.tension_n *
                                                                            sheet_.drum_radius_m /
                                                                            spool.torque_per_amp_nm
                                            : spool.max_current_a;
    commands.motors[static_cast<std::size_t>(Motor::kSpool)] =
        Run(Motor::kSpool, reel_m_s / sheet_.drum_radius_m, kDrumAccelRadPerS2, current_a);
  }

  const RoverSheet sheet_;
  const std::vector<ScriptStep> script_;
  Belief belief_;
};

}  // namespace

std::unique_ptr<Controller> MakeScriptedController(const RoverSheet& sheet,
                                                   const std::vector<ScriptStep>& script) {
  return std::make_unique<Scripted>(sheet, script);
}

}  // namespace dockyard
