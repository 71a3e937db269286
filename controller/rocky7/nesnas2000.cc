#include "controller/rocky7/nesnas2000.h"

#include "controller/rocky7/mission.h"
#include "controller/rocky7/place_mission.h"
#include "controller/tracking/local_maximum.h"

namespace dockyard::rocky7 {
namespace {

// "The new target is the local elevation maximum" in a small window (N, IV). It has no way to tell
// that the target is gone, but that the window is empty.
class HighestPoint final : public TargetTracker {
 public:
  explicit HighestPoint(const NesnasTracking& with) : settings_{with.window_m} {}

  TargetSighting Begin(const GroundMaps& maps, const Clicked& clicked) override {
    return Find(maps, clicked.p_E);
  }
  TargetSighting Follow(const GroundMaps& maps, const Predicted& target) override {
    return Find(maps, {target.X_ET.x, target.X_ET.y});
  }

 private:
  TargetSighting Find(const GroundMaps& maps, const Eigen::Vector2d& p_E) const {
    const auto top = HighestInWindow(maps.fine, p_E, settings_);
    if (!top) return {.why = "no range data in the window"};
    return {.found = true, .p_E = top->p_E, .height_m = top->height_m};
  }

  LocalMaximumSettings settings_;
};

}  // namespace

std::unique_ptr<Controller> MakeNesnas2000Controller(const Nominal& nominal) {
  if (nominal.task == Task::kPlace) return MakeNesnas2000Placement(nominal);
  const ApproachOptions options{.front_end = nominal.nesnas.front_end,
                                .image_share = nominal.nesnas.image_share,
                                .least_step_m = nominal.nesnas.least_step_m};
  return std::make_unique<Mission>(nominal, std::make_unique<HighestPoint>(nominal.nesnas), options,
                                   MissionOptions{});
}

}  // namespace dockyard::rocky7
