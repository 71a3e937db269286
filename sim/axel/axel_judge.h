// The judge of Axel's dockings. It watches the truth, measures, and tests a claim by a shake.
#pragma once

#include <algorithm>
#include <optional>

#include "sim/axel/axel_columns.h"
#include "sim/axel/axel_plant.h"
#include "sim/axel/outcome.h"
#include "sim/run/judge.h"

namespace dockyard::axel {

/// Mean and peak of currents drawn while anything is driven.
struct CurrentMeter {
  double sum = 0.0, peak = 0.0;
  long count = 0;
  void Add(double current_a) {
    if (current_a > 0.0) {
      sum += current_a;
      ++count;
    }
    peak = std::max(peak, current_a);
  }
  double mean() const { return count ? sum / static_cast<double>(count) : 0.0; }
};

/// Spool current and peak force on the cone while the arm is reeled in, from the mouth to the depth
/// that counts as docked. The meter stops before the arm meets the socket's floor.
class EntryMeter {
 public:
  void Add(double depth_m, double spool_current_a, double cone_force_n, double entered_depth_m);
  /// Leaves NaN when the tip never passed the mouth.
  void Fill(AxelMeasures& measures) const;

 private:
  double current_sum_a_ = 0.0, current_peak_a_ = 0.0, force_peak_n_ = 0.0;
  int count_ = 0;
  bool over_ = false;
};

class AxelJudge final : public Judge {
 public:
  /// The plant must outlive it.
  explicit AxelJudge(AxelPlant& plant);

  void Observe() override;
  void ObserveSighting(const SightingReport& report) override;
  void ObserveLostImages() override { ++measures_.pairs_lost; }
  bool fatal() const override { return outcome_.fatal(); }
  Conclusion Conclude(const Commands& last, const Belief& belief, const TrialWatch& watch) override;

 private:
  void ObserveSlowly();
  AxelMeasures FinalMeasures(const Belief& belief) const;

  AxelPlant& plant_;
  const OutcomeLimits limits_;
  OutcomeJudge outcome_;
  CurrentMeter wheel_current_, spool_current_;
  EntryMeter entry_;
  AxelMeasures measures_;  // those that grow over the run
  double roll_squares_ = 0.0;
  long samples_ = 0;
  std::optional<Pose2> X_DR_first_;
  Pose2 X_DR_last_;
};

}  // namespace dockyard::axel
