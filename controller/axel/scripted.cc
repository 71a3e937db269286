#include "controller/axel/scripted.h"

#include "controller/axel/drive.h"
#include "controller/axel/options.h"
#include "controller/motion/limits.h"

namespace dockyard::axel {
namespace {

class Scripted final : public Controller {
 public:
  Scripted(const Nominal& nominal, const std::vector<ScriptStep>& script)
      : nominal_(nominal), script_(script) {
    belief_.phase = "script";
  }

  Commands Step(const SensorFrame& sensed) override {
    Commands commands = BrakedCommands();
    double begun_s = 0.0;
    const double now_s = static_cast<double>(sensed.tick) * kTickSeconds;
    for (const ScriptStep& step : script_) {
      begun_s += step.for_s;
      if (now_s >= begun_s) continue;
      Play(step, &commands);
      KeepLimits(nominal_.motors, &commands);
      return commands;
    }
    commands.verdict = Verdict::kGivenUp;
    return commands;
  }

  const Belief& belief() const override { return belief_; }

 private:
  void Play(const ScriptStep& step, Commands* commands) const {
    if (step.free_wheels) {
      SetWheels(MotorMode::kFree, commands);
    } else {
      CommandWheels(nominal_, {step.speed_m_s, step.turn_rad_s}, options_.drive.wheel_accel_rad_s2,
                    commands);
    }
    if (step.arm_rad) CommandArm(step, commands);
    const bool open_speed = step.reel_m_s == 0.0;
    if (open_speed && !step.tension_n) return;  // braked
    const NominalMotor& spool = nominal_.motors[static_cast<std::size_t>(Motor::kSpool)];
    const double strongest_n = TensionFromCurrent(nominal_, spool.max_current_a);
    commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
        Winch(nominal_, open_speed ? options_.tether.tighten_m_s : step.reel_m_s,
              step.tension_n.value_or(strongest_n), options_.tether.accel_rad_s2);
  }

  void CommandArm(const ScriptStep& step, Commands* commands) const {
    const NominalMotor& arm = nominal_.motors[static_cast<std::size_t>(Motor::kArm)];
    commands->motors[static_cast<std::size_t>(Motor::kArm)] = {
        .mode = MotorMode::kPosition,
        .target = *step.arm_rad - nominal_.arm_at_zero_rad,
        .speed_limit_rad_s = step.arm_speed_rad_s.value_or(arm.max_speed_rad_s),
        .accel_rad_s2 = options_.arm.accel_rad_s2,
        .current_limit_a = arm.max_current_a};
  }

  const Nominal nominal_;
  const std::vector<ScriptStep> script_;
  const AxelOptions options_{};  // accelerations and the winch's speed, as the docking controller's
  Belief belief_;
};

}  // namespace

std::unique_ptr<Controller> MakeScriptedController(const Nominal& nominal,
                                                   const std::vector<ScriptStep>& script) {
  return std::make_unique<Scripted>(nominal, script);
}

}  // namespace dockyard::axel
