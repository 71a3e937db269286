// The control experiment of Tsai et al., V-C: no cameras, no wheels, only the spool.

#include "controller/axel/axel.h"
#include "controller/axel/leg.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"
#include "controller/motion/limits.h"

namespace dockyard::axel {
namespace {

class ReelOnly final : public Controller {
 public:
  explicit ReelOnly(const Nominal& nominal)
      : nominal_(nominal),
        senses_(nominal, options_),
        arm_(nominal, options_.arm),
        still_(options_.tether.still_m) {}

  Commands Step(const SensorFrame& sensed) override {
    senses_.Update(sensed);
    Commands commands = BrakedCommands();
    const Tick still = still_.Still(senses_.now(), senses_.reeled_m());
    // It cannot know how much tether is out, so it ends where the spool stalls. It cannot tell the
    // socket's end from a jam on the way there.
    if (still >= options_.mate.stuck_after) reeled_in_ = true;
    if (reeled_in_) {
      belief_.phase = "docked";
      commands.verdict = Verdict::kDone;
    } else {
      belief_.phase = "reel";
      SetWheels(MotorMode::kFree, &commands);
      commands.motors[static_cast<std::size_t>(Motor::kSpool)] =
          Winch(nominal_, options_.tether.tighten_m_s, options_.tether.reel_tension_n,
                options_.tether.accel_rad_s2);
    }
    commands.motors[static_cast<std::size_t>(Motor::kArm)] = arm_.Hold(senses_);
    KeepLimits(nominal_.motors, &commands);
    return commands;
  }

  const Belief& belief() const override { return belief_; }

 private:
  const Nominal nominal_;
  const AxelOptions options_{};
  Senses senses_;
  ArmLevel arm_;
  StillWatch still_;
  bool reeled_in_ = false;
  Belief belief_;
};

}  // namespace

std::unique_ptr<Controller> MakeReelOnlyController(const Nominal& nominal) {
  return std::make_unique<ReelOnly>(nominal);
}

}  // namespace dockyard::axel
