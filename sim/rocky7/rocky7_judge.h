// The judge of Rocky 7's runs: where the point is, and where the controller saw the target.
#pragma once

#include "sim/rocky7/outcome.h"
#include "sim/rocky7/rocky7_columns.h"
#include "sim/rocky7/rocky7_plant.h"
#include "sim/run/judge.h"

namespace dockyard::rocky7 {

class Rocky7Judge final : public Judge {
 public:
  /// The plant must outlive it.
  explicit Rocky7Judge(Rocky7Plant& plant);

  void Observe() override;
  void ObserveSighting(const SightingReport& report) override;
  bool fatal() const override;
  Conclusion Conclude(const Commands& last, const Belief& belief, const TrialWatch& watch) override;

 private:
  /// Steps the plant under these commands.
  void Play(const Commands& commands, Tick time, const char* phase, const TrialWatch& watch);
  /// Where and how the instrument touched the boulder.
  void JudgeContact(EndOfRun& found);
  /// The least rise of the lifted stone while it is held and driven with; stops once it has fallen.
  double TryToHold(const Commands& last, const TrialWatch& watch);

  OutcomeLimits limits_;
  Rocky7Plant& plant_;
  Rocky7Measures measures_;
  Pose2 X_GR_last_;
  bool lifted_ = false, sighted_ = false;
  /// The instrument's face when it was pressed most.
  struct Contact {
    double force_n = 0.0;
    Eigen::Vector3d p_GF{0, 0, 0}, axis_G{1, 0, 0};
  };
  Contact contact_;
};

}  // namespace dockyard::rocky7
