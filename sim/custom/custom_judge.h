// The judge: conditions that hold together for a time, then a trial, as the scenario asks.
#pragma once

#include "sim/custom/custom_plant.h"
#include "sim/custom/outcome.h"
#include "sim/run/judge.h"

namespace dockyard::custom {

class CustomJudge final : public Judge {
 public:
  /// The plant must outlive it.
  explicit CustomJudge(CustomPlant& plant);

  void Observe() override;
  void ObserveSighting(const SightingReport& /*report*/) override {}
  bool fatal() const override;
  Conclusion Conclude(const Commands& last, const Belief& belief, const TrialWatch& watch) override;

 private:
  /// Whether all conditions hold now.
  bool IsDocked() const;
  bool KeepsInTrial() const;
  /// Steps the plant under these commands; false: a condition was broken meanwhile.
  template <class Keeps>
  bool Play(const Commands& commands, double seconds, const char* phase, const TrialWatch& watch,
            const Keeps& keeps);
  /// @returns the first part in which what is asked does not hold; empty: it held
  std::string Try(const Commands& last, const TrialWatch& watch);
  Commands DriveAway(const Commands& last) const;

  CustomPlant& plant_;
  const JudgeKeys& keys_;
  CustomMeasures measures_;
  Pose2 X_GR_last_;
  bool was_closed_ = false;
};

}  // namespace dockyard::custom
