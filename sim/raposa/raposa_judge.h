// The judge of RAPOSA's dockings. It watches the truth, measures, and tests a claim by driving
// away.
#pragma once

#include "sim/raposa/outcome.h"
#include "sim/raposa/raposa_columns.h"
#include "sim/raposa/raposa_plant.h"
#include "sim/run/judge.h"

namespace dockyard::raposa {

class RaposaJudge final : public Judge {
 public:
  /// The plant must outlive it.
  explicit RaposaJudge(RaposaPlant& plant) : plant_(plant), outcome_(limits_) {}

  void Observe() override;
  void ObserveSighting(const SightingReport&) override {}
  bool fatal() const override { return outcome_.fatal(); }
  Conclusion Conclude(const Commands& last, const Belief& belief, const TrialWatch& watch) override;

 private:
  const OutcomeLimits limits_;
  RaposaPlant& plant_;
  OutcomeJudge outcome_;
  RaposaMeasures measures_;  // those that grow over the run
};

}  // namespace dockyard::raposa
