#include "sim/raposa/raposa_judge.h"

#include <algorithm>
#include <cmath>

#include "sim/raposa/trial.h"

namespace dockyard::raposa {
namespace {

// After a claim: time to come to rest before the trial. Assumed, 0.5-3 s.
constexpr Tick kSettle = 1000;
// Doors that have come in by so much are closing. Assumed, 2-10 mm.
constexpr double kClosing_m = 0.003;

}  // namespace

void RaposaJudge::Observe() {
  const Truth& truth = plant_.truth();
  outcome_.Observe(truth);
  const double open_m = plant_.built().world.robot.doors.travel_m - kClosing_m;
  if (std::min(truth.left_door_m, truth.right_door_m) > open_m) {
    measures_.shift_before_doors_m =
        std::max(measures_.shift_before_doors_m, truth.pyramid_shift_m);
    measures_.turn_before_doors_deg =
        std::max(measures_.turn_before_doors_deg, Degrees(std::abs(truth.pyramid_turn_rad)));
  }
  for (const Motor belt : {Motor::kLeftBelt, Motor::kRightBelt}) {
    measures_.belt_current_peak_a = std::max(
        measures_.belt_current_peak_a, truth.motors[static_cast<std::size_t>(belt)].current_a);
  }
}

Conclusion RaposaJudge::Conclude(const Commands& last, const Belief& belief,
                                 const TrialWatch& watch) {
  if (last.verdict == Verdict::kDone) {
    for (Tick t = 0; t < kSettle; t += kControlPeriod) {
      plant_.RefreshTruth();
      Observe();
      watch("rest");
      plant_.Advance(last);
    }
  }
  plant_.RefreshTruth();
  Observe();
  const Truth end = plant_.truth();
  measures_.passes = ValueOf(belief, "passes", 0.0);
  measures_.range_m = end.range_m;
  measures_.alpha_deg = Degrees(end.alpha_rad);
  measures_.seat_m = end.p_SP_R.norm();
  measures_.contact_peak_n = end.contact_peak_n;
  Trial trial;
  if (last.verdict == Verdict::kDone && outcome_.holds()) {
    trial = TryToDriveAway(plant_.world(), plant_.built().world.robot, limits_, last,
                           [&](const Truth& now) {
                             plant_.TakeTruth(now);
                             watch("drive_away");
                           });
  }
  const OutcomeJudge::Verdicted verdict =
      outcome_.Conclude(last.verdict, trial, !std::isnan(ValueOf(belief, "state", std::nan(""))));
  return {Name(verdict.outcome), verdict.note, Values(measures_),
          outcome_.Limits(last.verdict, trial)};
}

}  // namespace dockyard::raposa
