#include "sim/axel/axel_judge.h"

#include <algorithm>
#include <cmath>

#include "sim/axel/shake.h"

namespace dockyard::axel {
namespace {

constexpr Tick kSlowPeriod = 100;    // measures over the history: 10 Hz
constexpr Tick kSettleTicks = 2000;  // after a claim: time to come to rest before the shake

OutcomeLimits LimitsOf(const BuiltRun& built) {
  OutcomeLimits limits = LimitsOf(built.world.rover, built.world.station);
  limits.excursion_m = built.nominal.excursion_m;
  return limits;
}

}  // namespace

void EntryMeter::Add(double depth_m, double spool_current_a, double cone_force_n,
                     double entered_depth_m) {
  over_ = over_ || depth_m > entered_depth_m;
  if (over_ || depth_m < 0.0) return;
  current_sum_a_ += std::abs(spool_current_a);
  current_peak_a_ = std::max(current_peak_a_, std::abs(spool_current_a));
  force_peak_n_ = std::max(force_peak_n_, cone_force_n);
  ++count_;
}

void EntryMeter::Fill(AxelMeasures& measures) const {
  if (count_ == 0) return;
  measures.entry_current_mean_a = current_sum_a_ / count_;
  measures.entry_current_peak_a = current_peak_a_;
  measures.entry_force_peak_n = force_peak_n_;
}

AxelJudge::AxelJudge(AxelPlant& plant)
    : plant_(plant),
      limits_(LimitsOf(plant.built())),
      outcome_(plant.built().world.station, limits_) {}

void AxelJudge::Observe() {
  const Truth& truth = plant_.truth();
  outcome_.Observe(truth);
  for (int i = 0; i < 2; ++i) wheel_current_.Add(truth.motor_current_a[i]);
  spool_current_.Add(truth.motor_current_a[static_cast<int>(Motor::kSpool)]);
  measures_.tension_peak_n = std::max(measures_.tension_peak_n, truth.tether_tension_n);
  if (plant_.tick() % kSlowPeriod == 0) ObserveSlowly();
}

void AxelJudge::ObserveSlowly() {
  const Truth& truth = plant_.truth();
  const double arm_up_rad = std::asin(std::clamp(truth.X_WA.R(2, 0), -1.0, 1.0));
  measures_.arm_up_peak_deg = std::max(measures_.arm_up_peak_deg, Degrees(arm_up_rad));
  const double roll_rad = ToAxleAttitude(truth.X_WR.R).roll;
  roll_squares_ += roll_rad * roll_rad;
  ++samples_;
  entry_.Add(-truth.p_MT.x(), truth.motor_current_a[static_cast<int>(Motor::kSpool)],
             truth.cone_force_n, limits_.entered_depth_m);
  X_DR_last_ = AxleOnGround(truth.X_DR);
  if (!X_DR_first_) X_DR_first_ = X_DR_last_;
}

void AxelJudge::ObserveSighting(const SightingReport& report) {
  const Truth& truth = plant_.exposed_truth();
  const BuiltRun& built = plant_.built();
  const Pose3 X_RB = Inverse(truth.X_WR) * truth.X_WS * BoardInStation(built.world.station);
  const FiducialBoard& board = built.world.station.board;  // as many marks as are told
  outcome_.ObserveSighting(plant_.truth().time_s, JudgeSighting(report, X_RB, built.built_rig,
                                                                board, limits_, built.ripples));
}

AxelMeasures AxelJudge::FinalMeasures(const Belief& belief) const {
  const Truth& truth = plant_.truth();
  AxelMeasures measures = measures_;
  measures.recoveries = ValueOf(belief, "recoveries", 0.0);
  measures.rightings = ValueOf(belief, "rightings", 0.0);
  measures.flips = outcome_.flips();
  measures.farthest_m = outcome_.farthest_m();
  measures.tip_depth_m = -truth.p_MT.x();
  measures.lateral_error_m = std::hypot(truth.p_MT.y(), truth.p_MT.z());
  measures.yaw_error_deg = Degrees(WrapPi(AxleOnGround(truth.X_DR).heading - kPi));
  measures.station_shift_m = truth.station_shift_m;
  measures.station_sunk_m = truth.station_sunk_m;
  measures.cone_force_peak_n = truth.cone_force_peak_n;
  measures.rock_force_peak_n = truth.rock_force_peak_n;
  measures.spool_current_mean_a = spool_current_.mean();
  measures.spool_current_peak_a = spool_current_.peak;
  measures.wheel_current_mean_a = wheel_current_.mean();
  measures.wheel_current_peak_a = wheel_current_.peak;
  measures.roll_rms_deg =
      Degrees(std::sqrt(roll_squares_ / static_cast<double>(std::max(1L, samples_))));
  entry_.Fill(measures);
  if (X_DR_first_) {
    const Pose2 &from = *X_DR_first_, &to = X_DR_last_;
    measures.advance_m =
        std::cos(from.heading) * (to.x - from.x) + std::sin(from.heading) * (to.y - from.y);
    measures.turned_deg = Degrees(WrapPi(to.heading - from.heading));
  }
  return measures;
}

Conclusion AxelJudge::Conclude(const Commands& last, const Belief& belief,
                               const TrialWatch& watch) {
  if (last.verdict == Verdict::kDone) {
    for (Tick t = 0; t < kSettleTicks; t += kControlPeriod) {
      plant_.RefreshTruth();
      outcome_.Observe(plant_.truth());
      watch("rest");
      plant_.Advance(last);
    }
  }
  plant_.RefreshTruth();
  outcome_.Observe(plant_.truth());
  AxelMeasures measures = FinalMeasures(belief);
  ShakeResult shake;
  if (outcome_.entered_at_rest()) {
    const WorldSetup& world = plant_.built().world;
    shake = Shake(plant_.world(), world.rover, world.station, [&](const Truth& now) {
      plant_.TakeTruth(now);
      watch("shake");
    });
    measures.station_shake_m = shake.station_m;
  }
  const auto verdict =
      outcome_.Conclude(last.verdict, static_cast<int>(measures.recoveries), shake);
  return {Name(verdict.outcome), verdict.note, Values(measures), outcome_.Limits(shake)};
}

}  // namespace dockyard::axel
