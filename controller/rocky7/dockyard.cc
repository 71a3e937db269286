#include "controller/rocky7/dockyard.h"

#include "controller/rocky7/mission.h"
#include "controller/rocky7/place_mission.h"
#include "controller/rocky7/stone_tracker.h"

namespace dockyard::rocky7 {
namespace {

// Larger steps than the paper's, as the window follows from them. Assumed, 0.15-0.4.
constexpr ApproachOptions kOptions{.ground_as_body = true,
                                   .image_share = 0.25,
                                   .least_step_m = 0.06,
                                   .look_each_m = 0.12,  // assumed, 8-20 cm
                                   .claim_share = 0.7,   // assumed, 0.4-0.8: what is seen errs too
                                   // Slip assumed, 0.05-0.2.
                                   .odometry = {.turn_by_unit = true, .slip = 0.1, .drifts = true},
                                   .sees_motion = true,
                                   .exposes_for_target = true,
                                   .backs_up = true,
                                   .most_stalls = 3,  // assumed, 2-5
                                   // In sand uphill it goes on at a tenth of its speed. Assumed,
                                   // 80-400.
                                   .most_looks = 200,
                                   .blind_beyond_m = 0.25,  // assumed, 0.2-0.5
                                   .most_misses = 8};

// The arm rolls by 8 deg for it. Assumed, 1-4 cm.
constexpr double kArmAside_m = 0.03;
// Assumed, 1-5 tries.
constexpr MissionOptions kMission{.tries = 3, .inspects = true};

}  // namespace

std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal) {
  if (nominal.task == Task::kPlace) return MakeDockyardPlacement(nominal);
  ApproachOptions options = kOptions;
  if (nominal.task == Task::kGrasp) {
    options.arm_aside_m = kArmAside_m;
    options.claim_share = 1.0;  // scoops close over a stone that is 2 cm off (docs/rocky7.md)
  }
  return std::make_unique<Mission>(nominal, std::make_unique<StoneTracker>(), options, kMission);
}

}  // namespace dockyard::rocky7
