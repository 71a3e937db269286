// The control experiment of Tsai et al., V-C: no eyes, no wheels, only the spool.
#include <optional>

#include "controller/docking/axel.h"
#include "controller/docking/leg.h"
#include "controller/docking/options.h"
#include "controller/docking/senses.h"

namespace dockyard {
namespace {

class ReelOnly final : public Controller {
 public:
  explicit ReelOnly(const RoverSheet& sheet)
      : sheet_(sheet),
        senses_(sheet, options_),
        arm_(sheet, options_.arm),
        still_(options_.tether.still_m) {}

  Commands Step(const SensorFrame& sensed) override {
    senses_.Update(sensed);
    Commands commands;
    const Tick still = still_.Still(senses_.now(), senses_.reeled_m());
    // It cannot know how much tether is out: the end is where the spool stalls. In the socket's
    // end, or jammed on the way there: the experiment has no eyes to tell.
    if (still >= options_.mate.stuck_after) home_ = true;
    if (home_) {
      belief_.phase = "docked";
      commands.verdict = Verdict::kDocked;
    } else {
      belief_.phase = "reel";
      SetWheels(MotorMode::kFree, &commands);
      commands.motors[static_cast<std::size_t>(Motor::kSpool)] =
          Winch(sheet_, options_.tether.tighten_m_s, options_.tether.reel_tension_n,
                options_.tether.accel_rad_s2);
    }
    commands.motors[static_cast<std::size_t>(Motor::kArm)] = arm_.Hold(senses_);
    return WithinLimits(sheet_, commands);
  }

  const Belief& belief() const override { return belief_; }

 private:
  const RoverSheet sheet_;
  const AxelOptions options_{};
  Senses senses_;
  ArmLevel arm_;
  StillWatch still_;
  bool home_ = false;
  Belief belief_;
};

}  // namespace

std::unique_ptr<Controller> MakeReelOnlyController(const RoverSheet& sheet) {
  return std::make_unique<ReelOnly>(sheet);
}

}  // namespace dockyard
