// The judge of Rocky 7's runs: where the point is, and where the controller saw the target.
#pragma once

#include "sim/rocky7/last_touch.h"
#include "sim/rocky7/outcome.h"
#include "sim/rocky7/rocky7_columns.h"
#include "sim/rocky7/rocky7_plant.h"
#include "sim/rocky7/target_loss.h"
#include "sim/run/judge.h"

namespace dockyard::rocky7 {

class Rocky7Judge final : public Judge {
 public:
  /// The plant must outlive it.
  explicit Rocky7Judge(Rocky7Plant& plant);

  void Observe() override;
  void ObserveSighting(const SightingReport& report) override;
  void ObserveBelief(const Belief& belief) override;
  bool fatal() const override;
  Conclusion Conclude(const Commands& last, const Belief& belief, const TrialWatch& watch) override;

 private:
  /// Steps the plant under these commands.
  void Play(const Commands& commands, Tick time, const char* phase, const TrialWatch& watch);
  /// Whether the target was lost, and why. To be called before sighted_ counts this report.
  void JudgeLock(const SightingReport& report, bool right);
  /// Where and how the instrument touched the boulder.
  void JudgeContact(EndOfRun& found);
  /// The least rise of the lifted stone while it is held and driven with; stops once it has fallen.
  double TryToHold(const Commands& last, const TrialWatch& watch);

  OutcomeLimits limits_;
  Rocky7Plant& plant_;
  Rocky7Measures measures_;
  Pose2 X_GR_last_;
  bool lifted_ = false, sighted_ = false;
  LossRecord losses_;
  // The controller's belief of the target when it changed last: in R's plan as it was then, and in
  // the site's; and whether arm and mast had not yet been sent out.
  Eigen::Vector2d believed_R_{0, 0}, believed_G_{0, 0};
  bool approaches_ = true;
  LastTouch contact_;
};

}  // namespace dockyard::rocky7
